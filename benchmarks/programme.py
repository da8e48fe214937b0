"""The article's whole programme through the service on two cores, beside factors kept by SuperLU.

python -m benchmarks.programme [--whole]
"""

import argparse
import time
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from typing import Any

from benchmarks.article import SPEEDS_KMH, article_case
from benchmarks.results import Result, publish
from benchmarks.served import finish, served, submit
from benchmarks.usual import SuperLU
from solver.block import Block

PROCESSES = 2
SAMPLE = 60  # steps by which one of SuperLU is timed, unless it is to take all
SETTLE_S = 1.0
WAVE_S, RANDOM_S = 3.0, 5.0  # windows
PERCENTILES = (25.0, 63.2, 90.0)
BANDS = tuple({"min": shortest, "max": 30.0} for shortest in (2.0, 2.5, 3.0, 3.5, 4.0))

HOW = """{speeds} speeds on a continuous and on a jointed slab over a wave ({wave} s each), {percentiles} percentiles
and {bands} bands of the spectrum on a jointed slab at 350 km/h ({random} s each; one case is in both), every case after
{settle} s that are not looked at: {cases} cases, {steps:.2f} million steps. *Ours* is from posting the three studies
to the end of the last, through `tracksweep serve` on an empty folder with {processes} workers, kernels on disk.

*SuperLU* keeps the factors of every phase, {processes} processes side by side: {taken}. It marches the continuous slab
also where ours has joints, as joints would take another set of factors for each of their places, so it does less."""

WHOLE = "all steps of all cases, factorisation included"
SAMPLED = f"{SAMPLE} steps at every speed, times the steps of all cases; to factorise is not counted"


def studies() -> list[dict[str, Any]]:
    """What is posted."""

    def jointed(name: str, percentiles: list[float], bands: list[dict[str, float]]) -> dict[str, Any]:
        spectrum = {"kind": "spectrum", "percentile": percentiles, "wavelength_band_m": bands}
        sweep = {"kind": "product", "speed_kmh": [350.0], "slab": ["discontinuous"], "irregularity": spectrum}
        return {"name": name, "sweep": sweep, "numerics": {"settle_s": SETTLE_S, "window_s": RANDOM_S}}

    wave = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}
    slabs = ["continuous", "discontinuous"]
    sweep = {"kind": "product", "speed_kmh": list(SPEEDS_KMH), "slab": slabs, "irregularity": wave}
    return [
        {"name": "speeds", "sweep": sweep, "numerics": {"settle_s": SETTLE_S, "window_s": WAVE_S}},
        jointed("percentiles", list(PERCENTILES), [BANDS[0]]),
        jointed("bands", [63.2], list(BANDS)),
    ]


def planned() -> list[tuple[float, float]]:
    """Speed and seconds of every case, settling included."""
    random_cases = len(PERCENTILES) + len(BANDS) - 1  # one case is in both studies
    waves = [(speed, SETTLE_S + WAVE_S) for speed in SPEEDS_KMH for _slab in range(2)]
    return waves + [(350.0, SETTLE_S + RANDOM_S)] * random_cases


def steps_of(speed_kmh: float, seconds: float) -> int:
    """How many steps that is."""
    return round(seconds / article_case(speed_kmh).time_step)


def ours() -> float:
    """Wall time of the whole programme, s."""
    with served(PROCESSES) as url:
        start = time.perf_counter()
        ids = [submit(url, study) for study in studies()]
        for study_id in ids:
            finish(url, study_id)
        return time.perf_counter() - start


def march(speed_kmh: float, steps: int) -> float:
    """Seconds that SuperLU takes for some steps, without factorising."""
    block = Block([article_case(speed_kmh, settle=SETTLE_S, window=RANDOM_S)])
    other = SuperLU(block.case, block.eta[:, :, 0])
    for phase in range(min(steps + 2, block.case.phases)):
        other.prepare(phase)
        other.damping(phase)
    other.step()  # loads the contact's code
    start = time.perf_counter()
    for _ in range(steps):
        other.step()
    return time.perf_counter() - start


def superlu(whole: bool) -> float:
    """Wall time of the programme by SuperLU, s."""
    plan = [(speed, steps_of(speed, seconds)) for speed, seconds in planned()]
    # Fresh processes: a fork would share what Numba and BLAS hold.
    with ProcessPoolExecutor(PROCESSES, mp_context=get_context("spawn")) as pool:
        if whole:
            start = time.perf_counter()
            list(pool.map(march, *zip(*plan, strict=True)))
            return time.perf_counter() - start
        sampled = zip(SPEEDS_KMH, pool.map(march, SPEEDS_KMH, [SAMPLE] * len(SPEEDS_KMH)), strict=True)
        per_step = {speed: seconds / SAMPLE for speed, seconds in sampled}
    return sum(per_step[speed] * steps for speed, steps in plan) / PROCESSES


def run(whole: bool) -> Result:
    """Time both."""
    mine, other = ours(), superlu(whole)
    plan = planned()
    how = HOW.format(
        speeds=len(SPEEDS_KMH),
        wave=WAVE_S,
        percentiles=len(PERCENTILES),
        bands=len(BANDS),
        random=RANDOM_S,
        settle=SETTLE_S,
        cases=len(plan),
        steps=sum(steps_of(*each) for each in plan) / 1e6,
        processes=PROCESSES,
        taken=WHOLE if whole else SAMPLED,
    )
    return Result(
        title="The article's whole programme",
        how=how,
        command="python -m benchmarks.programme" + " --whole" * whole,
        values={"programme_s": mine, "programme_superlu_s": other, "ratio_programme": other / mine},
        table=[["way", "minutes"], ["ours", f"{mine / 60:.1f}"], ["SuperLU", f"{other / 60:.1f}"]],
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--whole", action="store_true", help="let SuperLU take all steps, which takes an hour")
    publish("programme", run(parser.parse_args().whole))


if __name__ == "__main__":
    main()
