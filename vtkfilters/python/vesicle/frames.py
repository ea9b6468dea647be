"""Surfaces at a moment, as numpy arrays, and series of them."""

from __future__ import annotations

import collections.abc
import json
import os
import pathlib
import typing

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkFieldData

from .errors import Error
from .meshes import polydata_of, read_mesh, triangles
from .tables import Table, table_of_rows


class Frame:
    """A surface at a moment, in the units of its scene. The arrays lie on VTK's memory, the frame's own.

    surface: the vtkPolyData itself, for pipelines, write_mesh, pyvista.wrap
    """

    def __init__(self, surface: typing.Any) -> None:
        self.surface = polydata_of(surface)

    @property
    def time(self) -> float:
        """The field data TimeValue; NaN of a surface that has none."""
        return float(self.field.get("TimeValue", numpy.nan))

    @property
    def points(self) -> numpy.ndarray:
        """n × 3, a length."""
        points = self.surface.GetPoints()
        return vtk_to_numpy(points.GetData()) if points else numpy.empty((0, 3))

    @property
    def triangles(self) -> numpy.ndarray:
        """m × 3 numbers of points from 0, counter-clockwise seen from outside."""
        return triangles(self.surface)

    @property
    def arrays(self) -> dict[str, numpy.ndarray]:
        """Point arrays by name, n or n × components; docs/files.md lists them with their signs."""
        return _arrays(self.surface.GetPointData())

    @property
    def cell_arrays(self) -> dict[str, numpy.ndarray]:
        """Likewise of the triangles, m or m × components."""
        return _arrays(self.surface.GetCellData())

    @property
    def field(self) -> dict[str, typing.Any]:
        """Numbers of the frame as a whole, Area, Volume, …: floats, or arrays where there are several."""
        return {name: float(values[0]) if values.shape == (1,) else values
                for name, values in _arrays(self.surface.GetFieldData()).items()}

    def __getitem__(self, name: str) -> numpy.ndarray:
        """The point array of this name."""
        array = self.surface.GetPointData().GetArray(name)
        if array is None:
            raise KeyError(f"{name!r}; there are: {', '.join(self.arrays) or 'none'}")
        return vtk_to_numpy(array)

    def __repr__(self) -> str:
        return (f"<Frame at t = {self.time:g}: {self.surface.GetNumberOfPoints()} points, "
                f"{self.surface.GetNumberOfPolys()} triangles; {', '.join(self.arrays)}>")


class FrameFiles(collections.abc.Sequence):
    """The frames that a .vtu.series file lists, read when they are asked for."""

    def __init__(self, series: pathlib.Path) -> None:
        self._files = _listed(series)

    def __len__(self) -> int:
        return len(self._files)

    @typing.overload
    def __getitem__(self, number: int) -> Frame: ...
    @typing.overload
    def __getitem__(self, number: slice) -> list[Frame]: ...

    def __getitem__(self, number: int | slice) -> Frame | list[Frame]:
        if isinstance(number, slice):
            return [Frame(read_mesh(file)) for file in self._files[number]]
        return Frame(read_mesh(self._files[number]))


def states_of(frames: typing.Iterable[Frame]) -> Table:
    """The single numbers of frames, a row a frame: TimeValue, Area, Volume, … Those that not all
    have are left out."""
    rows = [{name: value for name, value in frame.field.items() if isinstance(value, float)}
            for frame in frames]
    names = [name for name in (rows[0] if rows else {}) if all(name in row for row in rows)]
    return table_of_rows(names, [[row[name] for name in names] for row in rows])


def _listed(series: pathlib.Path) -> list[pathlib.Path]:
    try:
        entries = json.loads(series.read_text(encoding="utf-8"))["files"]
        return [series.parent / entry["name"] for entry in entries]
    except OSError as error:
        raise Error(f"{series}: can't be read: {os.strerror(error.errno or 0)}") from None
    except (ValueError, KeyError, TypeError) as error:
        raise Error(f"{series}: is no list of a run's frames: {error!r}") from None


def _arrays(data: vtkFieldData) -> dict[str, numpy.ndarray]:
    """Those that are numbers and have a name."""
    found = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in found if array and array.GetName()}
