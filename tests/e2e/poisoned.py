"""The program ``tracksweep`` with a solver that some cases break: those of certain amplitudes, in mm, at any speed."""

import ctypes
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from app.serve import service
from app.serve.supervisor import _die_with
from worker.cli import main

KILLS, HANGS, HOLDS, FILLS = 0.11, 0.12, 0.13, 0.14
MEMORY_MB = 512


def hang() -> None:
    while True:
        time.sleep(60)


def hold() -> None:
    """Hang in compiled code, with Python's lock."""
    ctypes.PyDLL(None).pause()


def fill() -> None:
    """More than MEMORY_MB."""
    np.ones(2 * MEMORY_MB * 2**20 // 8)


DEEDS: dict[float, Callable[[], None]] = {
    KILLS: lambda: os.kill(os.getpid(), signal.SIGKILL),
    HANGS: hang,
    HOLDS: hold,
    FILLS: fill,
}


def poison() -> None:
    """Break the solver of this process."""
    solve = compute.solve

    def solve_or_not(cases: Sequence[Any], *rest: Any) -> Any:
        for case in cases:
            DEEDS.get(round(case.irregularity.amplitude * 1e3, 3), lambda: None)()
        return solve(cases, *rest)

    compute.solve = solve_or_not


def live_again_and_again() -> None:
    """Return in one child after another: each is a worker that need not load the solver anew."""
    this = os.getpid()
    while os.fork():
        os.wait()
    _die_with(this)


if __name__ == "__main__":
    service.PROGRAM = (sys.executable, "-m", "tests.e2e.poisoned")  # type: ignore[assignment]
    if sys.argv[1] == "worker":
        from solver.warm import warm
        from worker import compute, tasks  # noqa: F401

        warm()
        poison()
        live_again_and_again()
    main()
