"""A worker whose solver sleeps, and gives peaks that are made up: what is left is the queue.

python -m benchmarks.sleeper SECONDS
"""

import random
import sys
import time
from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any

import worker.compute
from benchmarks.million import peaks_of
from worker.cli import program

OF_CASE = ("case_id", "speed_kmh", "percentile")  # which whoever writes them down adds
CASE = {"id": 0, "speed_kmh": 300.0, "percentile": None, "amplitude_mm": 0.3, "slab": "continuous"}
BEATS = 10  # progress told per batch


def solve_by_sleeping(seconds: float) -> Callable[[Sequence[Any], Callable[[float], None]], Sequence[Any]]:
    """In place of ``solver.simulate.solve``."""

    def solve(cases: Sequence[Any], tell: Callable[[float], None]) -> Sequence[Any]:
        for n in range(BEATS):
            time.sleep(seconds / BEATS)
            tell((n + 1) / BEATS)
        return [SimpleNamespace(case=case) for case in cases]

    return solve


def made_up(_: Any) -> list[dict[str, Any]]:
    """In place of ``solver.peaks.peaks``: as many rows as any case has."""
    return [{name: v for name, v in row.items() if name not in OF_CASE} for row in peaks_of(random.Random(), CASE)]  # noqa: S311


def main() -> None:
    """Be that worker."""
    replaced = {
        "solve": solve_by_sleeping(float(sys.argv[1])),
        "peaks": made_up,
        "peak_at_boundary": lambda row: row,
        "processing": lambda _: {},
    }
    for name, stand_in in replaced.items():
        setattr(worker.compute, name, stand_in)
    program(["worker"])


if __name__ == "__main__":
    main()
