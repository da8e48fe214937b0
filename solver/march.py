"""Time stepping of a block of lanes: the track through its cycle of phases, the vehicles, and their contacts."""

from typing import NamedTuple

import numpy as np

from solver.arrays import Array
from solver.banded import substitute
from solver.channels import BODIES, TRACK
from solver.compiled import compiled
from solver.contact import WHEELS, close_contacts
from solver.integrator import Integrator
from solver.kernels import Stencils, add_window, advance
from solver.simd import load

BODY_ROWS = (0, 2, 4, 6, 7, 8, 9)  # vehicle unknowns whose accelerations are recorded
FIRST_WHEELSET = 6
SIZE = 10


class Operator(NamedTuple):
    """The track's side of a step; see :class:`solver.periodic.PeriodicOperator`."""

    blocks: Array
    block_of_cell: Array
    window_start: Array
    windows: Array
    compliance: Array
    wheel_row: Array  # (4,) first row of the two nodes around a wheel
    wheel_shape: Array  # (4, 4) rail shape functions under a wheel
    point_shape: Array  # (3, 4) shape functions and their first two derivatives under the first wheel
    curvature_per_force: float  # what the load inside its element adds to the rail's second derivative, 1/(m N)
    speed: float


class Vehicles(NamedTuple):
    """The vehicles of all lanes."""

    solution: Array  # (lanes, 10, 10) inverse of the step's matrix
    mass: Array  # (lanes, 10)
    damping: Array  # (lanes, 10, 10)
    weight: Array  # (lanes, 10)
    hertz: Array  # (lanes,)


class State(NamedTuple):
    """Everything that changes from step to step."""

    x: Array  # (unknowns, lanes) right-hand side of the step to come
    u: Array  # (unknowns, lanes) predicted displacements
    v: Array  # (unknowns, lanes) predicted velocities
    vehicle_u: Array  # (lanes, 10)
    vehicle_v: Array  # (lanes, 10)
    vehicle_a: Array  # (lanes, 10)
    point_a: Array  # (12, lanes) accelerations of the two nodes around the first wheel
    penetration: Array  # (lanes, 4)
    force: Array  # (4, lanes)
    failed: Array  # (lanes,)


@compiled
def _couple_vehicle(
    k: Integrator,
    op: Operator,
    vehicles: Vehicles,
    state: State,
    phase: int,
    eta: Array,
    lane: int,
    accelerations: Array,
) -> None:
    """Vehicle and contact forces of one lane at the end of the step."""
    u, v, a = state.vehicle_u[lane], state.vehicle_v[lane], state.vehicle_a[lane]
    load_ = np.empty(SIZE)
    for i in range(SIZE):
        load_[i] = vehicles.weight[lane, i] + vehicles.mass[lane, i] * (k.inertia * u[i] - k.alpha * a[i])
        for j in range(SIZE):
            load_[i] += vehicles.damping[lane, i, j] * (k.damping * u[j] - v[j])
    inverse = vehicles.solution[lane]
    free = np.empty(SIZE)
    for i in range(SIZE):
        free[i] = 0.0
        for j in range(SIZE):
            free[i] += inverse[i, j] * load_[j]
    approach = np.empty(WHEELS)
    compliance = np.empty((WHEELS, WHEELS))
    for i in range(WHEELS):
        row, n = op.wheel_row[i], op.wheel_shape[i]
        rail = n[0] * state.x[row, lane] + n[1] * state.x[row + 1, lane]
        rail += n[2] * state.x[row + 6, lane] + n[3] * state.x[row + 7, lane]
        approach[i] = free[FIRST_WHEELSET + i] - rail - eta[i]
        for j in range(WHEELS):
            compliance[i, j] = op.compliance[phase, i, j] + inverse[FIRST_WHEELSET + i, FIRST_WHEELSET + j]
    force = np.zeros(WHEELS)
    if not close_contacts(approach, compliance, vehicles.hertz[lane], state.penetration[lane], force):
        state.failed[lane] = True
    for i in range(SIZE):
        displacement = free[i]
        for j in range(WHEELS):
            displacement -= inverse[i, FIRST_WHEELSET + j] * force[j]
        new = k.acceleration * (displacement - u[i])
        accelerations[i] = (1 - k.alpha) * new + k.alpha * a[i]
        velocity = v[i] + k.velocity * new
        u[i] = displacement + k.step * velocity + k.drift * new
        v[i] = velocity + k.kick * new
        a[i] = new
    for j in range(WHEELS):
        state.force[j, lane] = force[j]


@compiled
def _record_track(k: Integrator, op: Operator, state: State, lane: int, out: Array) -> None:
    """Displacement and material acceleration of rail, slab and base under the first wheel."""
    row = op.wheel_row[0]
    n = op.point_shape
    for beam in range(3):
        displacement = moving = slope_rate = curvature = 0.0
        for i in range(4):
            local = 6 * (i // 2) + 2 * beam + i % 2
            x = state.x[row + local, lane]
            new = k.acceleration * (x - state.u[row + local, lane])
            velocity = state.v[row + local, lane] + k.velocity * new
            displacement += n[0, i] * x
            moving += n[0, i] * ((1 - k.alpha) * new + k.alpha * state.point_a[local, lane])
            slope_rate += n[1, i] * velocity
            curvature += n[2, i] * x
            state.point_a[local, lane] = new
        if beam == 0:
            curvature += op.curvature_per_force * state.force[0, lane]
        material = moving - 2 * op.speed * slope_rate + op.speed**2 * curvature
        if beam == 0:
            out[TRACK], out[TRACK + 1], out[TRACK + 2] = displacement, material, moving
        else:
            out[TRACK + 1 + 2 * beam], out[TRACK + 2 + 2 * beam] = displacement, material


@compiled
def march(
    k: Integrator,
    c: Stencils,
    op: Operator,
    vehicles: Vehicles,
    state: State,
    eta: Array,
    first: int,
    out: Array,
    lanes: tuple[float, ...],
) -> None:
    """Take as many steps as ``eta`` and ``out`` are long.

    Parameters
    ----------
    k, c, op, vehicles
        Scheme, track and vehicles.
    state : State
        Updated.
    eta : ndarray, shape (steps, 4, lanes)
        Irregularity under each wheel at the end of each step, m.
    first : int
        Number of the first step, from 1; the state is that of the step before.
    out : ndarray, shape (steps, lanes, channels)
        Channels at the end of each step, SI.
    lanes : tuple of float
        As many as there are lanes.
    """
    accelerations = np.empty(SIZE)
    phases = op.block_of_cell.shape[0]
    for s in range(eta.shape[0]):
        phase = (first + s) % phases
        substitute(op.blocks, op.block_of_cell[phase], state.x, lanes)
        for lane in range(eta.shape[2]):
            _couple_vehicle(k, op, vehicles, state, phase, eta[s, :, lane], lane, accelerations)
            for i in range(len(BODY_ROWS)):
                out[s, lane, BODIES + i] = accelerations[BODY_ROWS[i]]
        for wheel in range(WHEELS):
            force = load(state.force, wheel, lanes)
            add_window(state.x, op.windows[phase, wheel], op.window_start[wheel], force, lanes)
        for lane in range(eta.shape[2]):
            for wheel in range(WHEELS):
                out[s, lane, wheel] = state.force[wheel, lane]
            _record_track(k, op, state, lane, out[s, lane])
        advance(k, c, (first + s + 1) % phases, state.x, state.u, state.v, state.x, lanes)
