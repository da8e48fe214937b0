"""Time stepping of a block of lanes: the track through its cycle of phases, the vehicles, and their contacts."""

from typing import NamedTuple

import numpy as np

from solver.arrays import Array
from solver.banded import substitute
from solver.channels import BODIES, JOINTS, TRACK
from solver.compiled import compiled
from solver.contact import WHEELS, close_contacts
from solver.integrator import Integrator
from solver.joint_kernels import (
    Joints,
    JointState,
    advance_joints,
    hand_over,
    load_track,
    open_joints,
    probe_track,
    rail_under_wheels,
    respond_to_wheels,
    shapes_at,
    solve_joints,
)
from solver.kernels import Lanes, Stencils, add_window, advance
from solver.simd import load

BODY_ROWS = (0, 2, 4, 6, 7, 8, 9)  # vehicle unknowns whose accelerations are recorded
FIRST_WHEELSET = 6
SLAB_CHANNEL = TRACK + 3
SIZE = 10


class Operator(NamedTuple):
    """The track's side of a step; see :class:`solver.periodic.PeriodicOperator`."""

    blocks: Array
    block_of_cell: Array
    window_start: Array
    windows: Array
    compliance: Array
    wheel_row: Array  # (4,) first row of the two nodes around a wheel
    wheel_place: Array  # (4,) where a wheel stands in its element
    wheel_shape: Array  # (4, 4) rail shape functions under a wheel
    point_shape: Array  # (3, 4) shape functions and their first two derivatives under the first wheel
    curvature_per_force: float  # what the load inside its element adds to the rail's second derivative, 1/(m N)
    speed: float
    spacing: float  # of the pads, m


class Vehicles(NamedTuple):
    """The vehicles of all lanes."""

    solution: Array  # (lanes, 10, 10) inverse of the step's matrix
    mass: Array  # (lanes, 10)
    damping: Array  # (lanes, 10, 10)
    weight: Array  # (lanes, 10)
    hertz: Array  # (lanes,)


class State(NamedTuple):
    """Everything that changes from step to step."""

    x: Array  # (unknowns, lanes) displacements
    u: Array  # (unknowns, lanes) displacements as predicted for the end of the step
    v: Array  # (unknowns, lanes) velocities likewise
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
    rail: Array,
    compliance: Array,
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
    together = np.empty((WHEELS, WHEELS))
    for i in range(WHEELS):
        approach[i] = free[FIRST_WHEELSET + i] - rail[i, lane] - eta[i]
        for j in range(WHEELS):
            together[i, j] = compliance[i, j] + inverse[FIRST_WHEELSET + i, FIRST_WHEELSET + j]
    force = np.zeros(WHEELS)
    if not close_contacts(approach, together, vehicles.hertz[lane], state.penetration[lane], force):
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
def _rail_without_forces(op: Operator, state: State, rail: Array) -> None:
    """Rail displacement (4, lanes) under the wheels as it would be without their forces in this step."""
    for i in range(WHEELS):
        row, n = op.wheel_row[i], op.wheel_shape[i]
        for lane in range(rail.shape[1]):
            rail[i, lane] = n[0] * state.x[row, lane] + n[1] * state.x[row + 1, lane]
            rail[i, lane] += n[2] * state.x[row + 6, lane] + n[3] * state.x[row + 7, lane]


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
def _record_joints(k: Integrator, op: Operator, c: Joints, state: JointState, step: int, lane: int, out: Array) -> None:
    """What the joints add under the first wheel, and the largest opening, slope jump and shear of any joint."""
    slot, e0, e1 = shapes_at(c, step, op.wheel_row[0] // 6, op.wheel_place[0])
    if slot >= 0:
        length = op.spacing
        out[SLAB_CHANNEL] += e0 * state.x[slot, lane] + length * e1 * state.x[slot + 1, lane]
        out[SLAB_CHANNEL + 1] += e0 * state.reported[slot, lane] + length * e1 * state.reported[slot + 1, lane]
    out[JOINTS] = out[JOINTS + 1] = out[JOINTS + 2] = 0.0
    for joint in range(c.joints):
        jump, turn = state.x[2 * joint, lane], state.x[2 * joint + 1, lane]
        rate = state.v[2 * joint, lane] - k.kick * state.a[2 * joint, lane]
        shear = c.shear_stiffness * jump + c.shear_damping * rate
        for i, value in enumerate((jump, turn, shear)):
            if abs(value) > abs(out[JOINTS + i]):
                out[JOINTS + i] = value


@compiled
def _solve_track(
    op: Operator, c: Joints, state: State, joints: JointState, step: int, rail: Array, compliance: Array, lanes: Lanes
) -> None:
    """Track and joints without the wheels' forces, and what a force at one wheel does to the rail at another."""
    phase = step % op.block_of_cell.shape[0]
    substitute(op.blocks, op.block_of_cell[phase], state.x, lanes)
    _rail_without_forces(op, state, rail)
    for i in range(WHEELS):
        for j in range(WHEELS):  # an array assignment would compile its error messages too
            compliance[i, j] = op.compliance[phase, i, j]
    if c.joints > 0:
        solve_joints(c, joints, step, state.x, lanes)
        per_jump = np.empty((2 * c.joints, WHEELS))
        rail_under_wheels(c, step, op.wheel_row, op.wheel_shape, per_jump)
        respond_to_wheels(c, joints, step, op.windows[phase], op.window_start, compliance, per_jump)
        for unknown in range(2 * c.joints):
            for wheel in range(WHEELS):
                for lane in range(rail.shape[1]):
                    rail[wheel, lane] -= per_jump[unknown, wheel] * joints.x[unknown, lane]


@compiled
def _advance_all(
    k: Integrator, c: Stencils, joints: Joints, state: State, joint_state: JointState, step: int, lanes: Lanes
) -> None:
    """The state at the end of the step before to the right-hand side of a step."""
    if joints.joints > 0:
        hand_over(joints, joint_state, step)
        probe_track(k, joints, joint_state, step, state.x, state.u, state.v, lanes)
    advance(k, c, step % c.pad_element.shape[0], state.x, state.u, state.v, state.x, lanes)
    if joints.joints > 0:
        load_track(k, joints, joint_state, step, state.x, lanes)


@compiled
def march(
    k: Integrator,
    c: Stencils,
    op: Operator,
    joints: Joints,
    vehicles: Vehicles,
    state: State,
    joint_state: JointState,
    eta: Array,
    first: int,
    out: Array,
    lanes: Lanes,
) -> None:
    """Take as many steps as ``eta`` and ``out`` are long.

    Parameters
    ----------
    k, c, op, joints, vehicles
        Scheme, track and vehicles; no joints where the slab is continuous.
    state, joint_state
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
    rail = np.empty((WHEELS, eta.shape[2]))
    compliance = np.empty((WHEELS, WHEELS))
    phases = op.block_of_cell.shape[0]
    for s in range(eta.shape[0]):
        step = first + s
        _advance_all(k, c, joints, state, joint_state, step, lanes)
        _solve_track(op, joints, state, joint_state, step, rail, compliance, lanes)
        for lane in range(eta.shape[2]):
            _couple_vehicle(k, op, vehicles, state, rail, compliance, eta[s, :, lane], lane, accelerations)
            for i in range(len(BODY_ROWS)):
                out[s, lane, BODIES + i] = accelerations[BODY_ROWS[i]]
        for wheel in range(WHEELS):
            force = load(state.force, wheel, lanes)
            add_window(state.x, op.windows[step % phases, wheel], op.window_start[wheel], force, lanes)
        if joints.joints > 0:
            open_joints(joints, joint_state, step, state.x, state.force, lanes)
            advance_joints(k, joint_state, lanes)
        for lane in range(eta.shape[2]):
            for wheel in range(WHEELS):
                out[s, lane, wheel] = state.force[wheel, lane]
            _record_track(k, op, state, lane, out[s, lane])
            if joints.joints > 0:
                _record_joints(k, op, joints, joint_state, step, lane, out[s, lane])
