"""A finite-element model that stays with the track: an independent answer to check the moving elements against.

Three beams of cubic elements with nodes at every pad and joint. At a joint the slab has two nodes, free to part and to
turn against each other, tied by the shear spring and damper alone. Wheels roll over the rail's elements, so that mass,
damping and stiffness are constant. The window of track is made of whole slabs; once the vehicle has advanced by one
slab the window follows, its unknowns handed back by one slab and the new slab at rest. Both ends absorb waves by
additional roadbed damping that rises with the cube of the way into them. These layers jump when the window does, which
sends faint waves to the vehicle: with the default layers 95 m of track raise the slab's peak acceleration by 3 %, 110 m
by nothing that can be seen.

The step is the generalized-alpha method with forces weighted as displacements are, and contact closed at its end.

References
----------
Chung and Hulbert (1993), Journal of Applied Mechanics 60, 371-375.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from scipy import sparse

from solver.arrays import Array
from solver.case import Case, Vehicle
from solver.irregularity import sample
from solver.reference.track_fixed_model import (
    build_mesh,
    factorise,
    hermite,
    hertz_constant,
    substitute,
    track_matrices,
    vehicle_matrices,
    weights,
    wheel_positions,
    whole,
)

SPECTRAL_RADIUS = 0.85  # of the integrator at infinite frequency
REACH = 6.5  # m beyond which a unit force's response within one step is below 1e-14 of that under it
WHEELSETS = slice(6, 10)
Matrix: TypeAlias = Array | sparse.csr_array


@dataclass(frozen=True, kw_only=True)
class TrackFixedResponse:
    """Histories over the steady window, SI; displacements and forces on the track positive downwards.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Time since the window began, s.
    track_position : ndarray, shape (n,)
        Position of the first wheelset along the track, m.
    force : ndarray, shape (4, n)
        Contact forces, N, front wheelset first.
    rail_displacement, slab_displacement, base_displacement : ndarray, shape (n,)
        Under the first wheelset, m; the slab's on that side of a joint where the wheelset is.
    rail_acceleration, slab_acceleration, base_acceleration : ndarray, shape (n,)
        Of the material under the first wheelset, m/s^2.
    roadbed_pressure : ndarray, shape (n,)
        Reaction of the roadbed under the first wheelset, N/m.
    pad_force, pad_uplift : ndarray, shape (n,)
        Largest compression and largest pull of any pad, N.
    joint_jump : ndarray, shape (n,)
        Displacement of the slab ahead minus that of the slab behind, m, at the joint where its magnitude is largest.
    slab_moment : ndarray, shape (n,)
        Of the moments at the pads next to joints that with the largest magnitude, N m; positive where the underside is
        stretched.
    """

    time: Array
    track_position: Array
    force: Array
    rail_displacement: Array
    slab_displacement: Array
    base_displacement: Array
    rail_acceleration: Array
    slab_acceleration: Array
    base_acceleration: Array
    roadbed_pressure: Array
    pad_force: Array
    pad_uplift: Array
    joint_jump: Array
    slab_moment: Array


def solve_track_fixed(case: Case) -> TrackFixedResponse:
    """Solve a case with its own mesh density, step and track length, the latter rounded up to slabs plus one.

    Parameters
    ----------
    case : Case
        The step is ``case.numerics.time_step`` itself; ``spectral_radius`` and ``mesh_offset`` are not used.

    Returns
    -------
    TrackFixedResponse
    """
    numerics, step = case.numerics, case.numerics.time_step
    settle, window = math.ceil(numerics.settle / step), max(1, round(numerics.window / step))
    elapsed = step * np.arange(1, settle + window + 1)
    behind = wheel_positions(case.vehicle) - wheel_positions(case.vehicle)[0]
    first = numerics.start + case.speed * elapsed[0] + behind
    ease = np.clip(elapsed / numerics.ease_in, 0, 1)
    ease = ease**3 * (10 - 15 * ease + 6 * ease**2)
    eta = ease * np.array([sample(case.irregularity, x, case.speed * step, len(elapsed)) for x in first])
    wheels = numerics.start + case.speed * elapsed + behind[:, None]

    march = _March(case, numerics.start + behind)
    records = np.empty((window, 15))
    for i in range(settle + window):
        march.step(wheels[:, i], eta[:, i])
        if i >= settle:
            records[i - settle] = march.record()
    columns = records.T
    return TrackFixedResponse(
        time=elapsed[:window],
        track_position=wheels[0, settle:],
        force=columns[:4],
        rail_displacement=columns[4],
        slab_displacement=columns[5],
        base_displacement=columns[6],
        rail_acceleration=columns[7],
        slab_acceleration=columns[8],
        base_acceleration=columns[9],
        roadbed_pressure=columns[10],
        pad_force=columns[11],
        pad_uplift=columns[12],
        joint_jump=columns[13],
        slab_moment=columns[14],
    )


def _close_contacts(gap: Array, flexibility: Array, hertz: float, penetration: Array) -> tuple[Array, Array]:
    """Penetrations and forces with ``penetration + flexibility @ force = gap`` by Newton's method."""
    for _ in range(50):
        pressed = np.sqrt(np.maximum(penetration, 0) / hertz)
        force = pressed**3
        residual = penetration + flexibility @ force - gap
        if np.abs(residual).max() < 1e-15:
            return penetration, force
        penetration = penetration - np.linalg.solve(np.eye(4) + flexibility * (1.5 * pressed / hertz), residual)
    if np.abs(residual).max() > 1e-10:
        raise ArithmeticError("contact forces do not converge")
    return penetration, force


@dataclass(frozen=True)
class _Scheme:
    """Generalized-alpha: the balance stands at ``t - alpha_f step``, with accelerations at ``t - alpha_m step``.

    States are stacked as accelerations, velocities, displacements.
    """

    step: float
    alpha_m: float = (2 * SPECTRAL_RADIUS - 1) / (SPECTRAL_RADIUS + 1)
    alpha_f: float = SPECTRAL_RADIUS / (SPECTRAL_RADIUS + 1)

    @property
    def correction(self) -> Array:
        """What an acceleration at the end of the step adds to the state (3,): Newmark's 1, gamma h, beta h^2."""
        newmark = 0.5 - self.alpha_m + self.alpha_f
        return np.array([1, newmark * self.step, (newmark + 0.5) ** 2 / 4 * self.step**2])

    @property
    def prediction(self) -> Array:
        """The state (3, 3) a step later but for that addition."""
        taylor = np.array([[1, 0, 0], [self.step, 1, 0], [self.step**2 / 2, self.step, 1]])
        return taylor - np.outer(self.correction, [1, 0, 0])

    @property
    def balance(self) -> Array:
        """The state (3, 3) of the balance but for that addition."""
        late = np.array([self.alpha_m, self.alpha_f, self.alpha_f])
        return (1 - late)[:, None] * self.prediction + np.diag(late)

    def effective(self, mass: Array, damping: Array, stiffness: Array) -> Array:
        """The matrix that maps accelerations at the end of a step to the forces left over."""
        _, velocity, displacement = (1 - self.alpha_f) * self.correction
        return (1 - self.alpha_m) * mass + velocity * damping + displacement * stiffness


class _Motion:
    """A linear system marching in time.

    Parameters
    ----------
    inner : matrix, shape (n, 3 n)
        Mass, damping and stiffness side by side.
    solve : callable
        Inverts the effective matrix.
    u : ndarray, shape (n,)
        Displacements, at rest.
    """

    def __init__(self, scheme: _Scheme, inner: Matrix, solve: Callable[[Array], Array], u: Array) -> None:
        self.inner, self.solve = inner, solve
        self.prediction, self.balance, self.correction = scheme.prediction, scheme.balance, scheme.correction
        self.late = scheme.alpha_f - scheme.alpha_m
        self.state = np.stack([np.zeros_like(u), np.zeros_like(u), u])
        self.a, self.a_before = self.state[0], self.state[0]

    @property
    def u(self) -> Array:
        """Displacements."""
        return self.state[2]

    def predict(self, load: Array) -> None:
        """Take a step under the given load alone. Contact may then add to ``a`` until :meth:`correct`."""
        self.a_before = self.a
        load -= self.inner @ (self.balance @ self.state).ravel()
        self.a = self.solve(load)
        self.state = self.prediction @ self.state

    def correct(self) -> None:
        """Complete the state by the accelerations found."""
        self.state += self.correction[:, None] * self.a

    def predicted(self, unknowns: Array | slice) -> Array:
        """Displacements if nothing is added to ``a``."""
        return self.u[unknowns] + self.correction[2] * self.a[unknowns]

    def acceleration(self, unknowns: Array) -> Array:
        """Accelerations at the end of the step: those of the method belong ``alpha_f - alpha_m`` steps earlier."""
        return (1 + self.late) * self.a[unknowns] - self.late * self.a_before[unknowns]

    def shift(self, by: int) -> None:
        """Hand everything back by some unknowns; the last ones come to rest."""
        for values in (self.state, self.a, self.a_before):
            values[..., :-by] = values[..., by:].copy()
            values[..., -by:] = 0


class _March:
    """Track and vehicle, from static equilibrium with the wheels at the given positions (m) on an even rail."""

    def __init__(self, case: Case, wheels: Array) -> None:
        self.mesh, self.scheme, self.properties = build_mesh(case), _Scheme(case.numerics.time_step), case.track
        self.elements, self.hertz = self.mesh.elements(), hertz_constant(case.vehicle)
        self.origin = self._origin_for(wheels)
        self._locate(wheels)
        self.force = np.full(4, weights(case.vehicle).sum() / 4)  # the suspension is statically determinate
        self.penetration = self.hertz * self.force ** (2 / 3)
        self._start_track(case)
        self._start_vehicle(case.vehicle)

    def _origin_for(self, wheels: Array) -> float:
        """Where the window begins, m: whole slabs away from 0, the vehicle's centre in its middle to half a slab."""
        slabs, length = round(self.mesh.x[-1] / self.mesh.slab_length), self.mesh.slab_length
        return length * math.floor(wheels.mean() / length - slabs / 2 + 0.5)

    def _locate(self, wheels: Array) -> None:
        """Find the element of every wheel and its shape functions there."""
        x = wheels - self.origin
        self.element = np.searchsorted(self.mesh.x, x, side="right") - 1
        left, right = self.mesh.x[self.element], self.mesh.x[self.element + 1]
        self.shape = hermite((x - left) / (right - left), right - left).T
        self.under = self.elements[0][self.element]

    def _load(self, force: Array) -> Array:
        load = np.zeros(self.mesh.size)
        np.add.at(load, self.under, force[:, None] * self.shape)
        return load

    def _start_track(self, case: Case) -> None:
        mesh, numerics = self.mesh, case.numerics
        middle = (mesh.x[:-1] + mesh.x[1:]) / 2
        way = np.clip(1 - np.minimum(middle, mesh.x[-1] - middle) / numerics.absorbing_length, 0, 1)
        mass, damping, stiffness = track_matrices(case.track, mesh, numerics.absorbing_damping * way**3)
        effective = self.scheme.effective(mass, damping, stiffness)
        factor = factorise(effective)

        inner = sparse.hstack([whole(mass), whole(damping), whole(stiffness)], format="csr")
        at_rest = substitute(factorise(stiffness), self._load(self.force))
        self.track = _Motion(self.scheme, inner, lambda load: substitute(factor, load), at_rest)

        # Away from the ends the inverse repeats from slab to slab: keep its columns for the rail of one slab.
        self.reach = math.ceil(REACH / mesh.slab_length)
        slab = round(mesh.x[-1] / mesh.slab_length) // 2
        around = slice((slab - self.reach) * mesh.slab_unknowns, (slab + self.reach + 1) * mesh.slab_unknowns)
        node = slab * mesh.slab_nodes + np.arange(mesh.slab_nodes + 1)
        row = np.add.outer(mesh.rail[node], [0, 1]).ravel() - around.start
        unit = np.zeros((around.stop - around.start, len(row)))
        unit[row, np.arange(len(row))] = 1
        self.influence = np.ascontiguousarray(substitute(factorise(effective[:, around]), unit).T)

    def _start_vehicle(self, vehicle: Vehicle) -> None:
        mass, damping, stiffness = vehicle_matrices(vehicle)
        self.weight, bodies = weights(vehicle), slice(0, 6)
        u = np.zeros(10)
        u[WHEELSETS] = (self.track.u[self.under] * self.shape).sum(axis=1) + self.penetration
        hung = self.weight[bodies] - stiffness[bodies, WHEELSETS] @ u[WHEELSETS]
        u[bodies] = np.linalg.solve(stiffness[bodies, bodies], hung)
        inverse = np.linalg.inv(self.scheme.effective(mass, damping, stiffness))
        inner = np.hstack([mass, damping, stiffness])
        self.vehicle = _Motion(self.scheme, inner, lambda load: inverse @ load, u)
        self.vehicle_influence = inverse[:, WHEELSETS]

    def _responses(self) -> tuple[slice, Array]:
        """Accelerations (4, …) of a part of the track for a unit force on its effective matrix under each wheel."""
        mesh = self.mesh
        slab, node = np.divmod(self.element, mesh.slab_nodes)
        first, last = slab.min() - self.reach, slab.max() + self.reach + 1
        responses = np.zeros((4, (last - first) * mesh.slab_unknowns))
        for wheel in range(4):
            start = (slab[wheel] - self.reach - first) * mesh.slab_unknowns
            columns = self.influence[2 * node[wheel] : 2 * node[wheel] + 4]
            responses[wheel, start : start + columns.shape[1]] = self.shape[wheel] @ columns
        return slice(first * mesh.slab_unknowns, last * mesh.slab_unknowns), responses

    def step(self, wheels: Array, eta: Array) -> None:
        """One step, at whose end the wheels stand at the given positions over the given irregularity, both (4,), m."""
        track, vehicle, alpha_f = self.track, self.vehicle, self.scheme.alpha_f
        track.predict(self._load(alpha_f * self.force))
        load = self.weight.copy()
        load[WHEELSETS] -= alpha_f * self.force
        vehicle.predict(load)
        if (origin := self._origin_for(wheels)) > self.origin:
            self.origin = origin
            track.shift(self.mesh.slab_unknowns)
        self._locate(wheels)

        part, responses = self._responses()
        gap = vehicle.predicted(WHEELSETS) - (track.predicted(self.under) * self.shape).sum(axis=1) - eta
        under = (responses[:, self.under - part.start] * self.shape).sum(axis=2).T
        flexibility = (1 - alpha_f) * self.scheme.correction[2] * (under + self.vehicle_influence[WHEELSETS])
        self.penetration, self.force = _close_contacts(gap, flexibility, self.hertz, self.penetration)
        track.a[part] += (1 - alpha_f) * self.force @ responses
        vehicle.a -= (1 - alpha_f) * self.vehicle_influence @ self.force
        track.correct()
        vehicle.correct()

    def record(self) -> Array:
        """What a response holds at the end of the step (15,)."""
        under, shape = np.array([field[self.element[0]] for field in self.elements]), self.shape[0]
        ahead, behind = (side[self.mesh.joints] for side in (self.mesh.slab_ahead, self.mesh.slab_behind))
        t, (_, v, u) = self.properties, self.track.state
        roadbed = (t.roadbed_stiffness * u[under[2]] + t.roadbed_damping * v[under[2]]) @ shape
        pads = self._pad_forces()
        return np.array(
            [
                *self.force,
                *u[under] @ shape,
                *self.track.acceleration(under) @ shape,
                roadbed,
                pads.max(),
                -min(pads.min(), 0.0),
                _largest(u[ahead] - u[behind]),
                _largest(self._moments_next_to_joints()),
            ]
        )

    def _pad_forces(self) -> Array:
        t, (_, v, u) = self.properties, self.track.state
        rail, slab = self.mesh.rail[self.mesh.pads], self.mesh.slab_ahead[self.mesh.pads]
        return t.pad_stiffness * (u[rail] - u[slab]) + t.pad_damping * (v[rail] - v[slab])

    def _moments_next_to_joints(self) -> Array:
        """Slab moments at the pads on both sides of every joint, means of those in the elements that meet there."""
        mesh, t, length = self.mesh, self.properties, np.diff(self.mesh.x)
        pad = np.searchsorted(mesh.pads, mesh.joints)
        node = np.concatenate([mesh.pads[pad - 1], mesh.pads[pad[pad < len(mesh.pads)]]])
        node = node[(node > 0) & (node < len(length))]
        curvature = np.zeros(len(node))
        for element, at in ((node - 1, [6, 2, -6, 4]), (node, [-6, -4, 6, -2])):
            scale = np.stack([np.ones(len(node)), length[element]] * 2, axis=1) / length[element, None] ** 2
            curvature += (self.track.u[self.elements[1][element]] * scale * at).sum(axis=1) / 2
        return -t.slab_elastic_modulus * t.slab_second_moment * curvature


def _largest(values: Array) -> float:
    """The value with the largest magnitude; zero if there is none."""
    return float(values[np.argmax(np.abs(values))]) if len(values) else 0.0
