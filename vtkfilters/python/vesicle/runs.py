"""A run and what it leaves: frames and diagnostics."""

from __future__ import annotations

import json
import os
import pathlib
import tomllib
import typing

from .errors import Error
from .frames import Frame, FrameFiles, states_of
from .tables import Table, read_table


class Run:
    """The frames of a simulation and the table of its steps, in the units of its scene. Iterating over
    it gives the frames: the start, multiples of the scene's output_every, the end.

    name: the scene's
    frames: a sequence of Frame; of a folder's run each is read when it is asked for
    diagnostics: a Table, a row an accepted step (with several vesicles: a step and vesicle), the start
        first; docs/files.md lists the columns
    outcome: "finished", "steady", "interrupted" (Ctrl-C, or a callback ended it), "failed", or "running"
        of a folder without a summary: under way, or killed
    message: why, where there is something to say
    folder: where it is on the disk; None: nowhere
    settings: the scene as TOML, every setting spelled out; "" while it is "running"
    """

    def __init__(self, name: str, frames: typing.Sequence[Frame], diagnostics: Table, *, outcome: str,
                 message: str = "", folder: pathlib.Path | None = None, settings: str = "") -> None:
        self.name = name
        self.frames = frames
        self.diagnostics = diagnostics
        self.outcome = outcome
        self.message = message
        self.folder = folder
        self.settings = settings

    @property
    def scene(self) -> dict[str, typing.Any]:
        """The settings as nested dicts; can be changed and given to vesicle.run."""
        return tomllib.loads(self.settings)

    @property
    def states(self) -> Table:
        """What the frames know of themselves as a whole, a row a frame: TimeValue, Area, Volume, …"""
        return states_of(self.frames)

    def __iter__(self) -> typing.Iterator[Frame]:
        return iter(self.frames)

    def __len__(self) -> int:
        return len(self.frames)

    @typing.overload
    def __getitem__(self, number: int) -> Frame: ...
    @typing.overload
    def __getitem__(self, number: slice) -> typing.Sequence[Frame]: ...

    def __getitem__(self, number: int | slice) -> Frame | typing.Sequence[Frame]:
        return self.frames[number]

    def __repr__(self) -> str:
        return (f"<Run {self.name!r}, {self.outcome}: {len(self)} frames, "
                f"{self.diagnostics.rows} rows of diagnostics>")


def open_run(folder: str | os.PathLike[str]) -> Run:
    """The run in a folder that `vesicle run` or `vesicle.run` wrote to, also while it goes on: what is
    there now. A series NAME.vtu.series names one of several in a folder. Raises vesicle.Error."""
    series = _series_in(pathlib.Path(folder))
    name = series.name.removesuffix(".vtu.series")
    summary = _summary(series.parent / "summary.json")
    if summary.get("name") != name:
        summary = {}
    return Run(name, FrameFiles(series), read_table(series.parent / f"{name}.csv"),
               outcome=summary.get("outcome", "running"), message=summary.get("message", ""),
               folder=series.parent, settings=summary.get("settings", ""))


def _series_in(path: pathlib.Path) -> pathlib.Path:
    if path.name.endswith(".vtu.series"):
        return path
    if not path.is_dir():
        raise Error(f"{path}: there is no such folder; give the one that a run wrote to")
    found = sorted(path.glob("*.vtu.series"))
    if not found:
        raise Error(f"{path}: there is no run in this folder, that is no NAME.vtu.series")
    if len(found) > 1:
        raise Error(f"{path}: there are several runs in this folder; give one of "
                    + ", ".join(str(file) for file in found))
    return found[0]


def _summary(file: pathlib.Path) -> dict[str, typing.Any]:
    if not file.exists():
        return {}
    try:
        return dict(json.loads(file.read_text(encoding="utf-8")))
    except (OSError, ValueError) as error:
        raise Error(f"{file}: can't be read: {error}") from None
