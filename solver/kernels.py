"""Compiled passes over the track's state, all lanes at once.

``advance`` turns the displacements just solved for into the right-hand side of the next step, in one pass: the
state between two steps is the pair of predictors (see :mod:`solver.integrator`), accelerations are never stored.
"""

from typing import Any, NamedTuple

import numpy as np

from solver.arrays import Array
from solver.beam import HermiteElement
from solver.compiled import compiled
from solver.integrator import Integrator
from solver.simd import add, fma, load, scale, store, subtract, zero
from solver.track import NODE, TrackModel

Vector = Any  # lanes in a register
Lanes = tuple[float, ...]


class Stencils(NamedTuple):
    """The constant part of ``M p + C q`` and what varies along the track.

    A stencil holds ten numbers: two of a node on itself, four of a node on the next one, four on the one before.
    """

    mass: Array  # (10,), to be multiplied by mass or damping per length
    convection: Array  # (3, 10), times -m V of each beam
    inertia: Array  # (3,) mass per length of rail, slab, base
    mortar_damping: float
    roadbed_damping: float
    pad_damping: float
    elements_per_pad: int
    pad_element: Array  # (phases,)
    pad_weights: Array  # (phases, 4)
    absorbing_nodes: Array  # nodes that lose velocity in every step
    absorption: Array  # (nodes, 2) what a step leaves of it, and the slope of that


def stencils(model: TrackModel, step: float) -> Stencils:
    """Stencils of a track for a step (s)."""
    t, e, speed = model.case.track, model.element, model.case.speed
    inertia = np.array([t.rail_mass, t.slab_mass, t.base_mass])
    absorption = model.absorption(step)
    pads = [model.pad_location(phase) for phase in range(model.case.phases)]
    return Stencils(
        mass=_mass_stencil(e),
        convection=-speed * inertia[:, None] * _convection_stencil(e),
        inertia=inertia,
        mortar_damping=t.mortar_damping,
        roadbed_damping=t.roadbed_damping,
        pad_damping=t.pad_damping,
        elements_per_pad=model.case.numerics.elements_per_pad,
        pad_element=np.array([element for element, _ in pads]),
        pad_weights=np.array([model.shape(xi) for _, xi in pads]),
        absorbing_nodes=np.flatnonzero(absorption[:, 0] < 1),
        absorption=absorption,
    )


def _mass_stencil(element: HermiteElement) -> Array:
    m = element.mass
    return np.r_[m[0, 0] + m[2, 2], m[1, 1] + m[3, 3], m[2:, :2].ravel(), m[:2, 2:].ravel()]


def _convection_stencil(element: HermiteElement) -> Array:
    c = element.convection  # skew: a node acts on itself only from value to slope and back
    return np.r_[c[0, 1] + c[2, 3], c[1, 0] + c[3, 2], c[2:, :2].ravel(), c[:2, 2:].ravel()]


@compiled
def _spread(m: Array, g: Array, s0: Vector, s1: Vector, q0: Vector, q1: Vector) -> tuple[Vector, ...]:
    """What a beam's node adds to the node before, itself and the node after, for ``mass s + convection q``."""
    before0 = fma(m[6], s0, fma(m[7], s1, fma(g[6], q0, scale(g[7], q1))))
    before1 = fma(m[8], s0, fma(m[9], s1, fma(g[8], q0, scale(g[9], q1))))
    own0 = fma(m[0], s0, scale(g[0], q1))
    own1 = fma(m[1], s1, scale(g[1], q0))
    after0 = fma(m[2], s0, fma(m[3], s1, fma(g[2], q0, scale(g[3], q1))))
    after1 = fma(m[4], s0, fma(m[5], s1, fma(g[4], q0, scale(g[5], q1))))
    return before0, before1, own0, own1, after0, after1


@compiled
def _step(k: Integrator, x: Array, u: Array, v: Array, row: int, lanes: Lanes) -> tuple[Vector, Vector]:
    """Update the predictors of one row; return its p and q."""
    pu = load(u, row, lanes)
    displacement = load(x, row, lanes)
    acceleration = scale(k.acceleration, subtract(displacement, pu))
    velocity = fma(k.velocity, acceleration, load(v, row, lanes))
    pu = fma(k.step, velocity, fma(k.drift, acceleration, displacement))
    pv = fma(k.kick, acceleration, velocity)
    store(u, row, pu)
    store(v, row, pv)
    return fma(-k.alpha, acceleration, scale(k.inertia, pu)), subtract(scale(k.damping, pu), pv)


@compiled
def advance(k: Integrator, c: Stencils, phase: int, x: Array, u: Array, v: Array, r: Array, lanes: Lanes) -> None:
    """One step's solution to the next step's right-hand side.

    Parameters
    ----------
    k : Integrator
    c : Stencils
    phase : int
        Phase of the next step.
    x : ndarray, shape (unknowns, lanes)
        Displacements at the end of the step.
    u, v : ndarray, shape (unknowns, lanes)
        Predictors of displacement and velocity, updated.
    r : ndarray, shape (unknowns, lanes)
        Right-hand side of the next step, without the wheels; may be ``x``.
    lanes : tuple of float
        As many as there are lanes.
    """
    none = zero(lanes)
    # What waits for the node before (h) and what the node before left for this one (a): w, w', z, z', y, y'.
    h0 = h1 = h2 = h3 = h4 = h5 = none
    a0 = a1 = a2 = a3 = a4 = a5 = none
    nodes = x.shape[0] // NODE
    for node in range(nodes):
        row = NODE * node
        p0, q0 = _step(k, x, u, v, row, lanes)
        p1, q1 = _step(k, x, u, v, row + 1, lanes)
        b0, b1, o0, o1, n0, n1 = _spread(
            c.mass, c.convection[0], scale(c.inertia[0], p0), scale(c.inertia[0], p1), q0, q1
        )
        p2, q2 = _step(k, x, u, v, row + 2, lanes)
        p3, q3 = _step(k, x, u, v, row + 3, lanes)
        p4, q4 = _step(k, x, u, v, row + 4, lanes)
        p5, q5 = _step(k, x, u, v, row + 5, lanes)
        d0 = scale(c.mortar_damping, subtract(q2, q4))
        d1 = scale(c.mortar_damping, subtract(q3, q5))
        b2, b3, o2, o3, n2, n3 = _spread(
            c.mass, c.convection[1], fma(c.inertia[1], p2, d0), fma(c.inertia[1], p3, d1), q2, q3
        )
        s4 = subtract(fma(c.inertia[2], p4, scale(c.roadbed_damping, q4)), d0)
        s5 = subtract(fma(c.inertia[2], p5, scale(c.roadbed_damping, q5)), d1)
        b4, b5, o4, o5, n4, n5 = _spread(c.mass, c.convection[2], s4, s5, q4, q5)
        if node > 0:
            store(r, row - 6, add(h0, b0))
            store(r, row - 5, add(h1, b1))
            store(r, row - 4, add(h2, b2))
            store(r, row - 3, add(h3, b3))
            store(r, row - 2, add(h4, b4))
            store(r, row - 1, add(h5, b5))
        h0, h1, h2, h3, h4, h5 = add(a0, o0), add(a1, o1), add(a2, o2), add(a3, o3), add(a4, o4), add(a5, o5)
        a0, a1, a2, a3, a4, a5 = n0, n1, n2, n3, n4, n5
    row = NODE * (nodes - 1)
    store(r, row, h0)
    store(r, row + 1, h1)
    store(r, row + 2, h2)
    store(r, row + 3, h3)
    store(r, row + 4, h4)
    store(r, row + 5, h5)
    _add_pads(k, c, phase, u, v, r, lanes)
    for i in range(NODE):
        store(r, i, none)


@compiled
def _q(k: Integrator, u: Array, v: Array, row: int, lanes: Lanes) -> Vector:
    return subtract(scale(k.damping, load(u, row, lanes)), load(v, row, lanes))


@compiled
def _stretch(k: Integrator, u: Array, v: Array, row: int, lanes: Lanes) -> Vector:
    """Q of the rail relative to the slab."""
    return subtract(_q(k, u, v, row, lanes), _q(k, u, v, row + 2, lanes))


@compiled
def _accumulate(r: Array, row: int, factor: float, vector: Vector, lanes: Lanes) -> None:
    store(r, row, fma(factor, vector, load(r, row, lanes)))


@compiled
def _add_pads(k: Integrator, c: Stencils, phase: int, u: Array, v: Array, r: Array, lanes: Lanes) -> None:
    """Dampers of the pads at a phase."""
    n = c.pad_weights[phase]
    for first in range(NODE * c.pad_element[phase], r.shape[0], NODE * c.elements_per_pad):
        stretch = fma(n[0], _stretch(k, u, v, first, lanes), scale(n[1], _stretch(k, u, v, first + 1, lanes)))
        targets = 2  # the node after the last is clamped and left out
        if first + NODE < r.shape[0]:
            stretch = fma(n[2], _stretch(k, u, v, first + 6, lanes), stretch)
            stretch = fma(n[3], _stretch(k, u, v, first + 7, lanes), stretch)
            targets = 4
        force = scale(c.pad_damping, stretch)
        for i in range(targets):
            target = first + NODE * (i // 2) + i % 2
            _accumulate(r, target, n[i], force, lanes)
            _accumulate(r, target + 2, -n[i], force, lanes)


@compiled
def _rate(k: Integrator, x: Array, u: Array, row: int, lanes: Lanes) -> Vector:
    """What a step's acceleration adds to the velocity predicted for its end."""
    return scale(k.velocity * k.acceleration, subtract(load(x, row, lanes), load(u, row, lanes)))


@compiled
def absorb(k: Integrator, c: Stencils, x: Array, u: Array, v: Array, lanes: Lanes) -> None:
    """Take away the part of the velocity at the end of a step that the track's ends absorb.

    Parameters
    ----------
    x : ndarray, shape (unknowns, lanes)
        Displacements at the end of the step.
    u, v : ndarray, shape (unknowns, lanes)
        Predictors of displacement and velocity; the latter is updated.
    """
    for node in c.absorbing_nodes:
        left, slope = c.absorption[node, 0], c.absorption[node, 1]
        for row in range(NODE * node, NODE * node + NODE, 2):
            rate0, rate1 = _rate(k, x, u, row, lanes), _rate(k, x, u, row + 1, lanes)
            velocity0, velocity1 = add(load(v, row, lanes), rate0), add(load(v, row + 1, lanes), rate1)
            store(v, row, subtract(scale(left, velocity0), rate0))
            store(v, row + 1, subtract(fma(left, velocity1, scale(slope, velocity0)), rate1))


@compiled
def add_window(x: Array, window: Array, start: int, force: Vector, lanes: Lanes) -> None:
    """Add a wheel's window, times its force in every lane, to the displacements."""
    for i in range(window.shape[0]):
        store(x, start + i, fma(window[i], force, load(x, start + i, lanes)))
