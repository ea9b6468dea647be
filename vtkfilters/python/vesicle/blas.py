"""The kernel that OpenBLAS runs, chosen before it is loaded."""

from __future__ import annotations

import os
import pathlib


def choose_kernel() -> None:
    """Debian's OpenBLAS 0.3.21 doesn't know recent processors and falls back to SSE. As solver/linear/Blas.h
    does for the command, this sets OPENBLAS_CORETYPE by the processor's flags, so that speed and rounding are
    the command's. It does nothing where the variable is set, and is too late where OpenBLAS is loaded
    already, by numpy: import vesicle first."""
    if "OPENBLAS_CORETYPE" in os.environ:
        return
    kernel = _kernel(_text("/proc/cpuinfo"))
    if kernel and "openblas" not in _text("/proc/self/maps"):
        os.environ["OPENBLAS_CORETYPE"] = kernel


def _kernel(processor: str) -> str | None:
    """None: OpenBLAS knows best."""
    words = set(processor.split())
    if words >= {"avx512f", "avx512dq", "avx512bw", "avx512vl"}:
        return "SKYLAKEX"
    if words >= {"GenuineIntel", "avx2", "fma"}:
        return "HASWELL"
    return None


def _text(file: str) -> str:
    try:
        return pathlib.Path(file).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""
