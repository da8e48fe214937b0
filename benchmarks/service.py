"""Two workers beside one, and what the queue and the database add to the solver's time.

python -m benchmarks.service [--rounds N] [--realisations N]
"""

import argparse
import math
from typing import Any

from benchmarks.results import Result, publish
from benchmarks.served import Run, finish, served, submit
from solver.catalogue import TRACKS

STEPS_PER_PAD = (65, 67, 70, 75)  # of 1e-4 s: groups differ in speed, not in the length of a step
WARM = {"settle_s": 0.3, "window_s": 0.02, "time_step_s": 2e-4}
ONE_SECOND = {"settle_s": 0.3, "window_s": 0.95}

HOW = """A study of {groups} speeds with {realisations} realisations each, the article's mesh, {window} s of window
after {settle} s: cases of about a second of processor time. It is computed by `tracksweep serve` on an empty
folder, by one worker and by two, whose kernels are warm. *wall* is from the first case that began to the last that
was finished, by the database's clock; *solver* is the processor time of all cases, from claimed inputs to peaks.
`ratio_two_workers` is the wall time of one worker divided by that of two, medians over {rounds} round(s).
`overhead_percent` is what the wall time of one worker is above the solver's: claiming, heartbeats, writing peaks,
and whatever else the machine does."""


def study(realisations: int, numerics: dict[str, float]) -> dict[str, Any]:
    """Equal groups: as many cases of every speed."""
    spacing = TRACKS["crts2"].values.pad_spacing
    speeds = [math.ceil(3.6e6 * spacing / (steps * 1e-4)) / 1e6 for steps in STEPS_PER_PAD]
    band = {"min": 2.0, "max": 30.0}
    irregularity = {"kind": "spectrum", "wavelength_band_m": [band], "realisations": realisations}
    sweep = {"kind": "product", "speed_kmh": speeds, "irregularity": irregularity}
    return {"name": f"{realisations} realisations", "sweep": sweep, "numerics": numerics}


def measure(workers: int, realisations: int) -> Run:
    """Compute the study on a service of its own, once all workers are warm."""
    with served(workers) as url:
        for attempt in range(1, 10):
            warm = study(16, WARM | {"window_s": WARM["window_s"] + 0.002 * attempt})
            if finish(url, submit(url, warm)).workers == workers:
                return finish(url, submit(url, study(realisations, ONE_SECOND)))
    raise SystemExit("not every worker computes")


def run(rounds: int, realisations: int) -> Result:
    """Measure one worker and two in turns."""
    found: dict[int, list[Run]] = {1: [], 2: []}
    for _ in range(rounds):
        for workers, runs in found.items():
            runs.append(measure(workers, realisations))
    one, two = (sorted(runs, key=lambda run: run.wall_s)[rounds // 2] for runs in found.values())
    table = [["workers", "cases", "wall, s", "solver, s", "solver per case, s", "wall × workers ÷ solver"]]
    for workers, each in ((1, one), (2, two)):
        numbers = each.wall_s, each.cpu_s, each.cpu_s / each.cases, workers * each.wall_s / each.cpu_s
        table.append([str(workers), str(each.cases), *(f"{number:.4g}" for number in numbers)])
    values = {
        "ratio_two_workers": one.wall_s / two.wall_s,
        "overhead_percent": 100 * (one.wall_s / one.cpu_s - 1),
        "overhead_percent_two_workers": 100 * (2 * two.wall_s / two.cpu_s - 1),
        "solver_s_per_case": one.cpu_s / one.cases,
    }
    how = HOW.format(
        groups=len(STEPS_PER_PAD),
        realisations=realisations,
        window=ONE_SECOND["window_s"],
        settle=ONE_SECOND["settle_s"],
        rounds=rounds,
    )
    return Result(
        title="Workers, queue and database", how=how, command="python -m benchmarks.service", values=values, table=table
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--realisations", type=int, default=16, help="16 fill all lanes of two workers")
    options = parser.parse_args()
    publish("service", run(options.rounds, options.realisations))


if __name__ == "__main__":
    main()
