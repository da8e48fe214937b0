"""How long one time step of one case takes: the usual ways beside ours, in one run.

    python -m benchmarks [--steps N] [--rounds N]

Every contender solves the same step of the article's case (140 m of track, 12 elements per pad, 350 km/h) and is
checked to give the same displacements before it is timed. Rounds are interleaved; medians are printed.
"""

import argparse
import statistics
import time
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy import sparse
from scipy.linalg import solve_banded
from scipy.sparse.linalg import splu, spsolve

from solver.arrays import Array
from solver.banded import FACTOR_COLUMNS, substitute
from solver.block import Block
from solver.case import Case, Harmonic
from solver.catalogue import TRACKS, VEHICLES
from solver.kernels import advance
from solver.track import NODE

LANES = (1, 4, 8)
FULL = LANES[-1]


def article_case() -> Case:
    """The article's harmonic case at 350 km/h on a continuous slab."""
    return Case(
        speed=350 / 3.6,
        irregularity=Harmonic(wavelength=1.0, amplitude=3e-4),
        track=TRACKS["crts2"].values,
        vehicle=VEHICLES["crh3"].values,
    )


def diagonals(band: Array) -> list[Array]:
    """The diagonals of a band stored row by row, lowest first."""
    n = len(band)
    return [band[max(0, -k) : n - max(0, k), 9 + k] for k in range(-9, 10)]


@dataclass
class Contender:
    """A way to take steps: ``step(phase, p, q)`` solves ``A x = M p + C q``."""

    name: str
    step: Callable[[int, Array, Array], Array]


def contenders(block: Block) -> list[Contender]:
    """The usual ways, from the same matrices."""
    model, k = block.model, block.scheme

    def matrices(phase: int) -> tuple[Array, sparse.csc_array, sparse.csc_array]:
        bands = {}
        for name, factors in {"a": (k.inertia, k.damping), "m": (1e13, 0.0), "c": (0.0, 1e13), "k": (0.0, 0.0)}.items():
            bands[name] = model.band(model.cells, phase, *factors)
        mass, damping = ((bands[n] - bands["k"]) / 1e13 for n in "mc")
        return bands["a"], *(sparse.diags_array(diagonals(b), offsets=range(-9, 10)).tocsc() for b in (mass, damping))

    phases = [matrices(phase) for phase in range(4)]  # four phases suffice to time a step
    assembled = [sparse.diags_array(diagonals(a), offsets=range(-9, 10)).tocsc() for a, _, _ in phases]
    lu = [splu(matrix) for matrix in assembled]

    def by_spsolve(phase: int, p: Array, q: Array) -> Array:
        # What a script does: the matrix changes with every step, so it is assembled and factorised in every step.
        a = model.band(model.cells, phase, k.inertia, k.damping)
        _, mass, damping = phases[phase]
        return spsolve(sparse.diags_array(diagonals(a), offsets=range(-9, 10)).tocsc(), mass @ p + damping @ q)

    def by_factorising(phase: int, p: Array, q: Array) -> Array:
        _, mass, damping = phases[phase]
        return splu(assembled[phase]).solve(mass @ p + damping @ q)

    def by_superlu(phase: int, p: Array, q: Array) -> Array:
        _, mass, damping = phases[phase]
        return lu[phase].solve(mass @ p + damping @ q)

    def by_solve_banded(phase: int, p: Array, q: Array) -> Array:
        a, mass, damping = phases[phase]
        upper_first = np.zeros((19, len(a)))
        for offset, diagonal in zip(range(-9, 10), diagonals(a), strict=True):
            upper_first[9 - offset, max(0, offset) : len(a) - max(0, -offset)] = diagonal
        return solve_banded((9, 9), upper_first, mass @ p + damping @ q, overwrite_ab=True)

    return [
        Contender("naive (assemble and spsolve)", by_spsolve),
        Contender("SuperLU factors anew in every step", by_factorising),
        Contender("SuperLU factors kept per phase", by_superlu),
        Contender("solve_banded", by_solve_banded),
    ]


def check(block: Block, others: list[Contender]) -> float:
    """Largest relative difference between our step and the others', on a state with every wave in it."""
    k, phase = block.scheme, 1
    rng = np.random.default_rng(0)
    size = NODE * block.model.cells * block.case.numerics.elements_per_pad
    x, u, v = 1e-3 * rng.standard_normal((3, size, 1))
    u = x + 1e-9 * u
    x[:NODE] = u[:NODE] = v[:NODE] = 0
    acceleration = k.acceleration * (x - u)
    velocity = v + k.velocity * acceleration
    pu, pv = x + k.step * velocity + k.drift * acceleration, velocity + k.kick * acceleration
    p, q = (k.inertia * pu - k.alpha * acceleration)[:, 0], (k.damping * pu - pv)[:, 0]
    advance(k, block.stencils, phase, x, u, v, x, (0.0,))
    substitute(block.operator.blocks, block.operator.block_of_cell[phase], x, (0.0,))
    return max(float(np.abs(other.step(phase, p, q) - x[:, 0]).max() / np.abs(x).max()) for other in others)


def main() -> None:
    """Print the table and the ratios."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--steps", type=int, default=300, help="steps of ours in a round")
    parser.add_argument("--rounds", type=int, default=5)
    options = parser.parse_args()
    case = article_case()
    blocks = {f"ours, {lanes} lane(s)": Block([case] * lanes) for lanes in LANES}
    one, full = f"ours, {LANES[0]} lane(s)", f"ours, {FULL} lane(s)"
    blocks[f"{full}, joints"] = Block([replace(case, slab="discontinuous")] * FULL)
    blocks[f"{one}, joints"] = Block([replace(case, slab="discontinuous")])
    others = contenders(blocks[one])
    describe(blocks[one])
    difference = check(blocks[one], others)
    print(f"largest relative difference between the contenders' displacements: {difference:.1e}")
    if difference > 1e-8:
        raise SystemExit("the contenders disagree: nothing to compare")
    for block in blocks.values():
        block.advance(50)  # compiles
    medians = measure(blocks, others, options.steps, options.rounds)
    for name, median in medians.items():
        print(f"{name:34s} {median * 1e3:9.4f} ms per case and step")
    naive, factorising, superlu, _ = (medians[other.name] for other in others)
    print(f"ratio_naive_one_case = {naive / medians[one]:.1f}")
    print(f"ratio_factorising_one_case = {factorising / medians[one]:.1f}")
    print(f"ratio_naive_full_lanes = {naive / medians[full]:.1f}")
    print(f"ratio_superlu_full_lanes = {superlu / medians[full]:.1f}")
    print(f"ratio_joints_cost = {medians[f'{full}, joints'] / medians[full]:.2f}")
    print(f"ratio_joints_cost_one_case = {medians[f'{one}, joints'] / medians[one]:.2f}")


def describe(block: Block) -> None:
    """Print the size of the problem, and of its factors beside those of whole matrices."""
    case = block.case
    unknowns = NODE * block.model.cells * case.numerics.elements_per_pad
    print(f"{unknowns} unknowns, {case.phases} phases")
    whole = unknowns * case.phases * FACTOR_COLUMNS * 8
    print(f"factors take {block.operator.blocks.nbytes / 1e6:.0f} MB, of whole matrices {whole / 1e6:.0f} MB")


def measure(blocks: dict[str, Block], others: list[Contender], steps: int, rounds: int) -> dict[str, float]:
    """Median seconds per case and step of interleaved rounds."""
    unknowns = blocks["ours, 1 lane(s)"].state.x.shape[0]
    p, q = 1e-3 * np.random.default_rng(1).standard_normal((2, unknowns))
    seconds: dict[str, list[float]] = defaultdict(list)
    for _ in range(rounds):
        for other in others:
            repeats = 4 if "spsolve" in other.name or "anew" in other.name else 20
            start = time.perf_counter()
            for i in range(repeats):
                other.step(i % 4, p, q)
            seconds[other.name].append((time.perf_counter() - start) / repeats)
        for name, block in blocks.items():
            start = time.perf_counter()
            block.advance(steps)
            seconds[name].append((time.perf_counter() - start) / steps / len(block.cases))
    return {name: statistics.median(values) for name, values in seconds.items()}


if __name__ == "__main__":
    main()
