"""Running VTK pipelines: what VTK prints becomes exceptions and warnings, data come out as numpy."""

from __future__ import annotations

import contextlib
import signal
import threading
import types
import typing
import warnings

from vtkmodules.numpy_interface import dataset_adapter
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .errors import Error


def update(algorithm: typing.Any, time: float | None = None) -> typing.Any:
    """Brings an algorithm, and what is before it in the pipeline, up to date.

    time: the time asked for; None: whatever the pipeline has.
    Returns a copy of the output, which stays what it is whatever the algorithm does next, wrapped by
    vtkmodules.numpy_interface.dataset_adapter: Points, PointData["…"], CellData["…"] and FieldData["…"]
    are numpy arrays; PointData.append(array, name) adds one; VTKObject is the vtkPolyData itself.
    Raises Error with the first error of any algorithm, whose output is then not to be used, but for
    the last good state that vtkVesicleStepper has when no step can be made. Ctrl-C ends a simulation after
    the step that it is at, and the next update goes on from there. Warnings of VTK become RuntimeWarnings.
    """
    with Messages(algorithm), _interruptible(algorithm):
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
    output = algorithm.GetOutputDataObject(0)
    copy = output.NewInstance()
    copy.DeepCopy(output)
    return dataset_adapter.WrapDataObject(copy)


def times(algorithm: typing.Any) -> tuple[float, ...]:
    """The times that an algorithm offers (TIME_STEPS), a tuple; empty where it offers none."""
    with Messages(algorithm):
        algorithm.UpdateInformation()
    information = algorithm.GetOutputInformation(0)
    return information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()


class Messages:
    """Within `with Messages():` VTK prints nothing. At the end warnings are issued with Python's
    warnings.warn (RuntimeWarning), and the first error, if there was one, is raised. The algorithm then
    counts as modified: VTK wouldn't ask it for its information, and so for the error, again."""

    def __init__(self, algorithm: typing.Any = None) -> None:
        self._algorithm = algorithm

    def __enter__(self) -> Messages:
        self._errors: list[str] = []
        self._warnings: list[str] = []
        self._before = vtkOutputWindow.GetInstance()
        self._verbosity = vtkLogger.GetCurrentVerbosityCutoff()
        window = vtkOutputWindow()
        window.SetDisplayModeToNever()
        window.AddObserver("ErrorEvent", _collector(self._errors))
        window.AddObserver("WarningEvent", _collector(self._warnings))
        vtkOutputWindow.SetInstance(window)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # it prints errors a second time
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None,
                 traceback: types.TracebackType | None) -> None:
        vtkOutputWindow.SetInstance(self._before)
        vtkLogger.SetStderrVerbosity(self._verbosity)
        for text in self._warnings:
            warnings.warn(text, RuntimeWarning, stacklevel=3)
        if self._errors and self._algorithm:
            self._algorithm.Modified()
        if self._errors and kind is None:
            raise Error(self._errors[0])


@contextlib.contextmanager
def _interruptible(algorithm: typing.Any) -> typing.Iterator[None]:
    """Python handles signals only between its own instructions, and an exception in an observer would
    end the process: so observers let the signal in, and its handler aborts the pipeline."""
    in_charge = (threading.current_thread() is threading.main_thread() and
                 signal.getsignal(signal.SIGINT) is signal.default_int_handler)
    if not in_charge:
        yield
        return
    pipeline = _pipeline(algorithm)
    observers = [(member, member.AddObserver("ProgressEvent", lambda caller, event: None))
                 for member in pipeline]
    interrupted = False

    def interrupt(number: int, frame: types.FrameType | None) -> None:
        nonlocal interrupted
        interrupted = True
        for member in pipeline:
            member.SetAbortExecute(1)

    signal.signal(signal.SIGINT, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        for member, observer in observers:
            member.RemoveObserver(observer)
    if interrupted:
        for member in pipeline:
            member.Modified()  # what it has isn't what was asked for
        raise KeyboardInterrupt


def _pipeline(algorithm: typing.Any) -> list[typing.Any]:
    """The algorithm and all before it."""
    found = [algorithm]
    for member in found:
        for port in range(member.GetNumberOfInputPorts()):
            for connection in range(member.GetNumberOfInputConnections(port)):
                before = member.GetInputAlgorithm(port, connection)
                if before not in found:
                    found.append(before)
    return found


def _collector(texts: list[str]) -> typing.Any:
    def collect(window: typing.Any, event: str, text: str) -> None:
        texts.append(_what_happened(text))

    collect.CallDataType = "string0"  # type: ignore[attr-defined]
    return collect


def _what_happened(text: str) -> str:
    """'ERROR: In file, line 12\\nvtkClass (0x55…): what happened\\n\\n' without what only a debugger
    needs."""
    return text.split("): ", 1)[-1].strip()
