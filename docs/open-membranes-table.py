#!/usr/bin/env python3
"""Errors of the curvatures of open membranes, by vtkVesicleCurvatureFilter and by vtkCurvatures, as a table:

    PYTHONPATH=build/release/lib/python3/dist-packages python3 docs/open-membranes-table.py

Pieces of surfaces whose largest curvature is 1, on irregular triangles; see docs/filters.md.
"""
import numpy as np
import vesicle
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D, vtkFeatureEdges, vtkIdFilter
from vtkmodules.vtkFiltersGeneral import vtkCurvatures

JITTER = 0.2  # of the distance between points, along the surface


def cap(u, v):
    """A third of a sphere: u and v in a square that reaches 60° from the pole at its corners."""
    angle = np.hypot(u, v) * np.pi / 3 / np.sqrt(2)
    azimuth = np.arctan2(v, u)
    points = np.sin(angle) * np.cos(azimuth), np.sin(angle) * np.sin(azimuth), np.cos(angle)
    return points, np.ones_like(u), np.ones_like(u)


def cylinder(u, v):
    points = np.sin(u), v, np.cos(u)
    return points, np.full_like(u, 0.5), np.zeros_like(u)


def torus(u, v):
    """The outer side: the tube's radius 1, its circle's 2."""
    r = 2 + np.cos(u)
    points = r * np.sin(v / 2), np.sin(u), r * np.cos(v / 2)
    return points, 0.5 + np.cos(u) / r / 2, np.cos(u) / r


def saddle(u, v):
    g = 1 + u**2 + v**2
    z = (u**2 - v**2) / 2
    return (u, v, z), (u**2 - v**2) / (2 * g**1.5), -1 / g**2  # H = −[(1 + v²) z_uu + (1 + u²) z_vv]/2g^(3/2)


SURFACES = {"cap of a sphere": cap, "half of a cylinder": cylinder, "torus, outer part": torus, "saddle": saddle}


def mesh(surface, n, random):
    """n by n points of the square |u|, |v| ≤ 1, those inside jittered, and the exact H and K."""
    side = np.linspace(-1, 1, n)
    u, v = (a.ravel().copy() for a in np.meshgrid(side, side))
    inside = (abs(u) < 1) & (abs(v) < 1)
    for a in (u, v):
        a[inside] += JITTER * (side[1] - side[0]) * random.uniform(-1, 1, inside.sum())
    flat = vtkPolyData()
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.column_stack([u, v, np.zeros_like(u)]), deep=True))
    flat.SetPoints(points)
    delaunay = vtkDelaunay2D()
    delaunay.SetInputData(flat)
    delaunay.Update()
    places, h, k = surface(u, v)
    result = vtkPolyData()
    result.DeepCopy(delaunay.GetOutput())
    result.GetPoints().SetData(numpy_to_vtk(np.column_stack(places), deep=True))
    return result, h, k


def rings(surface):
    """How many edges each point is from the border: 0, 1, 2 or more (2)."""
    ids = vtkIdFilter()
    ids.SetInputData(surface)
    ids.CellIdsOff()
    ids.SetPointIdsArrayName("id")
    edges = vtkFeatureEdges()
    edges.SetInputConnection(ids.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    ring = np.full(surface.GetNumberOfPoints(), 2)
    ring[vtk_to_numpy(edges.GetOutput().GetPointData().GetArray("id"))] = 0
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    near = np.unique(triangles[(ring[triangles] == 0).any(axis=1)])
    ring[near[ring[near] != 0]] = 1
    return ring


def ours(surface):
    curvature = vesicle.vtkVesicleCurvatureFilter()
    curvature.SetInputData(surface)
    curvature.BendingForceOff()
    curvature.Update()
    arrays = curvature.GetOutput().GetPointData()
    valid = vtk_to_numpy(arrays.GetArray("Curvature_Valid")) != 0
    return [np.where(valid, vtk_to_numpy(arrays.GetArray(name)), np.nan)
            for name in ("Mean_Curvature", "Gauss_Curvature")]


def vtks(surface):
    values = []
    for kind, name in (("Mean", "Mean_Curvature"), ("Gaussian", "Gauss_Curvature")):
        curvatures = vtkCurvatures()
        getattr(curvatures, f"SetCurvatureTypeTo{kind}")()
        curvatures.SetInputData(surface)
        curvatures.Update()
        values.append(vtk_to_numpy(curvatures.GetOutput().GetPointData().GetArray(name)))
    return values


def typical(error):
    """Root mean square of those that have a value."""
    known = np.isfinite(error)
    return f"{np.sqrt(np.mean(error[known]**2)):.1e}" if known.any() else "undefined"


print("| surface | points | from the border | H: filter | `vtkCurvatures` | K: filter | `vtkCurvatures` |")
print("|---|---|---|---|---|---|---|")
random = np.random.default_rng(1)
for title, surface in SURFACES.items():
    for n in (21, 41):
        data, h, k = mesh(surface, n, random)
        ring = rings(data)
        found, theirs = ours(data), vtks(data)
        sign = np.sign(np.nansum(found[0] * h))  # which side counts as outside
        for place, where in ((0, "on it"), (1, "one edge"), (2, "farther")):
            at = ring == place
            row = [typical((sign * found[0] - h)[at]), typical((abs(theirs[0]) - abs(h))[at]),
                   typical((found[1] - k)[at]), typical((theirs[1] - k)[at])]
            head = f"{title if n == 21 and place == 0 else ''} | {n * n if place == 0 else ''}"
            print(f"| {head} | {where} | " + " | ".join(row) + " |")
