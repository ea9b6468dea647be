#!/bin/sh
# Makes the meshes of this folder from their .geo files: needs gmsh and Python's meshio.
set -e
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
gmsh -2 -smooth 10 -bin ellipsoid.geo -format stl -o ellipsoid.stl
gmsh -2 -smooth 10 capsule.geo -format msh22 -o "$work/capsule.msh"
gmsh -2 -smooth 10 peanut.geo -format msh22 -o "$work/peanut.msh"
/usr/bin/env python3 - "$work" <<'PYTHON'
import sys
import meshio
import numpy as np

for name, ending in [("capsule", "ply"), ("peanut", "obj"), ("peanut", "off")]:
    mesh = meshio.read(f"{sys.argv[1]}/{name}.msh")
    used, triangles = np.unique(mesh.get_cells_type("triangle"), return_inverse=True)
    meshio.Mesh(mesh.points[used], [("triangle", triangles.reshape(-1, 3))]).write(f"{name}.{ending}", **({"binary": False} if ending == "ply" else {}))
PYTHON
