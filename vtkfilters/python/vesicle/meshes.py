"""Meshes from and to files and numpy arrays."""

from __future__ import annotations

import os
import typing

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .VesicleFilters import vtkVesicleMeshReader, vtkVesicleMeshWriter
from .errors import InputError
from .pipeline import Messages


def polydata_of(surface: typing.Any) -> vtkPolyData:
    """The vtkPolyData in what dataset_adapter wraps, in a Frame, or itself."""
    return getattr(surface, "VTKObject", getattr(surface, "surface", surface))


def read_mesh(file: str | os.PathLike[str]) -> vtkPolyData:
    """The surface in a .vtu .vtp .vtk .stl .ply .obj .off or .msh file, as triangles: a vtkPolyData.
    Raises vesicle.Error."""
    reader = vtkVesicleMeshReader()
    reader.SetFileName(os.fspath(file))
    with Messages():
        reader.Update()
    return reader.GetOutput()


def write_mesh(surface: typing.Any, file: str | os.PathLike[str]) -> None:
    """Writes a vtkPolyData, as it is, wrapped as `update` gives it, or a Frame, by the file's ending; .vtu,
    .vtp and .vtk keep the arrays. Raises vesicle.Error."""
    writer = vtkVesicleMeshWriter()
    writer.SetFileName(os.fspath(file))
    writer.SetInputData(polydata_of(surface))
    with Messages():
        writer.Write()


def make_mesh(points: typing.Any, triangles: typing.Any) -> vtkPolyData:
    """A vtkPolyData of n points (array n × 3) and m triangles (array m × 3 of point numbers from 0,
    counter-clockwise seen from outside). Copies both; points are kept in double precision. Raises
    vesicle.InputError for coordinates that aren't finite and for points that aren't there."""
    points = numpy.ascontiguousarray(points, dtype=numpy.float64)
    numbers = numpy.asarray(triangles)
    if numbers.size and not numpy.issubdtype(numbers.dtype, numpy.integer):
        raise InputError(f"triangles must be integers, the numbers of points, not {numbers.dtype}")
    triangles = numpy.ascontiguousarray(numbers, dtype=numpy.int64)
    if points.ndim != 2 or points.shape[1] != 3 or triangles.ndim != 2 or triangles.shape[1] != 3:
        raise InputError(f"points and triangles must have 3 columns, not shapes {points.shape} "
                         f"and {triangles.shape}")
    if not numpy.isfinite(points).all():
        bad = int(numpy.flatnonzero(~numpy.isfinite(points).all(axis=1))[0])
        raise InputError(f"point {bad} is {tuple(points[bad])}: coordinates must be finite numbers")
    if triangles.size and not (0 <= triangles.min() and triangles.max() < len(points)):
        raise InputError(f"triangles name points {triangles.min()} to {triangles.max()}, but there "
                         f"are {len(points)}, counted from 0")
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    offsets = numpy.arange(0, triangles.size + 1, 3, dtype=numpy.int64)
    cells.SetData(numpy_to_vtk(offsets, deep=True), numpy_to_vtk(triangles.ravel(), deep=True))
    surface = vtkPolyData()
    surface.SetPoints(vtk_points)
    surface.SetPolys(cells)
    return surface


def triangles(surface: typing.Any) -> numpy.ndarray:
    """The triangles of a vtkPolyData, a wrapped one or a Frame: an array m × 3 of point numbers. Raises
    vesicle.InputError where there are other polygons (vtkTriangleFilter cuts them)."""
    polygons = polydata_of(surface).GetPolys()
    corners = vtk_to_numpy(polygons.GetConnectivityArray())
    if polygons.IsHomogeneous() not in (0, 3):
        raise InputError("the surface has polygons other than triangles; use vtkTriangleFilter first")
    return corners.reshape(-1, 3)
