"""Running a scene."""

from __future__ import annotations

import contextlib
import json
import os
import pathlib
import tomllib
import typing

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .VesicleFilters import vtkVesicleSeriesWriter, vtkVesicleStepper
from .errors import Error, InputError
from .frames import Frame
from .meshes import polydata_of
from .pipeline import Messages, update
from .runs import Run, open_run
from .scenes import override_texts, toml_text
from .tables import Table, csv_line, table_of_rows
from .version import __version__

Scene = typing.Union[str, "os.PathLike[str]", typing.Mapping[str, typing.Any]]
Overrides = typing.Union[str, typing.Iterable[str], typing.Mapping[str, typing.Any]]


class Step:
    """An accepted step, as callbacks get it, in the units of the scene.

    number, time: of the step; the start is step 0
    diagnostics: a Table with the columns of the run's, a row a vesicle
    """

    def __init__(self, stepper: vtkVesicleStepper, diagnostics: Table) -> None:
        self._stepper = stepper
        self.diagnostics = diagnostics
        self.number = int(stepper.GetNumberOfSteps())
        self.time = float(stepper.GetStateTime())

    def __getitem__(self, name: str) -> float:
        """One of the diagnostics, of the first vesicle."""
        return float(self.diagnostics[name][0])

    @property
    def frame(self) -> Frame:
        """The surface; only while the callback has this step."""
        if self._stepper.GetNumberOfSteps() != self.number:
            raise InputError(f"step {self.number} is over; ask for its frame in the callback")
        surface = vtkPolyData()
        with Messages():
            self._stepper.CopyState(surface)
        return Frame(surface)


Callback = typing.Callable[[Step], typing.Any]


def run(scene: Scene, callback: Callback | None = None, overrides: Overrides | None = None,
        output: str | os.PathLike[str] | None = None, start: typing.Any = None) -> Run:
    """Simulates a scene to its end.

    scene: a TOML file; or TOML itself, a str with a line break; or the same as nested dicts. Files that
        the latter two name are looked for from the current folder.
    callback: called with a Step of the start and of every accepted step; one that returns True ends the
        run there.
    overrides: settings that replace the scene's: {"vesicle.triangles": 320}, or ["vesicle.triangles=320"]
    output: a folder, which must be new or empty; there will be the frames, the .csv and summary.json as
        `vesicle run` leaves them, written as the run goes on, for ParaView, vesicle.open_run and the
        command's info, compare and render. No checkpoint: such a run can't be resumed. None: all frames
        are kept in memory.
    start: a vtkPolyData (make_mesh, read_mesh) or a Frame that takes the place of the scene's start shape

    The numbers are those of `vesicle run`, bit for bit where OpenBLAS runs the same kernel: import vesicle
    before numpy. Returns a Run. Raises vesicle.Error; of a
    simulation that could not go on, its attribute `run` is the Run up to the last good state. Ctrl-C and
    exceptions of the callback end the run after the step and are raised; `output` then has all until there.
    """
    stepper = _stepper_of(scene, overrides, start)
    with Messages(stepper):
        stepper.UpdateInformation()
    settings = stepper.GetSettings()
    name = tomllib.loads(settings)["name"]
    record: _Memory = _Memory(name) if output is None else _Folder(name, pathlib.Path(output))
    message = ""
    try:
        stopped = _advance(stepper, record, callback)
        outcome = "interrupted" if stopped else _outcome(settings)
    except Error as error:
        if stepper.GetErrorCategory() != vtkVesicleStepper.NumericalFailure or not record.rows:
            raise
        message = str(error)
        outcome = "failed"
    except BaseException:
        if record.rows:
            _finish(stepper, record, "interrupted", "", settings)
        raise
    result = _finish(stepper, record, outcome, message, settings)
    if outcome == "failed":
        failure = Error(message)
        failure.run = result
        raise failure
    return result


def _stepper_of(scene: Scene, overrides: Overrides | None, start: typing.Any) -> vtkVesicleStepper:
    stepper = vtkVesicleStepper()
    stepper.SetCacheSize(1)  # it never goes back
    if isinstance(scene, typing.Mapping):
        stepper.SetSceneText(toml_text(scene))
    elif isinstance(scene, str) and "\n" in scene:
        stepper.SetSceneText(scene)
    else:
        stepper.SetSceneFileName(os.fspath(scene))
    for setting in override_texts(overrides):
        stepper.AddOverride(setting)
    if start is not None:
        stepper.SetInputData(polydata_of(start))
    return stepper


def _advance(stepper: vtkVesicleStepper, record: _Memory, callback: Callback | None) -> bool:
    """To the end; True if the callback ended it before. An exception in an observer would end the
    process: it is kept until the pipeline has returned."""
    ended = False
    raised: list[BaseException] = []

    def on_step(caller: typing.Any, event: str) -> None:
        nonlocal ended
        try:
            diagnostics = _diagnostics_of(stepper)
            record.add_step(diagnostics)
            answer = callback(Step(stepper, diagnostics)) if callback else None
            ended = isinstance(answer, (bool, numpy.bool_)) and bool(answer)
        except BaseException as error:
            raised.append(error)
        if ended or raised:
            stepper.SetAbortExecute(1)

    def advance_to(time: float) -> None:
        surface = update(stepper, time)
        if stepper.GetNumberOfSteps() == 0:
            on_step(stepper, "")
        if raised:
            raise raised[0]
        record.add_frame(Frame(surface))

    observer = stepper.AddObserver(vtkVesicleStepper.StepAcceptedEvent, on_step)
    try:
        advance_to(0)
        while not ended and not stepper.GetFinished():
            advance_to(stepper.GetNextOutputTime())
    finally:
        stepper.RemoveObserver(observer)
    return ended and not stepper.GetFinished()


def _diagnostics_of(stepper: vtkVesicleStepper) -> Table:
    table = stepper.GetDiagnosticsTable()
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    return Table({column.GetName(): vtk_to_numpy(column) for column in columns})


def _outcome(settings: str) -> str:
    return "steady" if tomllib.loads(settings)["time"]["end"] == "steady" else "finished"


def _finish(stepper: vtkVesicleStepper, record: _Memory, outcome: str, message: str,
            settings: str) -> Run:
    """The last state is always there, as a frame."""
    if record.last_time != stepper.GetStateTime():
        surface = vtkPolyData()
        with Messages():
            stepper.CopyState(surface)
        record.add_frame(Frame(surface))
    return record.finish(outcome, message, settings)


class _Memory:
    """A run as it grows."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.names: list[str] = []
        self.rows: list[list[float]] = []
        self.frames: list[Frame] = []
        self.last_time: float | None = None

    def add_step(self, diagnostics: Table) -> list[list[float]]:
        self.names = list(diagnostics)
        added = [list(diagnostics.row(i).values()) for i in range(diagnostics.rows)]
        self.rows += added
        return added

    def add_frame(self, frame: Frame) -> None:
        self.last_time = frame.time
        self.frames.append(frame)

    def finish(self, outcome: str, message: str, settings: str) -> Run:
        return Run(self.name, self.frames, table_of_rows(self.names, self.rows), outcome=outcome,
                   message=message, settings=settings)


class _Folder(_Memory):
    """The same on the disk."""

    def __init__(self, name: str, folder: pathlib.Path) -> None:
        super().__init__(name)
        with _naming(folder):
            if folder.exists() and any(folder.iterdir()):
                raise InputError(f"{folder}: the folder isn't empty; choose another one for output, or "
                                 "remove it")
        self.folder = folder
        self.writer = vtkVesicleSeriesWriter()
        self.writer.SetFileName(str(folder / f"{name}.pvd"))

    def add_step(self, diagnostics: Table) -> list[list[float]]:
        """Rows are in the file as soon as they are there."""
        first = not self.rows
        added = super().add_step(diagnostics)
        text = ",".join(self.names) + "\n" if first else ""
        self._write(self.folder / f"{self.name}.csv", text + "".join(map(csv_line, added)), "a")
        return added

    def add_frame(self, frame: Frame) -> None:
        self.last_time = frame.time
        self.writer.SetInputData(frame.surface)
        with Messages(self.writer):
            self.writer.Write()

    def finish(self, outcome: str, message: str, settings: str) -> Run:
        self.writer.SetInputData(None)
        last = self._last_rows()
        summary = {"name": self.name, "outcome": outcome, **({"message": message} if message else {}),
                   "steps": int(self._last("step")), "time": self._last("time"),
                   "final": last[0] if "vesicle" not in self.names else last,
                   "versions": {"vesicle": __version__}, "settings": settings}
        self._write(self.folder / "summary.json", json.dumps(summary, indent=2) + "\n", "w")
        return open_run(self.folder)

    def _last_rows(self) -> list[dict[str, float | None]]:
        """Of the last step, a row a vesicle; None where a value is undefined."""
        step = self.names.index("step")
        return [{name: value if value == value else None for name, value in zip(self.names, row)
                 if name != "vesicle"} for row in self.rows if row[step] == self._last("step")]

    def _last(self, name: str) -> float:
        return self.rows[-1][self.names.index(name)]

    def _write(self, file: pathlib.Path, text: str, mode: str) -> None:
        with _naming(file):
            file.parent.mkdir(parents=True, exist_ok=True)
            with open(file, mode, encoding="utf-8") as stream:
                stream.write(text)


@contextlib.contextmanager
def _naming(file: pathlib.Path) -> typing.Iterator[None]:
    try:
        yield
    except OSError as error:
        raise Error(f"{file}: {os.strerror(error.errno or 0)}") from None
