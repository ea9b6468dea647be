"""Lipid vesicles by the boundary element method, as VTK algorithms.

All classes vtkVesicle… of the C++ module are here and take their place in any pipeline of vtkmodules.
A few functions make scripts short:

    update(algorithm, time)     brings an algorithm up to date; errors become exceptions; numpy arrays
    times(algorithm)            the times that it offers
    read_mesh, write_mesh       .vtu .vtp .vtk .stl .ply .obj .off
    make_mesh, triangles        a mesh from numpy arrays, and its triangles as one

vesicle.rendering draws, with or without a screen. See help(vesicle.vtkVesicleStepper) and so on for
properties, units and defaults.
"""

from .VesicleFilters import *
from .meshes import make_mesh, read_mesh, triangles, write_mesh
from .pipeline import Error, times, update
