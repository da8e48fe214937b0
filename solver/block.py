"""A block of lanes: cases that share the track operator, ready to march."""

import math
from collections.abc import Sequence

import numpy as np

from solver.arrays import Array
from solver.case import Case
from solver.channels import CHANNELS, TRACK
from solver.contact import WHEELS, hertz_constant
from solver.integrator import Integrator, integrator
from solver.irregularity import sample
from solver.joint import joint_operator, joint_state
from solver.kernels import stencils
from solver.march import march
from solver.periodic import periodic_operator
from solver.record import sensors
from solver.start import static_equilibrium
from solver.state import SIZE, Operator, State, Vehicles
from solver.track import NODE, TrackModel
from solver.vehicle import vehicle_matrices, wheel_positions

MAX_LANES = 8
LIMIT = 0.1  # m of rail displacement beyond which a run has diverged


def lane_width(cases: int) -> int:
    """Lanes of a block that holds some cases: a power of two, so that few widths are compiled."""
    return 1 << (cases - 1).bit_length()


class Block:
    """Up to ``MAX_LANES`` cases marching together; unused lanes repeat the last case.

    Parameters
    ----------
    cases : sequence of Case
        All with the same :meth:`Case.operator_key`.
    """

    def __init__(self, cases: Sequence[Case]) -> None:
        width = lane_width(len(cases))
        self.cases = [*cases, *(width - len(cases)) * [cases[-1]]]
        case = self.case = cases[0]
        self.model = TrackModel(case)
        self.scheme = integrator(case.time_step, case.numerics.spectral_radius)
        self.wheels = self.axles()
        self.stencils = stencils(self.model, self.scheme.step)
        self.operator = _operator(self.model, self.scheme, self.wheels)
        self.sensors = sensors(self.model, self.wheels)
        self.vehicles = _vehicles(self.cases, self.scheme)
        self.lanes = (0.0,) * width
        self.settle_steps = math.ceil(case.numerics.settle / case.time_step)
        self.window_steps = max(1, round(case.numerics.window / case.time_step))
        self.eta = self._irregularity()
        self.joints = joint_operator(self.model, self.scheme, self.operator.blocks, self.operator.block_of_cell)
        self.state = self._start()
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

    def _start(self) -> State:
        loads = self.model.unit_loads(self.wheels)
        steady = self.model.steady_response(0, loads)
        compliance = loads.T @ steady
        lanes = len(self.cases)
        at_rest = [static_equilibrium(case.vehicle, compliance) for case in self.cases]
        displacement, penetration, force = (np.array(part) for part in zip(*at_rest, strict=True))
        x = np.stack([steady @ lane for lane in force], axis=1)  # lane by lane: a lane must not know its neighbours
        return State(
            x=x,
            u=x.copy(),
            v=np.zeros_like(x),
            vehicle_u=displacement,
            vehicle_v=np.zeros((lanes, SIZE)),
            vehicle_a=np.zeros((lanes, SIZE)),
            point_a=np.zeros((2 * NODE, lanes)),
            penetration=penetration,
            force=np.ascontiguousarray(force.T),
            failed=np.zeros(lanes, bool),
        )

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
        )
        rail = out[:, :, TRACK]
        with np.errstate(invalid="ignore"):
            self.state.failed[:] |= ~(np.abs(rail) < LIMIT).all(axis=0)
        self.done = stop
        return out


def _operator(model: TrackModel, scheme: Integrator, wheels: Array) -> Operator:
    periodic = periodic_operator(model, scheme, wheels)
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


def _vehicles(cases: Sequence[Case], scheme: Integrator) -> Vehicles:
    matrices = [vehicle_matrices(case.vehicle) for case in cases]
    return Vehicles(
        solution=np.array(
            [np.linalg.inv(m.stiffness + scheme.damping * m.damping + scheme.inertia * m.mass) for m in matrices]
        ),
        mass=np.array([m.mass.diagonal() for m in matrices]),
        damping=np.array([m.damping for m in matrices]),
        weight=np.array([m.weight for m in matrices]),
        hertz=np.array([hertz_constant(case.vehicle) for case in cases]),
    )
