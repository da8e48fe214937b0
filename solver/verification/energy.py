"""Energy balance of train and track, from the fields themselves.

The engine keeps the speed. Rolling over a rail that slopes by ``w' + eta'`` takes ``-V F (w' + eta')`` of power at each
wheel; gravity is an energy of the vehicle. This must be what dampers turn to heat, what the ends absorb, and what
is stored. All is integrated by Gauss points over the beams, with nothing of the solver's matrices.
"""

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from solver.arrays import Array
from solver.beam import hermite
from solver.block import Block
from solver.case import Case
from solver.joint import enrichment
from solver.joint_kernels import first_joint, joint_row
from solver.track import BASE, RAIL, SLAB
from solver.vehicle import vehicle_matrices
from solver.verification.finding import Comparison, Curve, Finding, Plot, Row
from solver.verification.problems import SINE, TRACK, WORN, jointed, make_case, over_one_repeat
from solver.wheel import hertz_constant

POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)
POINTS, WEIGHTS = (POINTS + 1) / 2, WEIGHTS / 2


class Fields(NamedTuple):
    """The three beams at the Gauss points of all elements: arrays (3, elements, 4)."""

    displacement: Array
    rate: Array  # of the material
    curvature: Array


class Balance(NamedTuple):
    """Energy at the end of every step, J, and powers, W."""

    stored: Array
    engine: Array
    dissipated: Array
    absorbed: Array  # J per step


class Meter:
    """Reads energies and powers off a block of one lane."""

    def __init__(self, block: Block) -> None:
        self.block, self.case = block, block.case
        self.length = block.model.element.length
        self.matrices = vehicle_matrices(self.case.vehicle)
        self.hertz = hertz_constant(self.case.vehicle)
        self.slope = np.gradient(block.eta[:, :, 0], axis=0) / (self.case.speed * self.case.time_step)
        self.integral = self.length * WEIGHTS
        self.rail_slope = np.array([block.model.shape(place, 1) for place in block.operator.wheel_place])

    def velocity(self) -> Array:
        """Velocities of the unknowns in the moving frame."""
        k, state = self.block.scheme, self.block.state
        return (state.v + k.velocity * k.acceleration * (state.x - state.u))[:, 0]

    def _at(self, unknowns: Array, derivative: int, xi: Array = POINTS) -> Array:
        """A field or its derivative at points of every element, (3, elements, points), without the joints' part."""
        nodes = unknowns.reshape(-1, 3, 2)
        nodes = np.concatenate([nodes, np.zeros((1, 3, 2))])
        elements = np.concatenate([nodes[:-1], nodes[1:]], axis=2)  # (elements, 3, 4)
        return np.einsum("ebi,gi->beg", elements, hermite(xi, self.length, derivative))

    def _joints(self) -> list[tuple[int, float]]:
        """Slot and place (elements from the start of the mesh) of every joint."""
        c, step = self.block.joints, self.block.done
        if not c.joints:
            return []
        first, place = first_joint(c, step), c.place[step % len(c.place)]
        return [(2 * (j % c.joints), joint_row(c, step, j) / 6 + place) for j in range(first, first + c.joints)]

    def _jump_rates(self) -> Array:
        state = self.block.joint_state
        return (state.v - self.block.scheme.kick * state.a)[:, 0]

    def _add_joints(self, slab: Array, unknowns: Array, derivative: int, xi: Array, first: Array) -> None:
        """Add the joints' part to a field of the slab (elements, points); ``first`` is the number of each element."""
        d = self.block.joints.fade_length
        for slot, place in self._joints():
            near = (first > place - 2) & (first < place + d / self.length + 1)
            ahead = (first[near, None] + xi - place) * self.length
            slab[near] += enrichment(ahead, d, derivative) @ unknowns[slot : slot + 2]

    def fields(self, velocity: Array) -> Fields:
        """All beams with their joints."""
        x = self.block.state.x[:, 0]
        displacement, curvature = self._at(x, 0), self._at(x, 2)
        rate = self._at(velocity, 0) - self.case.speed * self._at(x, 1)
        first = np.arange(displacement.shape[1])
        jumps, rates = self.block.joint_state.x[:, 0], self._jump_rates()
        for field, unknowns, derivative in ((displacement, jumps, 0), (rate, rates, 0), (curvature, jumps, 2)):
            self._add_joints(field[SLAB], unknowns, derivative, POINTS, first)
        return Fields(displacement, rate, curvature)

    def _over_pads(self, velocity: Array) -> tuple[Array, Array]:
        """Compression of every pad and its rate."""
        element, xi = self.block.model.pad_location(self.block.done % self.case.phases)
        x, at = self.block.state.x[:, 0], np.array([xi])
        pads = slice(element, None, self.case.numerics.elements_per_pad)
        displacement = self._at(x, 0, at)[:, pads]
        rate = self._at(velocity, 0, at)[:, pads] - self.case.speed * self._at(x, 1, at)[:, pads]
        first = np.arange(len(x) // 6)[pads]
        self._add_joints(displacement[SLAB], self.block.joint_state.x[:, 0], 0, at, first)
        self._add_joints(rate[SLAB], self._jump_rates(), 0, at, first)
        return displacement[RAIL] - displacement[SLAB], rate[RAIL] - rate[SLAB]

    def kinetic(self, fields: Fields) -> float:
        """Of the track, J."""
        t = self.case.track
        mass = np.array([t.rail_mass, t.slab_mass, t.base_mass])
        return float(0.5 * mass @ (fields.rate**2 @ self.integral).sum(axis=1))

    def read(self) -> tuple[float, float, float]:
        """Stored energy, engine power and power of the dampers at the end of a step."""
        t, state = self.case.track, self.block.state
        velocity = self.velocity()
        f = self.fields(velocity)
        pad, pad_rate = self._over_pads(velocity)
        bending = np.array(
            [
                t.rail_elastic_modulus * t.rail_second_moment,
                t.slab_elastic_modulus * t.slab_second_moment,
                t.base_elastic_modulus * t.base_second_moment,
            ]
        )
        jump, jump_rate = self.block.joint_state.x[::2, 0], self._jump_rates()[::2]
        mortar, mortar_rate = (each[SLAB] - each[BASE] for each in (f.displacement, f.rate))
        stored = (
            self.kinetic(f)
            + 0.5 * bending @ (f.curvature**2 @ self.integral).sum(axis=1)
            + 0.5 * t.mortar_stiffness * (mortar**2 @ self.integral).sum()
            + 0.5 * t.roadbed_stiffness * (f.displacement[BASE] ** 2 @ self.integral).sum()
            + 0.5 * t.pad_stiffness * (pad**2).sum()
            + 0.5 * t.joint.shear_stiffness * (jump**2).sum()
        )
        dissipated = (
            t.mortar_damping * (mortar_rate**2 @ self.integral).sum()
            + t.roadbed_damping * (f.rate[BASE] ** 2 @ self.integral).sum()
            + t.pad_damping * (pad_rate**2).sum()
            + t.joint.shear_damping * (jump_rate**2).sum()
        )
        m, u, v = self.matrices, state.vehicle_u[0] + self.block.hanging[0], self._vehicle_velocity()
        stored += 0.5 * v @ m.mass @ v + 0.5 * u @ m.stiffness @ u - m.weight @ u
        stored += 0.4 * self.hertz * (state.force[:, 0] ** (5 / 3)).sum()  # the integral of (d / G)^1.5
        dissipated += v @ m.damping @ v
        nodes = state.x[self.block.operator.wheel_row[:, None] + [0, 1, 6, 7], 0]
        rail = (nodes * self.rail_slope).sum(axis=1)
        engine = -self.case.speed * state.force[:, 0] @ (rail + self.slope[self.block.done - 1])
        return float(stored), float(engine), float(dissipated)

    def _vehicle_velocity(self) -> Array:
        """From the predictor, which holds for the step to come."""
        k, state = self.block.scheme, self.block.state
        return state.vehicle_v[0] - k.kick * state.vehicle_a[0]

    def absorbed(self) -> float:
        """What the ends will take away before the next step, J."""
        block = self.block
        before = self.kinetic(self.fields(self.velocity()))
        velocity = self.velocity()
        left, slope = block.stencils.left[: len(velocity)].reshape(-1, 2).T
        kept = np.stack([left * velocity[::2], left * velocity[1::2] + slope * velocity[::2]], axis=1).ravel()
        return before - self.kinetic(self.fields(kept))


def measure(case: Case) -> Balance:
    """Balance over the window of a case."""
    block = Block([case])
    block.advance(block.settle_steps)
    meter = Meter(block)
    rows = []
    for _ in range(block.window_steps):
        rows.append((*meter.read(), meter.absorbed()))
        block.advance(1)
    return Balance(*np.array(rows).T)


def _finding(case: Case, what: str) -> Finding:
    """The engine's work over the window beside where it went."""
    b, step = measure(case), case.time_step

    def work(power: Array) -> Array:
        return np.concatenate([[0.0], np.cumsum((power[1:] + power[:-1]) / 2 * step)])

    engine, damped = work(b.engine), work(b.dissipated)
    absorbed = np.concatenate([[0.0], np.cumsum(b.absorbed)[:-1]])
    stored = b.stored - b.stored[0]
    rows: list[Row] = [
        Comparison(
            what=f"work of the engine beside heat, absorbed and stored energy, {what}",
            ours=float(engine[-1]),
            expected=float(damped[-1] + absorbed[-1] + stored[-1]),
            tolerance=0.005,
            unit="J",
        )
    ]
    time = step * np.arange(len(engine))
    plot = Plot(
        x_label="time, s",
        y_label="energy, J",
        curves=(
            Curve(label="work of the engine", x=time, y=engine),
            Curve(label="heat, absorbed and stored", x=time, y=damped + absorbed + stored, style="--"),
            Curve(label="stored", x=time, y=stored, style=":"),
        ),
    )
    return Finding(rows=rows, plots=[plot])


def balance(**numerics: Any) -> Finding:
    """Train and track at 350 km/h over a sine, with joints."""
    base = over_one_repeat(350, **numerics)
    return _finding(make_case(**jointed(), irregularity=SINE, numerics=base), "with joints")


def without_damping() -> Finding:
    """Nothing turns to heat: what the engine does is stored or leaves through the ends."""
    track = replace(TRACK, pad_damping=0.0, mortar_damping=0.0, roadbed_damping=0.0)
    vehicle = replace(WORN, primary_damping=0.0, secondary_damping=0.0)
    numerics = replace(over_one_repeat(350), settle=0.3, ease_in=0.2, window=0.2, spectral_radius=1.0)
    case = make_case(track=track, vehicle=vehicle, irregularity=SINE, numerics=numerics)
    return _finding(case, "without damping")
