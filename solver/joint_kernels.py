"""Compiled passes over the joints, all lanes at once.

Joints keep their unknowns in a ring of slots: joint i uses slot ``i % joints``, and when the last joint behind leaves
the window its slot serves the next one ahead. The two unknowns of slot s are rows 2 s and 2 s + 1.
"""

from typing import NamedTuple

from solver.arrays import Array
from solver.compiled import compiled
from solver.integrator import Integrator
from solver.kernels import Lanes, Stencils, Vector, moved
from solver.simd import add, fma, load, scale, store, subtract, zero

# A joint does not open at once where it enters the window, nor close at once where it leaves: springs hold it that
# lose this many powers of ten, half of them above the slab's own stiffness, over so many cells.
LOCKED_CELLS = 10
LOCK_DECADES = 4


class Joints(NamedTuple):
    """Templates (see :class:`solver.joint.JointTemplates`) and the window of cells in which joints are open."""

    element: Array
    place: Array
    cell_shift: Array
    rows: Array
    column: Array
    row: Array
    own: Array
    probe: Array
    window: Array
    window_lead: int
    remainder: Array
    coupling: Array
    sweeps: int
    lock: Array
    wheel_cell: int
    first_cell: int
    joints: int
    pads_per_slab: int
    slab_rows: int  # of the mesh, from joint to joint
    elements_per_pad: int
    fade_elements: float  # over which the shape functions fade
    fade_length: float  # the same, m
    shear_stiffness: float
    shear_damping: float
    kept_velocity: Array  # (nodes,) what the track's ends leave of a velocity in a step


class JointState(NamedTuple):
    """Unknowns of all slots, shape (2 joints, lanes), and the joints' side of the right-hand side."""

    g: Array
    x: Array
    u: Array
    v: Array
    a: Array
    response: Array  # (2 joints, 4 wheels): answer of the joints to unit wheel forces
    reported: Array  # (2 joints, lanes): accelerations in equilibrium
    inverse: Array  # (joints, 2, 2): inverse of each joint's own equations


@compiled
def first_joint(c: Joints, step: int) -> int:
    """Number of the last joint behind that is open at a step."""
    phases = c.element.shape[0]
    ahead = c.first_cell - c.wheel_cell - c.cell_shift[step % phases] + step // phases
    return -(-ahead // c.pads_per_slab)


@compiled
def joint_row(c: Joints, step: int, joint: int) -> int:
    """First row of the nodes around a joint at a step."""
    phases = c.element.shape[0]
    cell = c.wheel_cell + c.cell_shift[step % phases] - step // phases + joint * c.pads_per_slab
    return 6 * (cell * c.elements_per_pad + c.element[step % phases])


@compiled
def shapes_at(c: Joints, step: int, element: int, xi: float, out: Array) -> int:
    """Shape functions of the joint that reaches a place in the mesh: values and curvatures.

    Parameters
    ----------
    element, xi
        The place.
    out : ndarray, shape (2, 2)
        Values and second derivatives of both shape functions.

    Returns
    -------
    int
        First row of the joint, or -1 where none reaches.
    """
    first, n, d = first_joint(c, step), c.joints, c.fade_length
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        ahead = element + xi - (start + (joint - first) * c.slab_rows) / 6 - c.place[step % c.element.shape[0]]
        s = ahead / c.fade_elements
        if 0.0 <= s < 1.0:
            fade = 1 - s**4 * (35 - s * (84 - s * (70 - 20 * s)))
            slope = -140 * (s * (1 - s)) ** 3
            bend = -420 * (s * (1 - s)) ** 2 * (1 - 2 * s)
            out[0, 0], out[0, 1] = fade, d * s * fade
            out[1, 0], out[1, 1] = bend / d**2, (2 * slope + s * bend) / d
            return 2 * (joint % n)
    return -1


@compiled
def invert_joints(c: Joints, state: JointState, step: int) -> None:
    """Inverse of every joint's own equations; near the ends springs hold it that fade as it comes nearer."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    m = c.remainder[phase]
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        at = (start + (joint - first) * c.slab_rows) / 6 + c.place[phase]
        cell = at / c.elements_per_pad - c.first_cell
        part = min(cell, n * c.pads_per_slab - cell) / LOCKED_CELLS
        held = 10.0 ** (LOCK_DECADES * (1 - 2 * part)) - 10.0**-LOCK_DECADES if part < 1 else 0.0
        a, d = m[0, 0] + held * c.lock[0], m[1, 1] + held * c.lock[1]
        determinant = a * d - m[0, 1] * m[1, 0]
        inverse = state.inverse[joint % n]
        inverse[0, 0], inverse[1, 1] = d / determinant, a / determinant
        inverse[0, 1], inverse[1, 0] = -m[0, 1] / determinant, -m[1, 0] / determinant


@compiled
def solve_joints(c: Joints, state: JointState, step: int, x: Array, lanes: Lanes) -> None:
    """Jumps of all joints for the track's displacements without them, which stay as they are."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    probe, rows = c.probe[phase], c.rows[phase]
    invert_joints(c, state, step)
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        slot, row = 2 * (joint % n), start + (joint - first) * c.slab_rows
        inverse = state.inverse[joint % n]
        h0, h1 = load(state.g, slot, lanes), load(state.g, slot + 1, lanes)
        for i in range(probe.shape[0]):
            displacement = load(x, row + rows[i], lanes)
            h0 = fma(-probe[i, 0], displacement, h0)
            h1 = fma(-probe[i, 1], displacement, h1)
        store(state.x, slot, fma(inverse[0, 0], h0, scale(inverse[0, 1], h1)), lanes)
        store(state.x, slot + 1, fma(inverse[1, 0], h0, scale(inverse[1, 1], h1)), lanes)
    if c.sweeps:
        _settle_neighbours(c, state.inverse, state.x, state.x.copy(), phase, first, lanes)


@compiled
def _settle_neighbours(c: Joints, inverse: Array, x: Array, alone: Array, phase: int, first: int, lanes: Lanes) -> None:
    """Gauss-Seidel over the weak coupling of joints of short slabs."""
    n, reach = c.joints, c.coupling.shape[1] // 2
    for _ in range(c.sweeps):
        for joint in range(first, first + n):
            slot, own = 2 * (joint % n), inverse[joint % n]
            h0 = h1 = zero(lanes)
            for other in range(max(first, joint - reach), min(first + n, joint + reach + 1)):
                if other != joint:
                    k = c.coupling[phase, other - joint + reach]
                    o0, o1 = load(x, 2 * (other % n), lanes), load(x, 2 * (other % n) + 1, lanes)
                    h0 = fma(k[0, 0], o0, fma(k[0, 1], o1, h0))
                    h1 = fma(k[1, 0], o0, fma(k[1, 1], o1, h1))
            store(x, slot, fma(own[0, 0], h0, fma(own[0, 1], h1, load(alone, slot, lanes))), lanes)
            store(x, slot + 1, fma(own[1, 0], h0, fma(own[1, 1], h1, load(alone, slot + 1, lanes))), lanes)


@compiled
def respond_to_wheels(
    c: Joints, state: JointState, step: int, windows: Array, window_start: Array, compliance: Array, rail: Array
) -> None:
    """Answer of the joints to unit wheel forces, and what it adds to the compliances between the wheels.

    Parameters
    ----------
    windows, window_start
        Of the wheels at this phase.
    compliance : ndarray, shape (4, 4)
        Updated.
    rail : ndarray, shape (2 joints, 4)
        Out: rail displacement under each wheel for unit jumps, of which the windows are subtracted.
    """
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    wheels, length = windows.shape
    probe, rows, response = c.probe[phase], c.rows[phase], state.response
    response[:] = 0.0
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        slot, row = 2 * (joint % n), start + (joint - first) * c.slab_rows
        inverse = state.inverse[joint % n]
        for wheel in range(wheels):
            begin = row - window_start[wheel]
            h0 = h1 = 0.0
            if begin + 6 * probe.shape[0] < 0 or begin > length:
                continue
            for i in range(probe.shape[0]):
                at = begin + rows[i]
                if 0 <= at < length:
                    h0 -= probe[i, 0] * windows[wheel, at]
                    h1 -= probe[i, 1] * windows[wheel, at]
            response[slot, wheel] = inverse[0, 0] * h0 + inverse[0, 1] * h1
            response[slot + 1, wheel] = inverse[1, 0] * h0 + inverse[1, 1] * h1
    if c.sweeps:
        _settle_neighbours(c, state.inverse, response, response.copy(), phase, first, (0.0, 0.0, 0.0, 0.0))
    for i in range(wheels):
        for j in range(wheels):
            for unknown in range(2 * n):
                compliance[i, j] -= rail[unknown, i] * response[unknown, j]


@compiled
def rail_under_wheels(c: Joints, step: int, wheel_row: Array, wheel_shape: Array, rail: Array) -> None:
    """Rail displacement (2 joints, 4) under each wheel for unit jumps, as it is to be subtracted."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    window = c.window[phase]
    rail[:] = 0.0
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        slot, begin = 2 * (joint % n), start + (joint - first) * c.slab_rows - c.window_lead
        for wheel in range(wheel_row.shape[0]):
            at = wheel_row[wheel] - begin
            if at >= 0 and at + 8 <= window.shape[1]:
                for unknown in range(2):
                    rail[slot + unknown, wheel] = (
                        wheel_shape[wheel, 0] * window[unknown, at]
                        + wheel_shape[wheel, 1] * window[unknown, at + 1]
                        + wheel_shape[wheel, 2] * window[unknown, at + 6]
                        + wheel_shape[wheel, 3] * window[unknown, at + 7]
                    )


@compiled
def open_joints(c: Joints, state: JointState, step: int, x: Array, force: Array, lanes: Lanes) -> None:
    """Finish the jumps under the wheels' forces and add them to the track."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    window = c.window[phase]
    for joint in range(first, first + n):
        slot = 2 * (joint % n)
        for unknown in range(slot, slot + 2):
            jump = load(state.x, unknown, lanes)
            for wheel in range(force.shape[0]):
                jump = fma(state.response[unknown, wheel], load(force, wheel, lanes), jump)
            store(state.x, unknown, jump, lanes)
        j0, j1 = load(state.x, slot, lanes), load(state.x, slot + 1, lanes)
        begin = joint_row(c, step, joint) - c.window_lead
        if x.shape[1] == 1:  # in a form in which the compiler fills its vectors with rows
            _open_joint(x.ravel()[begin : begin + window.shape[1]], window, state.x[slot, 0], state.x[slot + 1, 0])
            continue
        for i in range(window.shape[1]):
            store(x, begin + i, fma(-window[0, i], j0, fma(-window[1, i], j1, load(x, begin + i, lanes))), lanes)


@compiled
def _open_joint(x: Array, window: Array, jump: float, turn: float) -> None:
    for i in range(x.shape[0]):
        x[i] -= window[0, i] * jump + window[1, i] * turn


@compiled
def advance_joints(k: Integrator, c: Joints, state: JointState, step: int, lanes: Lanes) -> None:
    """Update the predictors of all slots."""
    first, n = first_joint(c, step), c.joints
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        kept = c.kept_velocity[(start + (joint - first) * c.slab_rows) // 6]
        slot = 2 * (joint % n)
        for unknown in range(slot, slot + 2):
            jump, pu = load(state.x, unknown, lanes), load(state.u, unknown, lanes)
            new = scale(k.acceleration, subtract(jump, pu))
            old = load(state.a, unknown, lanes)
            store(state.reported, unknown, fma(1 - k.alpha, new, scale(k.alpha, old)), lanes)
            velocity = scale(kept, fma(k.velocity, new, load(state.v, unknown, lanes)))
            store(state.u, unknown, fma(k.step, velocity, fma(k.drift, new, jump)), lanes)
            store(state.v, unknown, fma(k.kick, new, velocity), lanes)
            store(state.a, unknown, new, lanes)


@compiled
def hand_over(c: Joints, state: JointState, step: int) -> None:
    """Give the slot of a joint that leaves before a step to the one that enters, which starts closed and at rest."""
    first = first_joint(c, step)
    for left in range(first_joint(c, step - 1), first):
        slot = 2 * (left % c.joints)
        for unknown in range(slot, slot + 2):
            for lane in range(state.u.shape[1]):
                state.u[unknown, lane] = state.v[unknown, lane] = state.a[unknown, lane] = 0.0


@compiled
def probe_track(
    k: Integrator,
    stencils: Stencils,
    c: Joints,
    state: JointState,
    step: int,
    x: Array,
    u: Array,
    v: Array,
    lanes: Lanes,
) -> None:
    """The joints' right-hand side of a step, from the track's state before it is advanced to that step."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    row_blocks, rows = c.row[phase], c.rows[phase]
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        slot, row = 2 * (joint % n), start + (joint - first) * c.slab_rows
        p0, q0, p1, q1 = _joint_load(k, state, slot, lanes)
        m, d = c.own[0], c.own[1]
        g0 = fma(m[0, 0], p0, fma(m[0, 1], p1, fma(d[0, 0], q0, scale(d[0, 1], q1))))
        g1 = fma(m[1, 0], p0, fma(m[1, 1], p1, fma(d[1, 0], q0, scale(d[1, 1], q1))))
        for i in range(0, row_blocks.shape[1], 2):  # a value and its slope
            at = row + rows[i]
            left = stencils.left[at], stencils.left[at + 1]
            _, _, p, q = moved(k, x, u, v, at, left, lanes)
            on_p, on_q = row_blocks[0], row_blocks[1]
            g0 = fma(on_p[i, 0], p[0], fma(on_p[i + 1, 0], p[1], g0))
            g1 = fma(on_p[i, 1], p[0], fma(on_p[i + 1, 1], p[1], g1))
            g0 = fma(on_q[i, 0], q[0], fma(on_q[i + 1, 0], q[1], g0))
            g1 = fma(on_q[i, 1], q[0], fma(on_q[i + 1, 1], q[1], g1))
        store(state.g, slot, g0, lanes)
        store(state.g, slot + 1, g1, lanes)


@compiled
def _joint_load(k: Integrator, state: JointState, slot: int, lanes: Lanes) -> tuple[Vector, Vector, Vector, Vector]:
    """P and q of a joint's two unknowns."""
    u0, u1 = load(state.u, slot, lanes), load(state.u, slot + 1, lanes)
    a0, a1 = load(state.a, slot, lanes), load(state.a, slot + 1, lanes)
    p0, p1 = fma(-k.alpha, a0, scale(k.inertia, u0)), fma(-k.alpha, a1, scale(k.inertia, u1))
    q0 = subtract(scale(k.damping, u0), load(state.v, slot, lanes))
    q1 = subtract(scale(k.damping, u1), load(state.v, slot + 1, lanes))
    return p0, q0, p1, q1


@compiled
def load_track(k: Integrator, c: Joints, state: JointState, step: int, r: Array, lanes: Lanes) -> None:
    """Add what the joints contribute to the track's right-hand side of a step."""
    phase, first, n = step % c.element.shape[0], first_joint(c, step), c.joints
    column, rows = c.column[phase], c.rows[phase]
    start = joint_row(c, step, first)
    for joint in range(first, first + n):
        row = start + (joint - first) * c.slab_rows
        p0, q0, p1, q1 = _joint_load(k, state, 2 * (joint % n), lanes)
        for i in range(column.shape[1]):
            change = fma(column[0, i, 0], p0, scale(column[0, i, 1], p1))
            change = fma(column[1, i, 0], q0, fma(column[1, i, 1], q1, change))
            store(r, row + rows[i], add(load(r, row + rows[i], lanes), change), lanes)
