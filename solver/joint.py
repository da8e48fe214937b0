"""Slab joints that ride with the track (the P-ELE of the article, with unknowns of its own).

At a joint the slab carries no moment, and shear only through a spring and a damper. Its displacement gains two unknowns
per joint, the jump J0 and the slope jump J1, with shape functions that start at the joint, are fixed to it, and fade
over a distance d ahead of it (s = distance ahead of the joint, xi = s / d)::

    E0 = 1 - S(xi),   E1 = s (1 - S(xi)),   S = 35 xi^4 - 84 xi^5 + 70 xi^6 - 20 xi^7

so ``z = N z_nodes + E J``. The nodal part stays smooth: nothing is handed over where a joint passes a node. It has to
follow the fading, so d must span many elements, or the slab hums as its joints pass from element to element. E travels
with the track, so its material derivatives are plain rates and the joint's columns hold no convective terms; the
joint's rows test the full convective expression of the nodal part.

What is built here is, per phase, the template that all joints share: their blocks of M, C and of the step's matrix
on the few nodes around them, and the window of ``A^-1`` times their columns.
"""

import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.polynomial.polynomial import polyder

from solver.arrays import Array
from solver.banded import substitute
from solver.beam import polynomials
from solver.case import CLEARANCE
from solver.errors import UnresolvedError
from solver.integrator import Integrator
from solver.joint_kernels import LOCKED_CELLS, Joints, JointState
from solver.periodic import reach
from solver.track import BASE, NODE, RAIL, SLAB, TrackModel

_FADE = [1.0, 0, 0, 0, -35, 84, -70, 20]
_SHAPES = np.array([[*_FADE, 0.0], [0.0, *_FADE]]).T  # powers, functions; that of the turn still to be multiplied by d
_DERIVATIVES = [polyder(_SHAPES, order) for order in range(4)]
_POINTS, _WEIGHTS = leggauss(9)  # exact to degree 17, the products have 16
WINDOW_TOLERANCE = 1e-10  # of a joint's window: the jumps are small, and windows are most of what joints cost


def enrichment(s: Array, length: float, derivative: int = 0) -> Array:
    """The two shape functions of a joint, or a derivative of them, at distances ahead of it.

    Parameters
    ----------
    s : ndarray
        Distance ahead of the joint, m.
    length : float
        Distance d over which they fade, m.
    derivative : int
        Order of the derivative with respect to position.

    Returns
    -------
    ndarray, shape (..., 2)
        Zero behind the joint and beyond d.
    """
    xi = np.asarray(s, float) / length
    inside = ((xi >= 0) & (xi < 1))[..., None]
    both = polynomials(_DERIVATIVES[derivative], xi)
    return np.where(inside, both * (np.array([1.0, length]) / length**derivative), 0.0)


@dataclass
class Blocks:
    """Mass, damping and stiffness between a joint and the nodes around it."""

    nodes: int
    column: Array = field(init=False)  # (3, rows, 2): nodal rows, joint columns
    row: Array = field(init=False)  # (3, rows, 2): joint rows (transposed), nodal columns
    own: Array = field(init=False)  # (3, 2, 2)

    def __post_init__(self) -> None:
        self.column, self.row = np.zeros((2, 3, NODE * self.nodes, 2))
        self.own = np.zeros((3, 2, 2))


@dataclass(frozen=True)
class JointModel:
    """The joints of a discontinuous slab, at any phase."""

    model: TrackModel

    @cached_property
    def length(self) -> float:
        """Distance over which the shape functions fade, m."""
        return self.model.case.numerics.joint_blending * self.model.case.track.pad_spacing

    @cached_property
    def nodes(self) -> int:
        """Nodes around a joint that it touches."""
        return math.ceil(round(self.length / self.model.element.length, 6)) + 2

    @cached_property
    def pads_ahead(self) -> Array:
        """Distances from a joint to the pads ahead of it where its shape functions have not faded, m."""
        t = self.model.case.track
        distance = (np.arange(1, self.nodes) - t.joint.position) * t.pad_spacing
        return distance[distance < self.length]

    def location(self, phase: int) -> tuple[int, float]:
        """Element within a cell that holds a joint, and where in it."""
        return self.model.locate_in_cell(self.model.case.track.joint.position, phase)

    def touched(self, phase: int) -> Array:
        """Unknowns, from the first node on, that a joint touches: slab and base, and the rail at the pads."""
        slab_and_base = (NODE * np.arange(self.nodes)[:, None] + np.arange(2 * SLAB, NODE)).ravel()
        elements = [self._pad_place(phase, distance)[0] for distance in self.pads_ahead]
        rail = [NODE * element + unknown for element in elements for unknown in (0, 1, NODE, NODE + 1)]
        return np.r_[slab_and_base, np.array(rail, np.int64)]

    def _pad_place(self, phase: int, distance: float) -> tuple[int, float]:
        """Element and place in it of a pad at a distance ahead of the joint."""
        _, xi = self.location(phase)
        element, place = divmod(round(xi + distance / self.model.element.length, 9), 1.0)
        return int(element), place

    def blocks(self, phase: int) -> Blocks:
        """Blocks at a phase; the first node is that before the joint."""
        blocks = Blocks(self.nodes)
        joint = self.model.case.track.joint
        _, xi = self.location(phase)
        for element in range(self.nodes - 1):
            self._integrate(blocks, element, xi)
        for distance in self.pads_ahead:
            self._add_pad(blocks, phase, distance)
        blocks.own[1, 0, 0] += joint.shear_damping
        blocks.own[2, 0, 0] += joint.shear_stiffness
        return blocks

    def _integrate(self, blocks: Blocks, element: int, xi: float) -> None:
        """Add the part of beam, mortar and inertia that lies in one element."""
        t, length, speed = self.model.case.track, self.model.element.length, self.model.case.speed
        low, high = max(element - xi, 0.0) * length, min((element + 1 - xi) * length, self.length)
        if high <= low:
            return
        s, weights = (low + high) / 2 + (high - low) / 2 * _POINTS, _WEIGHTS * (high - low) / 2
        e0, e2 = (enrichment(s, self.length, k) for k in (0, 2))
        n0, n1, n2 = (self.model.shape(s / length + xi - element, k) for k in (0, 1, 2))

        def integral(a: Array, b: Array) -> Array:
            return np.einsum("g,gi,gj->ij", weights, a, b)

        bending = t.slab_elastic_modulus * t.slab_second_moment
        slab, base = (NODE * element + np.array([0, 1, NODE, NODE + 1]) + 2 * beam for beam in (SLAB, BASE))
        same, slope = integral(n0, e0), integral(n1, e0)
        blocks.column[0, slab] += t.slab_mass * same
        blocks.column[2, slab] += bending * integral(n2, e2)
        blocks.row[0, slab] += t.slab_mass * same
        blocks.row[1, slab] += -2 * t.slab_mass * speed * slope
        blocks.row[2, slab] += bending * integral(n2, e2) + t.slab_mass * speed**2 * integral(n2, e0)
        for rows, sign in ((slab, 1), (base, -1)):
            blocks.column[1, rows] += sign * t.mortar_damping * same
            blocks.column[2, rows] += sign * t.mortar_stiffness * same
            blocks.row[1, rows] += sign * t.mortar_damping * same
            blocks.row[2, rows] += sign * (t.mortar_stiffness * same - t.mortar_damping * speed * slope)
        own = integral(e0, e0)
        blocks.own[0] += t.slab_mass * own
        blocks.own[1] += t.mortar_damping * own
        blocks.own[2] += t.mortar_stiffness * own + bending * integral(e2, e2)

    def _add_pad(self, blocks: Blocks, phase: int, distance: float) -> None:
        """Add a pad at a distance ahead of the joint."""
        t, speed = self.model.case.track, self.model.case.speed
        element, place = self._pad_place(phase, distance)
        e = enrichment(np.array(distance), self.length)
        n, slope = self.model.shape(place), self.model.shape(place, 1)
        for beam, sign in ((RAIL, -1), (SLAB, 1)):
            rows = NODE * element + np.array([0, 1, NODE, NODE + 1]) + 2 * beam
            blocks.column[1, rows] += sign * t.pad_damping * np.outer(n, e)
            blocks.column[2, rows] += sign * t.pad_stiffness * np.outer(n, e)
            blocks.row[1, rows] += sign * t.pad_damping * np.outer(n, e)
            blocks.row[2, rows] += sign * np.outer(t.pad_stiffness * n - t.pad_damping * speed * slope, e)
        blocks.own[1] += t.pad_damping * np.outer(e, e)
        blocks.own[2] += t.pad_stiffness * np.outer(e, e)


@dataclass(frozen=True)
class JointTemplates:
    """What all joints share at each phase.

    Attributes
    ----------
    element : ndarray of int, shape (phases,)
        Element within its cell that holds a joint.
    place : ndarray, shape (phases,)
        Where in that element it stands.
    cell_shift : ndarray of int, shape (phases,)
        Cells that the joint of spacing 0 is ahead of the first wheel's cell, in the first cycle of phases.
    rows : ndarray of int, shape (phases, rows)
        Unknowns that a joint touches, from its first node on.
    column : ndarray, shape (phases, 2, rows, 2)
        Mass and damping: nodal rows, joint columns.
    row : ndarray, shape (phases, 2, rows, 2)
        Mass and damping: joint rows (transposed), nodal columns, times the integrator's factors of the step's matrix.
    own : ndarray, shape (2, 2, 2)
        Mass and damping among the joint's unknowns.
    probe : ndarray, shape (phases, rows, 2)
        Joint rows (transposed) of the step's matrix.
    window : ndarray, shape (phases, 2, window rows)
        ``A^-1`` times the joint's columns.
    window_lead : int
        Rows by which a window begins before the joint's first node.
    remainder : ndarray, shape (phases, 2, 2)
        What is left of the joint's equations when the nodes are eliminated.
    coupling : ndarray, shape (phases, 2 neighbours + 1, 2, 2)
        What joints ``-neighbours … neighbours`` slabs ahead do to a joint's equations.
    sweeps : int
        Gauss-Seidel sweeps after which that coupling is solved to rounding.
    lock : ndarray, shape (2,)
        Stiffness of a slab one spacing long against a jump and a slope jump.
    """

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

    @classmethod
    def none(cls) -> "JointTemplates":
        """Templates where there are no joints."""
        integers, blocks = np.zeros(1, np.int64), np.zeros((1, 2, 0, 2))
        return cls(
            element=integers,
            place=np.zeros(1),
            cell_shift=integers,
            rows=np.zeros((1, 0), np.int64),
            column=blocks,
            row=blocks,
            own=np.zeros((2, 2, 2)),
            probe=np.zeros((1, 0, 2)),
            window=np.zeros((1, 2, 0)),
            window_lead=0,
            remainder=np.zeros((1, 2, 2)),
            coupling=np.zeros((1, 1, 2, 2)),
            sweeps=0,
            lock=np.zeros(2),
        )


def joint_templates(
    model: TrackModel, scheme: Integrator, factors_of_track: Array, block_of_cell: Array
) -> JointTemplates:
    """Templates of a track whose slabs are joined, for one integrator."""
    joints, case = JointModel(model), model.case
    per_cell, phases = case.numerics.elements_per_pad, case.phases
    factors = np.array([scheme.inertia, scheme.damping, 1.0])[:, None, None]
    span = NODE * joints.nodes
    blocks = [joints.blocks(phase) for phase in range(phases)]
    element = np.array([joints.location(phase)[0] for phase in range(phases)])
    rows = np.array([joints.touched(phase) for phase in range(phases)])
    probe = np.array([(factors * b.row).sum(axis=0) for b in blocks])
    middle = model.cells // 2
    windows, lead, tail, response = [], 0, 0, np.empty((0, 2))
    for phase in range(phases):
        first = NODE * (middle * per_cell + element[phase])
        response = np.zeros((NODE * model.cells * per_cell, 2))
        response[first : first + span] = (factors * blocks[phase].column).sum(axis=0)
        substitute(factors_of_track, block_of_cell[phase], response, (0.0, 0.0))
        if phase == 0:
            lead, tail = np.max([reach(response[:, j], first, WINDOW_TOLERANCE) for j in (0, 1)], axis=0) + NODE
        windows.append(response[first - lead : first + tail].copy())
    window = np.array(windows)
    own = (factors * blocks[0].own).sum(axis=0)
    seen = np.einsum("pri,prj->pij", probe, window[:, lead : lead + span])
    remainder = own - seen
    coupling, sweeps = _neighbours(remainder, probe, window, lead, NODE * per_cell * case.track.joint.pads_per_slab)
    bending = case.track.slab_elastic_modulus * case.track.slab_second_moment
    return JointTemplates(
        element=element,
        place=np.array([joints.location(phase)[1] for phase in range(phases)]),
        cell_shift=np.array([model.cell_shift(case.track.joint.position, phase) for phase in range(phases)]),
        rows=rows,
        column=np.array([b.column[:2, at] for b, at in zip(blocks, rows, strict=True)]),
        row=np.array([factors[:2] * b.row[:2, at] for b, at in zip(blocks, rows, strict=True)]),
        own=blocks[0].own[:2],
        probe=np.array([p[at] for p, at in zip(probe, rows, strict=True)]),
        window=np.ascontiguousarray(window.transpose(0, 2, 1)),
        window_lead=int(lead),
        remainder=remainder,
        coupling=coupling,
        sweeps=sweeps,
        lock=bending / joints.length ** np.array([3.0, 1.0]),
    )


def _neighbours(remainder: Array, probe: Array, window: Array, lead: int, slab: int) -> tuple[Array, int]:
    """Coupling between joints some slabs apart, while it is above rounding, and the sweeps that solve it."""
    phases, rows, _ = probe.shape
    inverse = np.linalg.inv(remainder)

    def seen_from(slabs: int) -> Array:
        """What a joint's equations see of another so many slabs ahead."""
        padded = np.zeros((phases, rows, 2))
        begin = lead - slabs * slab
        low, high = max(begin, 0), min(begin + rows, window.shape[1])
        if high > low:
            padded[:, low - begin : high - begin] = window[:, low:high]
        return np.einsum("pri,prj->pij", probe, padded)

    strengths: list[float] = []
    while (strength := max(np.abs(inverse @ seen_from(sign * (len(strengths) + 1))).max() for sign in (1, -1))) > 1e-13:
        strengths.append(strength)
    neighbours = len(strengths)
    coupling = np.stack(
        [seen_from(k) if k else np.zeros_like(remainder) for k in range(-neighbours, neighbours + 1)], 1
    )
    if not neighbours:
        return coupling, 0
    return coupling, min(60, int(np.ceil(np.log(1e-15) / np.log(min(4 * sum(strengths), 0.5)))))


def joint_operator(model: TrackModel, scheme: Integrator, factors: Array, block_of_cell: Array) -> Joints:
    """The joints of a track for the compiled passes; none where the slab is continuous."""
    case = model.case
    joint, per_cell, joints = case.track.joint, case.numerics.elements_per_pad, JointModel(model)
    if case.slab == "continuous":
        templates, first, count = JointTemplates.none(), 0, 0
    else:
        templates = joint_templates(model, scheme, factors, block_of_cell)
        # Open where all is periodic: where factors have settled and windows do not reach the ends of the track.
        rows = NODE * per_cell
        settled = int(block_of_cell[0, -1] - block_of_cell[0, 0])
        first = settled + math.ceil(templates.window_lead / rows) + 1
        ahead = math.ceil((templates.window.shape[2] - templates.window_lead) / rows) + 1
        count = (model.cells - ahead - first) // joint.pads_per_slab
        _require_open_joints(model, first + LOCKED_CELLS, first + count * joint.pads_per_slab - LOCKED_CELLS)
    return Joints(
        **vars(templates),
        wheel_cell=model.wheel_cell,
        first_cell=first,
        joints=count,
        pads_per_slab=joint.pads_per_slab,
        slab_rows=NODE * per_cell * joint.pads_per_slab,
        elements_per_pad=per_cell,
        fade_elements=joints.length / model.element.length,
        fade_length=joints.length,
        shear_stiffness=joint.shear_stiffness,
        shear_damping=joint.shear_damping,
        kept_velocity=np.ascontiguousarray(model.absorption(scheme.step)[:, 0]),
    )


def _require_open_joints(model: TrackModel, first: int, last: int) -> None:
    """Refuse a step or a track with which the joints around the vehicle would not all be open between two cells."""
    v, spacing = model.case.vehicle, model.case.track.pad_spacing
    clearance = CLEARANCE / spacing
    rear = model.wheel_cell - 2 * (v.half_bogie_distance + v.half_wheelbase) / spacing
    if first > rear - clearance or last < model.wheel_cell + clearance:
        raise UnresolvedError(
            f"with numerics.time_step_s = {model.case.numerics.time_step:g} s joints act on each other over so great "
            "a distance that those around the vehicle cannot all be open: a shorter step or more track is needed"
        )


def joint_state(joints: int, lanes: int) -> JointState:
    """Closed joints at rest."""
    g, x, u, v, a, reported = (np.zeros((2 * joints, lanes)) for _ in range(6))
    response, inverse = np.zeros((2 * joints, 4)), np.zeros((joints, 2, 2))
    return JointState(g=g, x=x, u=u, v=v, a=a, response=response, reported=reported, inverse=inverse)
