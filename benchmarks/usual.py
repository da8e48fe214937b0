"""The usual ways to march the same equations, in NumPy and SciPy.

Same matrices, same integrator, same contact, same vehicle as the solver's; only the track is solved in another way:

* :class:`Naive` assembles the matrix in every step and calls ``spsolve``;
* :class:`SuperLU` factorises every phase once and keeps the factors, in the ordering that is quickest here;
* :class:`SolveBanded` assembles the band in every step and calls LAPACK's ``solve_banded``.
"""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from scipy import sparse
from scipy.linalg import solve_banded
from scipy.sparse.linalg import splu, spsolve

from solver.arrays import Array
from solver.case import Case
from solver.contact import close_contacts
from solver.integrator import integrator
from solver.start import static_equilibrium
from solver.track import BASE, NODE, RAIL, SLAB, TrackModel
from solver.vehicle import WHEELSETS, vehicle_matrices, wheel_positions
from solver.wheel import hertz_constant

HALF = 9  # diagonals on either side of the main one
BODIES = (0, 2, 4, 6, 7, 8, 9)  # unknowns of the vehicle whose accelerations are recorded
RECORDED = (*(f"wheel_rail_force {i}" for i in range(1, 5)), "rail", "slab", "base", *(f"body {i}" for i in BODIES))


def diagonals(band: Array) -> list[Array]:
    """The diagonals of a band stored row by row, lowest first."""
    n = len(band)
    return [band[max(0, -k) : n - max(0, k), HALF + k] for k in range(-HALF, HALF + 1)]


def assembled(band: Array) -> sparse.csc_array:
    """A band as a sparse matrix without its zeros."""
    return sparse.diags_array(diagonals(band), offsets=range(-HALF, HALF + 1)).tocsc()


class March(ABC):
    """A run of one case on a continuous slab, step by step.

    Parameters
    ----------
    case : Case
    irregularity : ndarray, shape (steps, 4)
        Under each wheel at the end of each step, m.
    """

    name: str

    def __init__(self, case: Case, irregularity: Array) -> None:
        self.model, self.irregularity = TrackModel(case), irregularity
        self.scheme = integrator(case.time_step, case.numerics.spectral_radius)
        wheels = wheel_positions(case.vehicle)
        self.loads = self.model.unit_loads(wheels)
        self.left, self.slope = np.repeat(self.model.absorption(self.scheme.step), NODE // 2, axis=0).T
        self.vehicle, self.hertz = vehicle_matrices(case.vehicle), hertz_constant(case.vehicle)
        k, v = self.scheme, self.vehicle
        self.solution = np.linalg.inv(v.stiffness + k.damping * v.damping + k.inertia * v.mass)
        self.points = [self.model.point(wheels[0], beam) for beam in (RAIL, SLAB, BASE)]
        self.mass = self._part(0, inertia_factor=1e13)
        self.dampings: dict[int, sparse.csc_array] = {}
        self.start()

    def _part(self, phase: int, **factor: float) -> sparse.csc_array:
        """Mass or damping: what a large factor of it adds to the matrix."""
        stiffness = self.model.band(self.model.cells, phase)
        return assembled((self.model.band(self.model.cells, phase, **factor) - stiffness) / 1e13)

    def damping(self, phase: int) -> sparse.csc_array:
        """The damping matrix of a phase, kept."""
        if phase not in self.dampings:
            self.dampings[phase] = self._part(phase, damping_factor=1e13)
        return self.dampings[phase]

    def band(self, phase: int) -> Array:
        """The matrix of a step at a phase, as a band."""
        return self.model.band(self.model.cells, phase, self.scheme.inertia, self.scheme.damping)

    def start(self) -> None:
        """Rest under the weight."""
        steady = self.model.steady_response(0, self.loads)
        at_rest = static_equilibrium(self.model.case.vehicle, self.loads.T @ steady)
        self.vehicle_u, self.penetration, force = at_rest
        self.vehicle_v, self.vehicle_a = np.zeros((2, len(self.vehicle_u)))
        self.x = steady @ force
        self.u, self.v = self.x.copy(), np.zeros_like(self.x)
        self.done = 0

    @abstractmethod
    def solve(self, phase: int, load: Array) -> Array:
        """Displacements of the track under one load, and nothing else."""

    @abstractmethod
    def solve_with_wheels(self, phase: int, load: Array) -> tuple[Array, Array]:
        """Displacements under a load, and under a unit force at every wheel, shape (unknowns, 4)."""

    def track(self, phase: int, p: Array, q: Array) -> Array:
        """The track's part of a step: ``A x = M p + C q``."""
        return self.solve(phase, self.mass @ p + self.damping(phase) @ q)

    def step(self) -> Array:
        """Take a step; what is recorded of it, in the order of ``RECORDED``."""
        self.done += 1
        phase = self.done % self.model.case.phases
        p, q = self._advance()
        load = self.mass @ p + self.damping(phase) @ q
        free, response = self.solve_with_wheels(phase, load)
        force, bodies = self._couple(self.loads.T @ free, self.loads.T @ response)
        self.x = free + response @ force
        under = [weights @ self.x[row : row + 2 * NODE] for row, weights in self.points]
        return np.r_[force, under, bodies]

    def _advance(self) -> tuple[Array, Array]:
        """State at the end of the step before to p and q of this one; the ends absorb velocity."""
        k = self.scheme
        acceleration = k.acceleration * (self.x - self.u)
        velocity = self.v + k.velocity * acceleration
        value = velocity[0::2].copy()
        velocity[0::2] *= self.left
        velocity[1::2] = self.left * velocity[1::2] + self.slope * value
        self.u = self.x + k.step * velocity + k.drift * acceleration
        self.v = velocity + k.kick * acceleration
        return k.inertia * self.u - k.alpha * acceleration, k.damping * self.u - self.v

    def _couple(self, rail: Array, compliance: Array) -> tuple[Array, Array]:
        """Contact forces, and the vehicle's step under them."""
        k, v = self.scheme, self.vehicle
        load = v.weight + v.mass @ (k.inertia * self.vehicle_u - k.alpha * self.vehicle_a)
        load += v.damping @ (k.damping * self.vehicle_u - self.vehicle_v)
        free, force = self.solution @ load, np.zeros(4)
        approach = free[WHEELSETS] - rail - self.irregularity[self.done - 1]
        together = compliance + self.solution[WHEELSETS, WHEELSETS]
        if not close_contacts(approach, together, self.hertz, self.penetration, force):
            raise ArithmeticError("contact does not converge")
        displacement = free - self.solution[:, WHEELSETS] @ force
        new = k.acceleration * (displacement - self.vehicle_u)
        reported = (1 - k.alpha) * new + k.alpha * self.vehicle_a
        velocity = self.vehicle_v + k.velocity * new
        self.vehicle_u = displacement + k.step * velocity + k.drift * new
        self.vehicle_v, self.vehicle_a = velocity + k.kick * new, new
        return force, reported[list(BODIES)]


class Naive(March):
    """What a script does: the matrix changes with every step, so it is assembled and solved in every step."""

    name = "naive: assemble and spsolve"

    def solve(self, phase: int, load: Array) -> Array:
        return spsolve(assembled(self.band(phase)), load)

    def solve_with_wheels(self, phase: int, load: Array) -> tuple[Array, Array]:
        both = spsolve(assembled(self.band(phase)), np.column_stack([load, self.loads]))
        return both[:, 0], both[:, 1:]


class SuperLU(March):
    """Factors and responses to the wheels kept per phase."""

    name = "SuperLU, factors kept per phase"

    def __init__(self, case: Case, irregularity: Array) -> None:
        super().__init__(case, irregularity)
        self.kept: dict[int, tuple[Any, Array]] = {}

    def prepare(self, phase: int) -> tuple[Any, Array]:
        """Factorise a phase unless that has been done."""
        if phase not in self.kept:
            lu = splu(assembled(self.band(phase)), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0)
            self.kept[phase] = lu, lu.solve(self.loads)
        return self.kept[phase]

    def solve(self, phase: int, load: Array) -> Array:
        return self.prepare(phase)[0].solve(load)

    def solve_with_wheels(self, phase: int, load: Array) -> tuple[Array, Array]:
        lu, response = self.prepare(phase)
        return lu.solve(load), response


class SolveBanded(March):
    """LAPACK's band solver, which factorises in every call."""

    name = "solve_banded"

    def solve(self, phase: int, load: Array) -> Array:
        band = self.band(phase)
        upper_first = np.zeros((2 * HALF + 1, len(band)))
        for offset, diagonal in zip(range(-HALF, HALF + 1), diagonals(band), strict=True):
            upper_first[HALF - offset, max(0, offset) : len(band) - max(0, -offset)] = diagonal
        return solve_banded((HALF, HALF), upper_first, load, overwrite_ab=True)

    def solve_with_wheels(self, phase: int, load: Array) -> tuple[Array, Array]:
        both = self.solve(phase, np.column_stack([load, self.loads]))
        return both[:, 0], both[:, 1:]
