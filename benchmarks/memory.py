"""Memory of a solve, whatever the number of cases and of phases.

    python -m benchmarks.memory

Every figure is the largest resident size of a process of its own that solves cases eight at a time and keeps their
peaks, as a worker does.
"""

import resource
import subprocess
import sys
from dataclasses import replace

from benchmarks.article import article_case
from benchmarks.results import Result, publish

SOLVES = {  # cases, speed in km/h, slab, window in s
    "imports": (0, 350, "continuous", 0.1),
    "1_case": (1, 350, "continuous", 0.1),
    "8_cases": (8, 350, "continuous", 0.1),
    "64_cases": (64, 350, "continuous", 0.1),
    "8_cases_of_3_s": (8, 350, "continuous", 3.0),
    "8_cases_joints": (8, 350, "discontinuous", 0.1),
    "8_cases_147_phases": (8, 160, "continuous", 0.1),
    "8_cases_585_phases": (8, 40, "continuous", 0.1),
}

HOW = """The largest resident size of a process that solves cases of the article's mesh (0.3 s and a window), eight at a
time, and keeps their peaks. *imports* is what Python, NumPy, SciPy and Numba take with nothing solved; the last column
is what solving adds, compiled code included, which a process loads once."""


def largest_resident_mb() -> float:
    """Of this process, so far."""
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / 1e6


def solve_some(count: int, speed_kmh: float, slab: str, window: float) -> None:
    """Solve some cases and print what that took."""
    from solver.peaks import peaks  # noqa: PLC0415 - what is measured begins here
    from solver.simulate import Response, solve  # noqa: PLC0415

    case = article_case(speed_kmh, slab, settle=0.3, window=window)
    waves = [replace(case.irregularity, amplitude=1e-4 + 1e-6 * i) for i in range(count)]
    found = []
    for first in range(0, count, 8):
        for response in solve([replace(case, irregularity=wave) for wave in waves[first : first + 8]]):
            if not isinstance(response, Response):
                raise response
            found.append(peaks(response))
    print(largest_resident_mb())


def measured(name: str) -> float:
    """Megabytes of a process of its own."""
    command = [sys.executable, "-m", "benchmarks.memory", name]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)  # noqa: S603


def run() -> Result:
    """Solve in one process after another."""
    for name in ("1_case", "8_cases", "8_cases_joints"):
        measured(name)  # compiles, which takes memory of its own
    found = {name: measured(name) for name in SOLVES}
    nothing = found["imports"]
    table = [["solve", "MB", "MB above imports"]]
    table += [[name.replace("_", " "), f"{mb:.0f}", f"{mb - nothing:.0f}"] for name, mb in found.items()]
    return Result(
        title="Memory",
        how=HOW,
        command="python -m benchmarks.memory",
        values={f"memory_mb_{name}": mb for name, mb in found.items()},
        table=table,
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        solve_some(*SOLVES[sys.argv[1]])
    else:
        publish("memory", run())
