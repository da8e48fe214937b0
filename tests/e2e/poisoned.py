"""The program ``tracksweep`` with a solver that some cases break: those of certain amplitudes, in mm, at any speed."""

import ctypes
import os
import signal
import sys
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

KILLS, HANGS, HOLDS, FILLS = 0.11, 0.12, 0.13, 0.14


def hang() -> None:
    while True:
        time.sleep(60)


def hold() -> None:
    """Hang in compiled code, with Python's lock."""
    ctypes.PyDLL(None).pause()


def fill() -> None:
    np.ones(2**40 // 8)


DEEDS: dict[float, Callable[[], None]] = {
    KILLS: lambda: os.kill(os.getpid(), signal.SIGKILL),
    HANGS: hang,
    HOLDS: hold,
    FILLS: fill,
}


def poison() -> None:
    """Break the solver of this process."""
    from worker import compute  # noqa: PLC0415

    solve = compute.solve

    def solve_or_not(cases: Sequence[Any], *rest: Any) -> Any:
        for case in cases:
            DEEDS.get(round(case.irregularity.amplitude * 1e3, 3), lambda: None)()
        return solve(cases, *rest)

    compute.solve = solve_or_not


if __name__ == "__main__":
    from app.serve import service
    from worker.cli import main

    service.PROGRAM = (sys.executable, "-m", "tests.e2e.poisoned")  # type: ignore[assignment]
    if sys.argv[1] == "worker":
        poison()
    main()
