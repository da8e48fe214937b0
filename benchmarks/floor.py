"""How near a step comes to what the machine's memory and arithmetic allow at all.

python -m benchmarks.floor [--rounds N]
"""

import argparse
import math

import numpy as np

from benchmarks.article import article_case
from benchmarks.results import Result, publish
from benchmarks.timing import interleave, medians
from solver.arrays import Array, aligned_zeros
from solver.block import Block
from solver.compiled import compiled
from solver.kernels import Lanes
from solver.simd import add, fma, load, store
from solver.track import NODE

LANES = 8
STEPS = 200
# Arrays of all unknowns that a step passes over, at least: x, u and v are read, u, v and x written by the pass that
# ends in the forward sweep; the sweep back, which can begin only when that is over, reads and writes x.
PASSES = 8
# Vector instructions per unknown, counted where code needs fewest: a multiply-add, a product and a sum are one each.
# What damping between beams, pads and ends add is left out.
SUBSTITUTION = 10 + 9  # a sum and 8 multiply-adds either way (48 in a node of six), and the product with a pivot
PREDICTORS = 14 / 2  # of a value and a slope: both predictors, p and q
SPREADING = (2 + 18) / 2  # mass and convection of a value and a slope on three nodes
INSTRUCTIONS = SUBSTITUTION + PREDICTORS + SPREADING


HOW = """The floor of a step is the longer of two times: to move the state, and to do the arithmetic. Both rates are
measured in the same run, by loops compiled as the solver's are, eight lanes wide: *bytes* by a loop that reads and
writes three arrays exactly as large as those of the state (so what fits into a cache here fits there), *multiply-adds*
by ten independent chains in registers.

A step must pass {passes} times over an array of all unknowns: displacements and two predictors are read and written
once, and the sweep back reads and writes the displacements again. It must do {instructions} vector instructions per
unknown ({substitution} of them in the substitution). Factors, windows, pads, vehicles, contact and recording are not
counted as needed, but are in our time. `ratio_floor` is our time divided by the floor, `ratio_floor_bytes` and
`ratio_floor_arithmetic` are our time divided by either part."""


@compiled
def stream(x: Array, u: Array, v: Array, factor: float, repeats: int, lanes: Lanes) -> None:
    """Read and write three arrays, several times."""
    for _ in range(repeats):
        for row in range(x.shape[0]):
            a, b, c = load(x, row, lanes), load(u, row, lanes), load(v, row, lanes)
            store(x, row, fma(factor, b, a), lanes)
            store(u, row, fma(factor, c, b), lanes)
            store(v, row, fma(factor, a, c), lanes)


@compiled
def multiply_add(x: Array, factor: float, repeats: int, lanes: Lanes) -> None:
    """Ten independent chains of multiply-adds; ``x`` has eleven rows."""
    y = load(x, 10, lanes)
    a, b, c = load(x, 0, lanes), load(x, 1, lanes), load(x, 2, lanes)
    d, e, f = load(x, 3, lanes), load(x, 4, lanes), load(x, 5, lanes)
    g, h = load(x, 6, lanes), load(x, 7, lanes)
    i, j = load(x, 8, lanes), load(x, 9, lanes)
    for _ in range(repeats):
        a, b, c, d, e = fma(factor, a, y), fma(factor, b, y), fma(factor, c, y), fma(factor, d, y), fma(factor, e, y)
        f, g, h, i, j = fma(factor, f, y), fma(factor, g, y), fma(factor, h, y), fma(factor, i, y), fma(factor, j, y)
    store(x, 0, add(add(add(a, b), add(c, d)), add(add(e, f), add(add(g, h), add(i, j)))), lanes)


def run(rounds: int) -> Result:
    """Measure both rates and our step, interleaved."""
    block = Block([article_case()] * LANES)
    unknowns = NODE * block.model.cells * block.case.numerics.elements_per_pad
    lanes = (0.0,) * LANES
    x, u, v = (aligned_zeros((unknowns, LANES)) for _ in range(3))
    chains, few = np.ones((11, LANES)), math.ceil(1e8 / x.nbytes)

    def state() -> int:
        stream(x, u, v, 1e-9, few, lanes)
        return 6 * x.nbytes * few

    def arithmetic() -> int:
        multiply_add(chains, 0.5, 1_000_000, lanes)
        return 10 * LANES * 1_000_000

    def ours() -> int:
        return len(block.advance(STEPS))

    actions = {"stream": state, "arithmetic": arithmetic, "ours": ours}
    interleave(actions, 1)  # compiles
    seconds = medians(interleave(actions, rounds))
    size = 8 * unknowns * LANES
    bytes_s, arithmetic_s = PASSES * size * seconds["stream"], INSTRUCTIONS * size / 8 * seconds["arithmetic"]
    floor = max(bytes_s, arithmetic_s)
    rate = 1e-9 / seconds["stream"], 1e-9 / seconds["arithmetic"]
    table = [
        ["per step of eight lanes", "needed", "the machine's rate", "floor, µs", "ours, µs", "ours ÷ floor"],
        _row("bytes", PASSES * size / 1e6, "MB", f"{rate[0]:.1f} GB/s", bytes_s, seconds["ours"]),
        _row(
            "multiply-adds", INSTRUCTIONS * size / 8e6, "million", f"{rate[1]:.1f} /ns", arithmetic_s, seconds["ours"]
        ),
    ]
    values = {
        "ratio_floor": seconds["ours"] / floor,
        "ratio_floor_bytes": seconds["ours"] / bytes_s,
        "ratio_floor_arithmetic": seconds["ours"] / arithmetic_s,
        "stream_gb_per_s": rate[0],
        "multiply_adds_per_ns": rate[1],
        "achieved_gb_per_s": PASSES * size / seconds["ours"] / 1e9,
        "achieved_multiply_adds_per_ns": INSTRUCTIONS * size / 8 / seconds["ours"] / 1e9,
    }
    how = HOW.format(passes=PASSES, instructions=INSTRUCTIONS, substitution=SUBSTITUTION)
    return Result(title="Beside the machine's floor", how=how, command=COMMAND, values=values, table=table)


COMMAND = "python -m benchmarks.floor"


def _row(what: str, needed: float, unit: str, rate: str, floor: float, ours: float) -> list[str]:
    return [what, f"{needed:.3g} {unit}", rate, f"{1e6 * floor:.0f}", f"{1e6 * ours:.0f}", f"{ours / floor:.2f}"]


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rounds", type=int, default=15)
    publish("floor", run(parser.parse_args().rounds))


if __name__ == "__main__":
    main()
