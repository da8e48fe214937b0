"""Compiled passes over the track's state, all lanes at once.

``advance`` turns the displacements just solved for into the right-hand side of the next step, in one pass: the
state between two steps is the pair of predictors (see :mod:`solver.integrator`), accelerations are never stored.
"""

from typing import Any, NamedTuple

import numpy as np

from solver.arrays import Array
from solver.banded import store_node
from solver.beam import HermiteElement
from solver.compiled import compiled, inlined
from solver.integrator import Integrator
from solver.segments import padded
from solver.simd import add, coefficient, fma, load, neighbours, scale, store, subtract, zero
from solver.track import NODE, TrackModel

Vector = Any  # lanes in a register
Pair = tuple[Vector, Vector]  # a beam's value and slope at a node
Lanes = tuple[float, ...]


class Stencils(NamedTuple):
    """The constant part of ``M p + C q`` and what varies along the track.

    ``p`` and ``q`` are kept without the integrator's factors ``inertia`` and ``damping``; these are in here.
    """

    mass: Array  # (5,) a node on itself and on its neighbours, per mass per length
    convection: Array  # (3, 4) the same of each beam for the rate at which the track runs through the mesh
    inertia: Array  # (3,) mass per length of rail, slab, base
    mortar_damping: float
    roadbed_damping: float
    pad_damping: float
    elements_per_pad: int
    pad_element: Array  # (phases,)
    pad_weights: Array  # (phases, 4)
    unknowns: int  # of the track; arrays that are cut into segments may be longer
    left: Array  # (unknowns, padded) what a step leaves of a node's velocity and, in every second row, its slope, 1/m


def stencils(model: TrackModel, scheme: Integrator) -> Stencils:
    """Stencils of a track for an integrator."""
    t, e, speed = model.case.track, model.element, model.case.speed
    inertia = np.array([t.rail_mass, t.slab_mass, t.base_mass])
    absorption = model.absorption(scheme.step)
    left = np.zeros(padded(NODE * len(absorption)))
    left[: NODE * len(absorption)] = np.tile(absorption, NODE // 2).ravel()
    pads = [model.pad_location(phase) for phase in range(model.case.phases)]
    return Stencils(
        mass=_mass_stencil(e),
        convection=-speed * scheme.damping * inertia[:, None] * _convection_stencil(e),
        inertia=scheme.inertia * inertia,
        mortar_damping=scheme.damping * t.mortar_damping,
        roadbed_damping=scheme.damping * t.roadbed_damping,
        pad_damping=scheme.damping * t.pad_damping,
        elements_per_pad=model.case.numerics.elements_per_pad,
        pad_element=np.array([element for element, _ in pads]),
        pad_weights=np.array([model.shape(xi) for _, xi in pads]),
        unknowns=NODE * len(absorption),
        left=left,
    )


def _mass_stencil(element: HermiteElement) -> Array:
    m = element.mass  # an element seen in a mirror is the same element, so five of ten numbers say it all
    return np.array([m[0, 0] + m[2, 2], m[1, 1] + m[3, 3], m[2, 0], m[2, 1], m[3, 1]])


def _convection_stencil(element: HermiteElement) -> Array:
    c = element.convection  # skew: a node acts on itself only from value to slope and back
    return np.array([c[0, 1] + c[2, 3], c[2, 0], c[2, 1], c[3, 1]])


@inlined
def _spread(m: Array, c: Array, s: Pair, q: Pair, waiting: Pair, passed: Pair) -> tuple[Pair, Pair, Pair]:
    """Add ``mass s + convection q`` of a beam's node to the node before, to itself and to the node after.

    What a node does to its neighbours has a part that is the same on both sides and one that changes its sign.

    Parameters
    ----------
    m, c
        Stencils.
    s, q
        Value and slope at the node.
    waiting
        Of the node before, all but this node's part.
    passed
        The part of the node before in this node.

    Returns
    -------
    before, own, after
        The node before; this node but for the next one's part; this node's part in the next one.
    """
    even0, odd0 = fma(m[2], s[0], scale(c[2], q[1])), fma(m[3], s[1], scale(c[1], q[0]))
    even1, odd1 = fma(m[4], s[1], scale(-c[2], q[0])), fma(-m[3], s[0], scale(c[3], q[1]))
    before = subtract(add(waiting[0], even0), odd0), subtract(add(waiting[1], even1), odd1)
    own = fma(m[0], s[0], fma(c[0], q[1], passed[0])), fma(m[1], s[1], fma(-c[0], q[0], passed[1]))
    return before, own, (add(even0, odd0), add(even1, odd1))


@inlined
def moved(
    k: Integrator, x: Array, u: Array, v: Array, row: int, left: Any, lanes: Any
) -> tuple[Pair, Pair, Pair, Pair]:
    """Value and slope of a beam at a node from one step to the next.

    Parameters
    ----------
    x, u, v : ndarray, shape (unknowns, lanes)
        Displacements at the end of the step, and what was predicted for it.
    row : int
        Of the value; that of the slope follows.
    left : pair of float or Vector
        What is left of the velocity here, and its slope.

    Returns
    -------
    pu, pv, p, q : Pair
        Predictors for the next step, and what they add to its right-hand side: p without the factor ``inertia``, q
        without the factor ``damping``.
    """
    x0, x1 = load(x, row, lanes), load(x, row + 1, lanes)
    change0, change1 = subtract(x0, load(u, row, lanes)), subtract(x1, load(u, row + 1, lanes))
    gain, drift, kick = k.velocity * k.acceleration, k.drift * k.acceleration, k.kick * k.acceleration
    rate0, rate1 = fma(gain, change0, load(v, row, lanes)), fma(gain, change1, load(v, row + 1, lanes))
    rate0, rate1 = scale(left[0], rate0), fma(left[0], rate1, scale(left[1], rate0))
    pu = fma(k.step, rate0, fma(drift, change0, x0)), fma(k.step, rate1, fma(drift, change1, x1))
    pv = fma(kick, change0, rate0), fma(kick, change1, rate1)
    p = fma(k.retained, change0, pu[0]), fma(k.retained, change1, pu[1])
    q = fma(k.per_damping, pv[0], pu[0]), fma(k.per_damping, pv[1], pu[1])
    return pu, pv, p, q


@inlined
def _step(k: Integrator, x: Array, u: Array, v: Array, row: int, left: Pair, lanes: Lanes) -> tuple[Pair, Pair]:
    """Update the predictors of a beam's value and slope at a node; return p and q."""
    pu, pv, p, q = moved(k, x, u, v, row, left, lanes)
    store(u, row, pu[0], lanes)
    store(u, row + 1, pu[1], lanes)
    store(v, row, pv[0], lanes)
    store(v, row + 1, pv[1], lanes)
    return p, q


@compiled
def advance(
    k: Integrator, c: Stencils, phase: int, x: Array, u: Array, v: Array, lanes: Lanes, along: Lanes | tuple[int, ...]
) -> None:
    """One step's solution to the next step's right-hand side, in one pass.

    On the way the track's ends take away a part of the velocity.

    Parameters
    ----------
    k : Integrator
    c : Stencils
    phase : int
        Phase of the next step.
    x : ndarray, shape (unknowns, lanes)
        Displacements at the end of the step in; right-hand side of the next step, without the wheels, out.
    u, v : ndarray, shape (unknowns, lanes)
        Predictors of displacement and velocity, updated.
    lanes : tuple of float
        As many as there are lanes.
    along : tuple of float or int
        The same, or one lane cut into segments, to which the arrays are padded.
    """
    none = zero(along)
    waiting0 = waiting1 = waiting2 = passed0 = passed1 = passed2 = (none, none)  # of rail, slab, base
    edges = np.empty((2 * NODE, len(along)))
    together = neighbours(along)
    nodes = x.shape[0] * x.shape[1] // (NODE * len(along))
    for node in range(nodes):
        row = NODE * node
        left = coefficient(c.left, row, along), coefficient(c.left, row + 1, along)
        p0, q0 = _step(k, x, u, v, row, left, along)
        p1, q1 = _step(k, x, u, v, row + 2, left, along)
        p2, q2 = _step(k, x, u, v, row + 4, left, along)
        s0 = scale(c.inertia[0], p0[0]), scale(c.inertia[0], p0[1])
        mortar0 = scale(c.mortar_damping, subtract(q1[0], q2[0]))
        mortar1 = scale(c.mortar_damping, subtract(q1[1], q2[1]))
        s1 = fma(c.inertia[1], p1[0], mortar0), fma(c.inertia[1], p1[1], mortar1)
        s2 = (
            fma(c.inertia[2], p2[0], subtract(scale(c.roadbed_damping, q2[0]), mortar0)),
            fma(c.inertia[2], p2[1], subtract(scale(c.roadbed_damping, q2[1]), mortar1)),
        )
        before0, waiting0, passed0 = _spread(c.mass, c.convection[0], s0, q0, waiting0, passed0)
        before1, waiting1, passed1 = _spread(c.mass, c.convection[1], s1, q1, waiting1, passed1)
        before2, waiting2, passed2 = _spread(c.mass, c.convection[2], s2, q2, waiting2, passed2)
        if node > 0:
            store_node(x, row - NODE, (*before0, *before1, *before2), along)
        else:
            store_node(edges, 0, (*before0, *before1, *before2), together)
    store_node(x, NODE * (nodes - 1), (*waiting0, *waiting1, *waiting2), along)
    store_node(edges, NODE, (*passed0, *passed1, *passed2), together)
    if x.shape[1] < len(along):
        _join(edges, x)
    _add_pads(k, c, phase, u, v, x, lanes)
    for lane in range(x.shape[1]):
        for row in range(NODE):
            x[row, lane] = 0.0
        for row in range(c.unknowns, x.shape[0]):
            x[row, lane] = 0.0


@compiled
def _join(edges: Array, r: Array) -> None:
    """Give segments what their neighbours' outer nodes add to them; rows beyond the track's stay zero."""
    rows = r.shape[0] // edges.shape[1]
    for segment in range(1, edges.shape[1]):
        for i in range(NODE):
            r[segment * rows - NODE + i, 0] += edges[i, segment]
            r[segment * rows + i, 0] += edges[NODE + i, segment - 1]


@inlined
def _q(k: Integrator, u: Array, v: Array, row: int, lanes: Lanes) -> Vector:
    return fma(k.per_damping, load(v, row, lanes), load(u, row, lanes))


@inlined
def _stretch(k: Integrator, u: Array, v: Array, row: int, lanes: Lanes) -> Vector:
    """Q of the rail relative to the slab."""
    return subtract(_q(k, u, v, row, lanes), _q(k, u, v, row + 2, lanes))


@inlined
def _accumulate(r: Array, row: int, factor: float, vector: Vector, lanes: Lanes) -> None:
    store(r, row, fma(factor, vector, load(r, row, lanes)), lanes)


@compiled
def _add_pads(k: Integrator, c: Stencils, phase: int, u: Array, v: Array, r: Array, lanes: Lanes) -> None:
    """Dampers of the pads at a phase."""
    n = c.pad_weights[phase]
    for first in range(NODE * c.pad_element[phase], c.unknowns, NODE * c.elements_per_pad):
        stretch = fma(n[0], _stretch(k, u, v, first, lanes), scale(n[1], _stretch(k, u, v, first + 1, lanes)))
        targets = 2  # the node after the last is clamped and left out
        if first + NODE < c.unknowns:
            stretch = fma(n[2], _stretch(k, u, v, first + 6, lanes), stretch)
            stretch = fma(n[3], _stretch(k, u, v, first + 7, lanes), stretch)
            targets = 4
        force = scale(c.pad_damping, stretch)
        for i in range(targets):
            target = first + NODE * (i // 2) + i % 2
            _accumulate(r, target, n[i], force, lanes)
            _accumulate(r, target + 2, -n[i], force, lanes)


@compiled
def add_window(x: Array, window: Array, start: int, force: Vector, lanes: Lanes) -> None:
    """Add a window, times a force in every lane, to the displacements."""
    for i in range(window.shape[0]):
        store(x, start + i, fma(window[i], force, load(x, start + i, lanes)), lanes)
