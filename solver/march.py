"""Time stepping of a block of lanes: the track through its cycle of phases, the vehicles, and their contacts."""

import numpy as np

from solver.arrays import Array
from solver.banded import substitute
from solver.channels import BODIES
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
    solve_joints,
)
from solver.kernels import Lanes, Stencils, add_window, advance
from solver.record import Sensors, record_joints, record_pads, record_track
from solver.segments import Segments, substitute_segments
from solver.simd import load
from solver.state import SIZE, Operator, State, Vehicles

BODY_ROWS = (0, 2, 4, 6, 7, 8, 9)  # vehicle unknowns whose accelerations are recorded
FIRST_WHEELSET = 6


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
def _solve_track(
    op: Operator,
    c: Joints,
    state: State,
    joints: JointState,
    step: int,
    rail: Array,
    compliance: Array,
    lanes: Lanes,
    segments: Segments | None,
) -> None:
    """Track and joints without the wheels' forces, and what a force at one wheel does to the rail at another."""
    phase = step % op.block_of_cell.shape[0]
    if segments is None:
        substitute(op.blocks, op.block_of_cell[phase], state.x, lanes)
    else:
        substitute_segments(op.blocks, op.block_of_cell[phase], state.x, segments)
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
    k: Integrator,
    c: Stencils,
    joints: Joints,
    state: State,
    joint_state: JointState,
    step: int,
    lanes: Lanes,
    segments: Segments | None,
) -> None:
    """The state at the end of the step before to the right-hand side of a step."""
    if joints.joints > 0:
        hand_over(joints, joint_state, step)
        probe_track(k, c, joints, joint_state, step, state.x, state.u, state.v, lanes)
    phase = step % c.pad_element.shape[0]
    if segments is None:
        advance(k, c, phase, state.x, state.u, state.v, lanes, lanes)
    else:
        advance(k, c, phase, state.x, state.u, state.v, lanes, segments.nodes)
    if joints.joints > 0:
        load_track(k, joints, joint_state, step, state.x, lanes)


@compiled
def march(
    k: Integrator,
    c: Stencils,
    op: Operator,
    joints: Joints,
    sensors: Sensors,
    vehicles: Vehicles,
    state: State,
    joint_state: JointState,
    eta: Array,
    first: int,
    out: Array,
    lanes: Lanes,
    segments: Segments | None,
) -> None:
    """Take as many steps as ``eta`` and ``out`` are long.

    Parameters
    ----------
    k, c, op, joints, sensors, vehicles
        Scheme, track, what is recorded of it, and vehicles; no joints where the slab is continuous.
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
    segments : Segments, optional
        Of one lane, for the passes along the whole track.
    """
    accelerations = np.empty(SIZE)
    rail = np.empty((WHEELS, eta.shape[2]))
    compliance = np.empty((WHEELS, WHEELS))
    shapes = np.empty((2, 2))
    pads = np.empty((sensors.pads, eta.shape[2]))
    phases = op.block_of_cell.shape[0]
    for s in range(eta.shape[0]):
        step = first + s
        _advance_all(k, c, joints, state, joint_state, step, lanes, segments)
        _solve_track(op, joints, state, joint_state, step, rail, compliance, lanes, segments)
        for lane in range(eta.shape[2]):
            _couple_vehicle(k, op, vehicles, state, rail, compliance, eta[s, :, lane], lane, accelerations)
            for i in range(len(BODY_ROWS)):
                out[s, lane, BODIES + i] = accelerations[BODY_ROWS[i]]
        for wheel in range(WHEELS):
            force = load(state.force, wheel, lanes)
            add_window(state.x, op.windows[step % phases, wheel], op.window_start[wheel], force, lanes)
        if joints.joints > 0:
            open_joints(joints, joint_state, step, state.x, state.force, lanes)
            advance_joints(k, joints, joint_state, step, lanes)
        for lane in range(eta.shape[2]):
            for wheel in range(WHEELS):
                out[s, lane, wheel] = state.force[wheel, lane]
            record_track(k, sensors, op, state, lane, out[s, lane])
        if joints.joints > 0:
            record_joints(k, sensors, op, joints, state, joint_state, step, shapes, out[s])
        record_pads(k, sensors, joints, state, joint_state, step, pads, out[s], lanes)
