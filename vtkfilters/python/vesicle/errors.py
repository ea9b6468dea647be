"""What the package raises."""

from __future__ import annotations

import typing

if typing.TYPE_CHECKING:
    from .runs import Run


class Error(RuntimeError):
    """What an algorithm, a file, a scene or a simulation failed with: what, where, and what to try.

    run: of a simulation that could not go on, the Run up to its last good state; otherwise None.
    """

    run: Run | None = None


class InputError(Error, ValueError):
    """An argument that can't be used: arrays that are no mesh, a name that isn't there."""
