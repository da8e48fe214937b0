"""How cost grows with the track's length, the mesh, the steps and the number of cases.

python -m benchmarks.growth [--rounds N]
"""

import argparse
from collections.abc import Callable, Mapping
from dataclasses import replace

from benchmarks.article import article_case
from benchmarks.results import Result, exponent, publish, scatter
from benchmarks.timing import interleave, medians
from solver.block import Block
from solver.case import Case, Harmonic
from solver.errors import SolverError
from solver.simulate import solve

LANES = 8
TRACK_LENGTHS_M = (140, 200, 280, 400, 560)
ELEMENTS_PER_PAD = (6, 12, 24, 48)
STEPS = (100, 200, 400, 800)
CASES = (8, 16, 32, 64)
UNIT = 100  # steps of a round where their number is not what grows

HOW = """Seconds are of whole steps of eight lanes or, for the number of cases, of `solve()` from cases to responses,
which includes setting up every block of eight. Sizes take turns within a round; medians over {rounds} rounds (of cases
{cases}), ± half the distance between the quartiles. An exponent is the slope of a straight line through the logarithms,
by least squares."""


def cases(count: int) -> list[Case]:
    """Short cases that differ in amplitude and so share an operator."""
    case = article_case(settle=0.3, window=0.02, time_step=2e-4)
    return [replace(case, irregularity=Harmonic(wavelength=1.0, amplitude=1e-4 + 1e-6 * i)) for i in range(count)]


def _solve(count: int) -> int:
    if any(isinstance(outcome, SolverError) for outcome in solve(cases(count))):
        raise SystemExit("a case failed: nothing to compare")
    return 1


def _march(block: Block, steps: int) -> int:
    block.advance(steps)
    return 1


Actions = Mapping[float, Callable[[], int]]


def subjects() -> dict[str, Actions]:
    """What grows: for each size, what is timed."""

    def blocks(name: str, sizes: tuple[int, ...]) -> Actions:
        made = {size: Block([article_case(**{name: size}, window=10.0)] * LANES) for size in sizes}
        return {size: lambda block=block: _march(block, UNIT) for size, block in made.items()}

    one = Block([article_case(window=10.0)] * LANES)
    return {
        "track_length": blocks("track_length", TRACK_LENGTHS_M),
        "elements_per_pad": blocks("elements_per_pad", ELEMENTS_PER_PAD),
        "steps": {steps: lambda steps=steps: _march(one, steps) for steps in STEPS},
        "cases": {count: lambda count=count: _solve(count) for count in CASES},
    }


def _rounds_of_cases(rounds: int) -> int:
    return max(2, rounds // 3)  # they take long


def run(rounds: int) -> Result:
    """Time every size of everything, and fit."""
    table, values, curves = [["what grows", "size", "seconds", "±"]], {}, []
    for name, actions in subjects().items():
        often = _rounds_of_cases(rounds) if name == "cases" else rounds
        interleave(actions, 1)
        seconds = interleave(actions, often)
        middle = medians(seconds)
        table += [[name, f"{size}", f"{middle[size]:.4g}", f"{100 * scatter(seconds[size]):.0f} %"] for size in actions]
        sizes, times = list(middle), list(middle.values())
        values[f"exponent_{name}"] = exponent(sizes, times)
        relative = {"x": [size / sizes[0] for size in sizes], "y": [time / times[0] for time in times]}
        curves.append({"label": name.replace("_", " "), "style": "o-", **relative})
    largest = max(max(curve["x"]) for curve in curves)
    curves.append({"label": "linear", "style": "k--", "x": [1, largest], "y": [1, largest]})
    plot = {"x_label": "size ÷ smallest", "y_label": "time ÷ that of the smallest", "curves": curves}
    return Result(
        title="Growth",
        how=HOW.format(rounds=rounds, cases=_rounds_of_cases(rounds)),
        command="python -m benchmarks.growth",
        values=values,
        table=table,
        plots=[plot],
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=9)
    publish("growth", run(parser.parse_args().rounds))


if __name__ == "__main__":
    main()
