"""What a coarser step, mesh or integrator or a shorter track would save, and what it would cost in the peaks.

python -m benchmarks.choices
"""

import time
from typing import Any

from benchmarks.article import article_case
from benchmarks.results import Result, publish
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
COMPARED = {
    "force": ("wheel_rail_force", "wheelset_1"),
    "rail acceleration": ("rail_acceleration", "wheelset_1"),
    "slab acceleration": ("slab_acceleration", "wheelset_1"),
    "base acceleration": ("base_acceleration", "wheelset_1"),
}

HOW = """One jointed case of the article at 350 km/h, alone, 0.5 s of window. *CPU s* is processor time of the whole
solve, the other columns are how far the peak is from that of the finest choice (24 elements per pad, steps of 2.5e-5 s,
200 m). `docs/decisions/0006-where-the-speed-comes-from.md` draws the conclusions."""


def solved(**numerics: Any) -> tuple[float, dict[str, float]]:
    """Processor time and peaks."""
    case = article_case(slab="discontinuous", settle=0.6, window=0.5, **numerics)
    began = time.process_time()
    response = solve([case])[0]
    seconds = time.process_time() - began
    if not isinstance(response, Response):
        raise response
    found = {(peak.quantity, peak.position): peak.peak for peak in peaks(response)}
    return seconds, {name: found[key] for name, key in COMPARED.items()}


def run() -> Result:
    """Compare every choice with the finest."""
    warm()
    _, exact = solved(**FINEST)
    table = [["choice", "CPU s", *COMPARED]]
    values = {}
    for name, numerics in CHOICES.items():
        seconds, found = solved(**numerics)
        differences = {key: found[key] / exact[key] - 1 for key in COMPARED}
        table.append([name, f"{seconds:.2f}", *(f"{part:+.2%}" for part in differences.values())])
        values[f"largest_difference_{name.replace(' ', '_').replace(',', '')}"] = max(map(abs, differences.values()))
    return Result(title="Choices", how=HOW, command="python -m benchmarks.choices", values=values, table=table)


if __name__ == "__main__":
    publish("choices", run())
