"""Compiled recorders: what a step leaves in the channels of a response."""

from typing import NamedTuple

import numpy as np

from solver.arrays import Array
from solver.channels import JOINTS, PADS, TRACK
from solver.compiled import compiled
from solver.integrator import Integrator
from solver.joint import JointModel, enrichment
from solver.joint_kernels import Joints, JointState, first_joint, shapes_at
from solver.kernels import Lanes
from solver.simd import fma, load, scale, store, subtract, zero
from solver.state import Operator, State
from solver.track import NODE, TrackModel

SLAB_CHANNEL = TRACK + 3
MOMENT_CHANNEL = TRACK + 7
BEYOND_M = 7.0  # pads are looked at under the train and as far as this beyond its outer wheels


class Sensors(NamedTuple):
    """What turns the state into forces of the track."""

    speed: float
    pad_stiffness: float
    pad_damping: float
    slab_bending: float  # stiffness, N m^2
    roadbed_stiffness: float
    roadbed_damping: float
    elements_per_pad: int
    first_cell: int  # that holds the first pad looked at
    pads: int
    element: Array  # (phases,) element within its cell that holds a pad
    shape: Array  # (phases, 3, 4) shape functions and their first two derivatives at a pad
    number: Array  # (phases,) of the first pad looked at, in the first cycle of phases
    joint_shape: Array  # (pads, 2) shape functions of a joint at the pads ahead of it
    joint_curvature: Array  # (2,) and their curvatures at the next pad


def sensors(model: TrackModel, wheels: Array) -> Sensors:
    """Sensors of a track under wheels at some positions (m)."""
    t, numerics = model.case.track, model.case.numerics
    phases = range(model.case.phases)
    located = [model.pad_location(phase) for phase in phases]
    length = numerics.elements_per_pad * model.element.length
    beyond = max(1, round(BEYOND_M / length))
    first = max(0, int((wheels.min() - model.left_end) / length) - beyond)
    last = min(model.cells - 2, int((wheels.max() - model.left_end) / length) + beyond)
    joints = JointModel(model)
    return Sensors(
        speed=model.case.speed,
        pad_stiffness=t.pad_stiffness,
        pad_damping=t.pad_damping,
        slab_bending=t.slab_elastic_modulus * t.slab_second_moment,
        roadbed_stiffness=t.roadbed_stiffness,
        roadbed_damping=t.roadbed_damping,
        elements_per_pad=numerics.elements_per_pad,
        first_cell=first,
        pads=last - first + 1,
        element=np.array([element for element, _ in located]),
        shape=np.array([[model.shape(xi, derivative) for derivative in (0, 1, 2)] for _, xi in located]),
        number=np.array([first - model.wheel_cell - model.cell_shift(0.0, phase) for phase in phases]),
        joint_shape=enrichment(joints.pads_ahead, joints.length),
        joint_curvature=enrichment(np.array((1 - t.joint.position) * t.pad_spacing), joints.length, 2),
    )


@compiled
def record_track(k: Integrator, c: Sensors, op: Operator, state: State, lane: int, out: Array) -> None:
    """Displacement and material acceleration of the beams, slab moment and roadbed reaction under the first wheel."""
    row = op.wheel_row[0]
    n = op.point_shape
    for beam in range(3):
        displacement = velocity = moving = slope = slope_rate = curvature = 0.0
        for i in range(4):
            local = 6 * (i // 2) + 2 * beam + i % 2
            x = state.x[row + local, lane]
            new = k.acceleration * (x - state.u[row + local, lane])
            rate = state.v[row + local, lane] + k.velocity * new
            displacement += n[0, i] * x
            velocity += n[0, i] * rate
            moving += n[0, i] * ((1 - k.alpha) * new + k.alpha * state.point_a[local, lane])
            slope += n[1, i] * x
            slope_rate += n[1, i] * rate
            curvature += n[2, i] * x
            state.point_a[local, lane] = new
        if beam == 0:
            curvature += op.curvature_per_force * state.force[0, lane]
        material = moving - 2 * c.speed * slope_rate + c.speed**2 * curvature
        if beam == 0:
            out[TRACK], out[TRACK + 1], out[TRACK + 2] = displacement, material, moving
        else:
            out[TRACK + 1 + 2 * beam], out[TRACK + 2 + 2 * beam] = displacement, material
        if beam == 1:
            out[MOMENT_CHANNEL] = -c.slab_bending * curvature
    material_rate = velocity - c.speed * slope  # of the base, the last beam
    out[MOMENT_CHANNEL + 1] = c.roadbed_stiffness * displacement + c.roadbed_damping * material_rate


@compiled
def record_joints(
    k: Integrator,
    c: Sensors,
    op: Operator,
    joints: Joints,
    state: State,
    joint_state: JointState,
    step: int,
    shapes: Array,
    out: Array,
) -> None:
    """What the joints add under the first wheel; the largest jumps, shear and moment of those under the train.

    ``shapes`` (2, 2) is room to work in, ``out`` has shape (lanes, channels).
    """
    slot = shapes_at(joints, step, op.wheel_row[0] // 6, op.wheel_place[0], shapes)
    if slot >= 0:
        for lane in range(out.shape[0]):
            for i in range(2):
                out[lane, SLAB_CHANNEL] += shapes[0, i] * joint_state.x[slot + i, lane]
                out[lane, SLAB_CHANNEL + 1] += shapes[0, i] * joint_state.reported[slot + i, lane]
                out[lane, MOMENT_CHANNEL] -= c.slab_bending * shapes[1, i] * joint_state.x[slot + i, lane]
    out[:, JOINTS : JOINTS + 4] = 0.0
    phases = c.element.shape[0]
    first_pad = c.number[step % phases] + step // phases
    first, n = first_joint(joints, step), joints.joints
    for joint in range(first, first + n):
        pad = joint * joints.pads_per_slab - first_pad  # behind the joint
        if pad >= 0 and pad + 1 < c.pads:
            for lane in range(out.shape[0]):
                _record_joint(k, c, joints, state, joint_state, step % phases, 2 * (joint % n), pad, lane, out)


@compiled
def _record_joint(
    k: Integrator,
    c: Sensors,
    joints: Joints,
    state: State,
    joint_state: JointState,
    phase: int,
    row: int,
    pad: int,
    lane: int,
    out: Array,
) -> None:
    """Keep what a joint has more of than those before."""
    jump, turn = joint_state.x[row, lane], joint_state.x[row + 1, lane]
    rate = joint_state.v[row, lane] - k.kick * joint_state.a[row, lane]
    shear = joints.shear_stiffness * jump + joints.shear_damping * rate
    behind = _moment(c, state, phase, pad, lane)
    opened = c.joint_curvature[0] * jump + c.joint_curvature[1] * turn
    ahead = _moment(c, state, phase, pad + 1, lane) - c.slab_bending * opened
    moment = ahead if abs(ahead) > abs(behind) else behind
    for i, value in enumerate((jump, turn, shear, moment)):
        if abs(value) > abs(out[lane, JOINTS + i]):
            out[lane, JOINTS + i] = value


@compiled
def _moment(c: Sensors, state: State, phase: int, pad: int, lane: int) -> float:
    """Slab moment at a pad without what a joint adds; positive where the underside is stretched."""
    row = NODE * ((c.first_cell + pad) * c.elements_per_pad + c.element[phase])
    curvature = 0.0
    for i in range(4):
        curvature += c.shape[phase, 2, i] * state.x[row + 6 * (i // 2) + 2 + i % 2, lane]
    return -c.slab_bending * curvature


@compiled
def _pad_forces(k: Integrator, c: Sensors, state: State, phase: int, pads: Array, lanes: Lanes) -> None:
    """Forces (pads, lanes) of the pads, compression positive, without what joints add."""
    n, gain = c.shape[phase], k.velocity * k.acceleration
    for pad in range(c.pads):
        first = NODE * ((c.first_cell + pad) * c.elements_per_pad + c.element[phase])
        force = zero(lanes)
        for i in range(4):
            row = first + 6 * (i // 2) + i % 2
            rail, slab = load(state.x, row, lanes), load(state.x, row + 2, lanes)
            rail_rate = fma(gain, subtract(rail, load(state.u, row, lanes)), load(state.v, row, lanes))
            slab_rate = fma(gain, subtract(slab, load(state.u, row + 2, lanes)), load(state.v, row + 2, lanes))
            per_stretch = c.pad_stiffness * n[0, i] - c.pad_damping * c.speed * n[1, i]
            force = fma(per_stretch, subtract(rail, slab), force)
            force = fma(c.pad_damping * n[0, i], subtract(rail_rate, slab_rate), force)
        store(pads, pad, force, lanes)


@compiled
def record_pads(
    k: Integrator,
    c: Sensors,
    joints: Joints,
    state: State,
    joint_state: JointState,
    step: int,
    pads: Array,
    out: Array,
    lanes: Lanes,
) -> None:
    """Largest force and largest pull of any pad. ``pads`` (pads, lanes) is room to work in."""
    phases = c.element.shape[0]
    _pad_forces(k, c, state, step % phases, pads, lanes)
    first_pad = c.number[step % phases] + step // phases
    first, n = first_joint(joints, step), joints.joints
    for joint in range(first, first + n):
        row = 2 * (joint % n)
        for i in range(c.joint_shape.shape[0]):
            pad = joint * joints.pads_per_slab + 1 + i - first_pad
            if 0 <= pad < c.pads:
                force = load(pads, pad, lanes)
                for j in range(2):
                    rate = fma(-k.kick, load(joint_state.a, row + j, lanes), load(joint_state.v, row + j, lanes))
                    opened = fma(c.pad_damping, rate, scale(c.pad_stiffness, load(joint_state.x, row + j, lanes)))
                    force = fma(-c.joint_shape[i, j], opened, force)
                store(pads, pad, force, lanes)
    for lane in range(pads.shape[1]):
        out[lane, PADS] = out[lane, PADS + 1] = 0.0
        for pad in range(c.pads):
            out[lane, PADS] = max(out[lane, PADS], pads[pad, lane])
            out[lane, PADS + 1] = max(out[lane, PADS + 1], -pads[pad, lane])
