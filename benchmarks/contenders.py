"""How long a time step of one case takes: the usual ways beside ours, in one run.

    python -m benchmarks.contenders [--rounds N] [--check-steps N]

All march the article's case (140 m of track, 12 elements per pad, 350 km/h). Before anything is timed, all must agree
about the peaks of a short run.
"""

import argparse
from collections.abc import Callable

import numpy as np

from benchmarks.article import article_case
from benchmarks.results import Result, publish, scatter
from benchmarks.timing import interleave, medians
from benchmarks.usual import March, Naive, SolveBanded, SuperLU
from solver.arrays import Array
from solver.block import Block
from solver.case import Slab
from solver.channels import BODIES, TRACK

LANES = (1, 4, 8, 16)
FULL = 8
STEPS = 200  # of ours in a round
KINDS = (4, 7)  # where deflections and where accelerations begin among the recorded
AGREEMENT = 1e-8  # largest relative difference between peaks

HOW = """A round lets every contender take some steps, one after the other; figures are medians over {rounds} rounds,
± half the distance between the quartiles. The usual ways are timed twice: by itself the track's part, which is to
assemble the matrix (where that is done in every step), the right-hand side `M p + C q` and the solution for it; and the
whole step with contact, vehicle and recording, in NumPy. Ours is always the whole step, with all channels recorded.
**Ratios divide the track's part of the usual way by our whole step**, so they are lower bounds.

Before anything is timed, all march {steps} steps from rest over the same wave, and the peaks of contact forces,
deflections of rail, slab and base and accelerations of the vehicle must agree. `difference_of_peaks` is the largest
difference between anybody's and those of one lane of ours, as part of the largest peak of the same unit."""


def label(lanes: int, slab: Slab = "continuous") -> str:
    """Name of one of ours."""
    return f"ours, {lanes} lane{'s' * (lanes > 1)}" + ", joints" * (slab == "discontinuous")


def recorded(channels: Array) -> Array:
    """Of our channels (steps, channels), those that :data:`benchmarks.usual.RECORDED` lists."""
    return channels[:, [0, 1, 2, 3, TRACK, TRACK + 3, TRACK + 5, *range(BODIES, BODIES + 7)]]


def peaks_of(histories: Array) -> Array:
    """Largest magnitude of every history of (steps, histories)."""
    return np.abs(histories).max(axis=0)


def check_peaks(blocks: dict[str, Block], others: list[March], steps: int) -> float:
    """Largest difference between anybody's peaks over the first steps and those of one lane of ours.

    As part of the largest peak of the same unit: the car body hardly accelerates in so short a time.
    """
    found = []
    for name, block in blocks.items():
        if "joints" in name:  # the usual ways have none; `tracksweep verify` compares them with another model
            block.advance(steps)
            continue
        out = block.advance(steps)
        found += [peaks_of(recorded(out[:, lane])) for lane in range(len(block.cases))]
    found += [peaks_of(np.array([other.step() for _ in range(steps)])) for other in others]
    ours = found[0]
    scale = np.concatenate([np.full(len(kind), kind.max()) for kind in np.split(ours, KINDS)])
    return max(float((np.abs(peaks - ours) / scale).max()) for peaks in found)


def actions(blocks: dict[str, Block], others: list[March]) -> dict[str, Callable[[], int]]:
    """What a round consists of."""
    p, q = 1e-3 * np.random.default_rng(1).standard_normal((2, len(others[0].x)))

    def track(other: March, repeats: int) -> int:
        for phase in range(repeats):
            other.track(phase, p, q)
        return repeats

    def steps(other: March, repeats: int) -> int:
        for _ in range(repeats):
            other.step()
        return repeats

    def ours(block: Block) -> int:
        return block.advance(STEPS).shape[0] * len(block.cases)

    todo: dict[str, Callable[[], int]] = {}
    for other in others:
        repeats = 20 if isinstance(other, SuperLU) else 4
        todo[other.name] = lambda other=other, repeats=repeats: track(other, repeats)
        todo[f"{other.name}, whole step"] = lambda other=other, repeats=repeats: steps(other, repeats)
    return todo | {name: lambda block=block: ours(block) for name, block in blocks.items()}


def run(rounds: int, check_steps: int) -> Result:
    """Check, time and compare."""
    blocks = {}
    for slab in ("continuous", "discontinuous"):
        case = article_case(slab=slab, ease_in=0.02)
        blocks |= {
            label(lanes, slab): Block([case] * lanes) for lanes in LANES if slab == "continuous" or lanes in (1, FULL)
        }
    first = blocks[label(1)]
    others = [kind(first.case, first.eta[:, :, 0]) for kind in (Naive, SuperLU, SolveBanded)]
    difference = check_peaks(blocks, others, check_steps)
    if not difference < AGREEMENT:
        raise SystemExit(f"the contenders' peaks differ by {difference:.1e}: nothing to compare")
    seconds = interleave(actions(blocks, others), rounds)
    ms = {name: 1e3 * value for name, value in medians(seconds).items()}
    naive, superlu, banded = (ms[other.name] for other in others)
    one, full = ms[label(1)], ms[label(FULL)]
    values = {
        "difference_of_peaks": difference,
        "ratio_naive_full_lanes": naive / full,
        "ratio_superlu_full_lanes": superlu / full,
        "ratio_solve_banded_full_lanes": banded / full,
        "ratio_naive_one_case": naive / one,
        "ratio_superlu_one_case": superlu / one,
        "ratio_joints_cost": ms[label(FULL, "discontinuous")] / full,
        "ratio_joints_cost_one_case": ms[label(1, "discontinuous")] / one,
        "ms_per_lane_and_step": full,
        "ms_per_step_one_case": one,
        "simulated_time_per_clock": 1e3 * first.case.time_step / full,
    }
    table = [["contender", "ms per case and step", "±", "naive ÷ this"]]
    table += [
        [name, f"{value:.4g}", f"{100 * scatter(seconds[name]):.0f} %", f"{naive / value:.1f}"]
        for name, value in ms.items()
    ]
    lanes = {"label": "ours", "x": LANES, "y": [ms[label(width)] for width in LANES], "style": "o-"}
    linear = {
        "label": "time step simulated",
        "x": LANES,
        "y": [1e3 * first.case.time_step] * len(LANES),
        "style": "k--",
    }
    return Result(
        title="The usual ways beside ours",
        how=HOW.format(rounds=rounds, steps=check_steps),
        command="python -m benchmarks.contenders",
        values=values,
        table=table,
        plots=[{"x_label": "lanes", "y_label": "ms per case and step", "curves": [lanes, linear]}],
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--check-steps", type=int, default=500)
    options = parser.parse_args()
    publish("contenders", run(options.rounds, options.check_steps))


if __name__ == "__main__":
    main()
