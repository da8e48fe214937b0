"""A block of lanes: cases that share the track operator, ready to march."""

import math
from collections.abc import Sequence

import numpy as np

from solver.arrays import Array, aligned_zeros
from solver.case import Case
from solver.channels import CHANNELS, TRACK
from solver.contact import WHEELS
from solver.integrator import Integrator, integrator
from solver.irregularity import sample
from solver.joint import joint_operator, joint_state
from solver.kernels import stencils
from solver.march import march
from solver.periodic import PeriodicOperator, periodic_operator
from solver.record import sensors
from solver.segments import padded, segments
from solver.simd import MAX_LANES
from solver.start import static_equilibrium
from solver.state import SIZE, Operator, State, Vehicles
from solver.track import NODE, TrackModel
from solver.vehicle import WHEELSETS, vehicle_matrices, wheel_positions
from solver.wheel import hertz_constant

FEW = 2  # cases that take less time one after the other, each in all lanes, than side by side in a block
LIMIT = 0.1  # m of rail displacement beyond which a run has diverged


def lane_width(cases: int) -> int:
    """Lanes in which to compute some of as many cases: one or all, as every width takes a while to compile."""
    return 1 if cases <= FEW else MAX_LANES


class Block:
    """Cases marching together. One alone fills the registers with segments of its track.

    Parameters
    ----------
    cases : sequence of Case
        All with the same :meth:`Case.operator_key`.
    width : int, optional
        Lanes, where there are to be more than cases: the others repeat the last case.
    """

    def __init__(self, cases: Sequence[Case], width: int | None = None) -> None:
        width = width or len(cases)
        self.cases = [*cases, *(width - len(cases)) * [cases[-1]]]
        case = self.case = cases[0]
        self.model = TrackModel(case)
        self.scheme = integrator(case.time_step, case.numerics.spectral_radius)
        self.wheels = self.axles()
        self.stencils = stencils(self.model, self.scheme)
        periodic = periodic_operator(self.model, self.scheme, self.wheels)
        self.segments = segments(periodic) if width == 1 else None
        self.operator = _operator(self.model, periodic, self.wheels)
        self.sensors = sensors(self.model, self.wheels)
        self.lanes = (0.0,) * width
        self.settle_steps = math.ceil(case.numerics.settle / case.time_step)
        self.window_steps = max(1, round(case.numerics.window / case.time_step))
        self.eta = self._irregularity()
        self.joints = joint_operator(self.model, self.scheme, self.operator.blocks, self.operator.block_of_cell)
        self.state, self.hanging = self._start()
        self.vehicles = _vehicles(self.cases, self.scheme, self.hanging)
        self.joint_state = joint_state(self.joints.joints, width)
        self.done = 0

    def axles(self) -> Array:
        """Positions of the wheelsets ahead of the vehicle's centre, m, in the order of their numbers."""
        return wheel_positions(self.case.vehicle)

    @property
    def steps(self) -> int:
        """Steps of the whole run."""
        return self.settle_steps + self.window_steps

    def track_position(self, step: Array) -> Array:
        """Position of the first wheel after some steps, m."""
        return self.case.numerics.start + step * self.case.time_step * self.case.speed

    def _irregularity(self) -> Array:
        """Irregularity under every wheel at every step, eased in, shape (steps, 4, lanes)."""
        spacing = self.case.speed * self.case.time_step
        start = self.case.numerics.start + spacing
        eta = np.empty((self.steps, WHEELS, len(self.cases)))
        for lane, case in enumerate(self.cases):
            for wheel, behind in enumerate(self.wheels - self.wheels.max()):
                eta[:, wheel, lane] = sample(case.irregularity, start + behind, spacing, self.steps)
        s = np.clip(np.arange(1, self.steps + 1) * self.case.time_step / self.case.numerics.ease_in, 0, 1)
        return eta * (s**3 * (10 - 15 * s + 6 * s**2))[:, None, None]

    def _start(self) -> tuple[State, Array]:
        """Everything at rest, and the displacements (lanes, 10) from which those of the vehicles are counted.

        Car body and bogies hang some decimetres below where their springs are slack, and move by fractions of a
        millimetre: the accelerations would be lost in the rounding of the former.
        """
        loads = self.model.unit_loads(self.wheels)
        steady = self.model.steady_response(0, loads)
        compliance = loads.T @ steady
        lanes = len(self.cases)
        at_rest = [static_equilibrium(case.vehicle, compliance) for case in self.cases]
        displacement, penetration, force = (np.array(part) for part in zip(*at_rest, strict=True))
        hanging = displacement.copy()
        hanging[:, WHEELSETS] = 0.0
        rows = len(steady) if self.segments is None else padded(len(steady))
        x, u, v = (aligned_zeros((rows, lanes)) for _ in range(3))
        for lane, at_wheels in enumerate(force):  # one by one: a lane must not know its neighbours
            x[: len(steady), lane] = steady @ at_wheels
        u[:] = x
        state = State(
            x=x,
            u=u,
            v=v,
            vehicle_u=displacement - hanging,
            vehicle_v=np.zeros((lanes, SIZE)),
            vehicle_a=np.zeros((lanes, SIZE)),
            point_a=np.zeros((2 * NODE, lanes)),
            penetration=penetration,
            force=np.ascontiguousarray(force.T),
            failed=np.zeros(lanes, bool),
        )
        return state, hanging

    def advance(self, steps: int) -> Array:
        """Take the next steps; channels of shape (steps, lanes, channels)."""
        stop = min(self.done + steps, self.steps)
        out = np.empty((stop - self.done, len(self.cases), len(CHANNELS)))
        march(
            self.scheme,
            self.stencils,
            self.operator,
            self.joints,
            self.sensors,
            self.vehicles,
            self.state,
            self.joint_state,
            self.eta[self.done : stop],
            self.done + 1,
            out,
            self.lanes,
            self.segments,
        )
        rail = out[:, :, TRACK]
        with np.errstate(invalid="ignore"):
            self.state.failed[:] |= ~(np.abs(rail) < LIMIT).all(axis=0)
        self.done = stop
        return out


def _operator(model: TrackModel, periodic: PeriodicOperator, wheels: Array) -> Operator:
    located = [model.locate(position) for position in wheels]
    length, xi = model.element.length, located[0][1]
    track = model.case.track
    # A load inside an element bends it beyond its cubic, as it bends a beam clamped at both ends.
    clamped = -2 * length * (xi * (1 - xi)) ** 2
    return Operator(
        **vars(periodic),
        wheel_row=np.array([NODE * element for element, _ in located]),
        wheel_place=np.array([place for _, place in located]),
        wheel_shape=np.array([model.shape(position) for _, position in located]),
        point_shape=np.array([model.shape(xi, derivative) for derivative in (0, 1, 2)]),
        curvature_per_force=clamped / (track.rail_elastic_modulus * track.rail_second_moment),
    )


def _vehicles(cases: Sequence[Case], scheme: Integrator, hanging: Array) -> Vehicles:
    matrices = [vehicle_matrices(case.vehicle) for case in cases]
    return Vehicles(
        solution=np.array(
            [np.linalg.inv(m.stiffness + scheme.damping * m.damping + scheme.inertia * m.mass) for m in matrices]
        ),
        mass=np.array([m.mass.diagonal() for m in matrices]),
        damping=np.array([m.damping for m in matrices]),
        weight=np.array([m.weight - m.stiffness @ u for m, u in zip(matrices, hanging, strict=True)]),
        hertz=np.array([hertz_constant(case.vehicle) for case in cases]),
    )
