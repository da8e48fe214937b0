"""What a coarser step, mesh or integrator or a shorter track would save, and what it would cost in the peaks.

python -m benchmarks.choices
"""

import time
from dataclasses import replace
from typing import Any

from benchmarks.article import WAVE, article_case
from benchmarks.results import Result, publish
from solver.case import Spectral
from solver.peaks import peaks
from solver.simulate import Response, solve
from solver.warm import warm

FINEST = {"elements_per_pad": 24, "time_step": 2.5e-5, "track_length": 200.0}
CHOICES: dict[str, dict[str, Any]] = {
    "as it is": {},
    "step 2e-4 s": {"time_step": 2e-4},
    "step 5e-5 s": {"time_step": 5e-5},
    "6 elements per pad": {"elements_per_pad": 6},
    "24 elements per pad": {"elements_per_pad": 24},
    "100 m of track": {"track_length": 100.0},
    "200 m of track": {"track_length": 200.0},
    "spectral radius 0.5": {"spectral_radius": 0.5},
    "spectral radius 0.95": {"spectral_radius": 0.95},
    "step 2e-4 s, spectral radius 0.95": {"time_step": 2e-4, "spectral_radius": 0.95},
}
WAVES = {"sine": WAVE, "random": Spectral(wavelength_min=1.0, wavelength_max=30.0)}
COMPARED = {"force": "wheel_rail_force", "rail": "rail_acceleration", "slab": "slab_acceleration"}

HOW = """Two jointed cases at 350 km/h, each alone, 0.5 s of window: the article's sine, and its spectrum from 1 to
30 m. *CPU s* is processor time of both solves; the other columns are how far the peaks of force, rail and slab
acceleration under the first wheelset are from those of the finest (24 elements per pad, steps of 2.5e-5 s, 200 m).
`docs/decisions/0006-where-the-speed-comes-from.md` draws the conclusions."""


def solved(**numerics: Any) -> tuple[float, dict[str, float]]:
    """Processor time and peaks."""
    case = article_case(slab="discontinuous", settle=0.6, window=0.5, **numerics)
    began, found = time.process_time(), {}
    for name, wave in WAVES.items():
        response = solve([replace(case, irregularity=wave)])[0]
        if not isinstance(response, Response):
            raise response
        largest = {peak.quantity: peak.peak for peak in peaks(response) if peak.position == "wheelset_1"}
        found |= {f"{short}, {name}": largest[quantity] for short, quantity in COMPARED.items()}
    return time.process_time() - began, found


def run() -> Result:
    """Compare every choice with the finest."""
    warm()
    _, exact = solved(**FINEST)
    table = [["choice", "CPU s", *exact]]
    values = {}
    for name, numerics in CHOICES.items():
        seconds, found = solved(**numerics)
        differences = {key: found[key] / exact[key] - 1 for key in exact}
        table.append([name, f"{seconds:.2f}", *(f"{part:+.2%}" for part in differences.values())])
        values[f"largest_difference_{name.replace(' ', '_').replace(',', '')}"] = max(map(abs, differences.values()))
    return Result(title="Choices", how=HOW, command="python -m benchmarks.choices", values=values, table=table)


if __name__ == "__main__":
    publish("choices", run())
