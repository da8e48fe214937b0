"""An experiment: the joint between slabs as the article describes it (P-ELE, Eqs. 9-13), which the solver does not use.

The element that holds a joint loses a strip of slab around it, with the mortar below, and the spring and damper of the
joint bridge the strip. Nothing else changes, so the joint walks through elements whose shape functions cannot open.
The steps are those of the solver, one by one, with a banded matrix factorised anew in each.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.polynomial.legendre import leggauss

from solver.arrays import Array
from solver.banded import HALF_BANDWIDTH
from solver.beam import hermite
from solver.case import Case, Harmonic, Numerics
from solver.catalogue import TRACKS, VEHICLES
from solver.compiled import compiled
from solver.contact import close_contacts
from solver.integrator import integrator
from solver.irregularity import sample
from solver.start import static_equilibrium
from solver.track import BASE, NODE, RAIL, SLAB, TrackModel, couple, element_unknowns
from solver.vehicle import WHEELSETS, vehicle_matrices, wheel_positions
from solver.wheel import hertz_constant
from worker.article.reported import SPEEDS_KMH

WIDE = 15  # half the bandwidth: a strip across a node ties three nodes
OPEN_M = 20.0  # of track at each end without strips
LIMIT_M = 0.1  # of rail displacement beyond which a run has diverged
ELEMENT = "whole element"
NARROW_M = 0.05
Trial = tuple[float | str, float]  # width of the strips, m, and speed, km/h
# A track without strips, which the solver must agree with, and both readings of the article.
PLAN: tuple[Trial, ...] = (
    (0.0, SPEEDS_KMH[-1]),
    *((width, speed_kmh) for width in (NARROW_M, ELEMENT) for speed_kmh in SPEEDS_KMH),
)
_POINTS, _WEIGHTS = leggauss(4)
MEASURES = ("wheel_rail_force", "rail_displacement", "rail_acceleration", "slab_acceleration", "base_acceleration")


def experiment(trial: Trial) -> dict[str, Any]:
    """Peaks over the article's wave at a speed (km/h), joints as strips of a width (m); 0 for no joints."""
    width, speed_kmh = trial
    case = Case(
        speed=speed_kmh / 3.6,
        irregularity=Harmonic(wavelength=1.0, amplitude=3e-4),
        track=TRACKS["crts2"].values,
        vehicle=VEHICLES["crh3"].values,
        numerics=Numerics(
            track_length=92.0, elements_per_pad=6, time_step=2e-4, settle=0.5, window=13.0 / (speed_kmh / 3.6)
        ),
    )
    found = peaks_with_strips(case, width)
    return {"width_m": width, "speed_kmh": speed_kmh, "peaks": found}


@dataclass(frozen=True)
class Strips:
    """What strips change of a track's matrices, all of them alike."""

    model: TrackModel
    width: float | str

    def place(self, step: int) -> float:
        """Where one joint is after some steps, m."""
        case, joint = self.model.case, self.model.case.track.joint
        first_wheel = wheel_positions(case.vehicle)[0]
        travelled = case.numerics.start + step * case.time_step * case.speed
        return float(first_wheel + joint.position * case.track.pad_spacing - travelled)

    def elements(self, step: int) -> Array:
        """The element of every joint."""
        case, model = self.model.case, self.model
        per_slab = case.track.joint.pads_per_slab * case.numerics.elements_per_pad
        nearest = (self.place(step) - model.left_end) / model.element.length
        count = model.cells * case.numerics.elements_per_pad
        every = np.floor(nearest % per_slab + per_slab * np.arange(count // per_slab + 1)).astype(int)
        margin = OPEN_M / model.element.length
        return every[(every > margin) & (every < count - margin)]

    def change(self, step: int, inertia: float, damping: float) -> Array:
        """``inertia M + damping C + K`` (24, 24) to add on the four nodes around each joint, its element the middle."""
        model, length = self.model, self.model.element.length
        _, xi = model.locate(self.place(step))
        half = 0.0 if isinstance(self.width, str) else self.width / length / 2
        low, high = (0.0, 1.0) if isinstance(self.width, str) else (xi - half, xi + half)
        changed = np.zeros((4 * NODE, 4 * NODE))
        for element in range(-1, 2):
            begin, end = max(low - element, 0.0), min(high - element, 1.0)
            if end > begin:
                first = NODE * (element + 1)
                changed[first : first + 2 * NODE, first : first + 2 * NODE] -= self._slab(begin, end, inertia, damping)
        return changed + self._spring(low, high, damping)

    def _slab(self, begin: float, end: float, inertia: float, damping: float) -> Array:
        """Slab and mortar of a part of an element."""
        t, speed, length = self.model.case.track, self.model.case.speed, self.model.element.length
        xi = begin + (end - begin) * (_POINTS + 1) / 2
        weights = _WEIGHTS * (end - begin) * length / 2
        n, slope, curvature = (hermite(xi, length, derivative) for derivative in range(3))
        mass, gradient, stretch, bending = (
            (left * weights[:, None]).T @ right
            for left, right in ((n, n), (n, slope), (slope, slope), (curvature, curvature))
        )
        matrix = np.zeros((2 * NODE, 2 * NODE))
        matrix[np.ix_(*2 * [element_unknowns(SLAB)])] = (
            t.slab_mass * (inertia * mass - damping * speed * (gradient - gradient.T) - speed**2 * stretch)
            + t.slab_elastic_modulus * t.slab_second_moment * bending
        )
        mortar = (t.mortar_stiffness + damping * t.mortar_damping) * mass - t.mortar_damping * speed * gradient
        couple(matrix, SLAB, BASE, mortar)
        return matrix

    def _spring(self, low: float, high: float, damping: float) -> Array:
        joint, speed = self.model.case.track.joint, self.model.case.speed
        ahead, behind = self._slab_at(high), self._slab_at(low)
        jump, rate = ahead[0] - behind[0], ahead[1] - behind[1]
        stiff = (joint.shear_stiffness + damping * joint.shear_damping) * np.outer(jump, jump)
        return stiff - joint.shear_damping * speed * np.outer(jump, rate)

    def _slab_at(self, xi: float) -> Array:
        """Weights (2, 24) of the slab's displacement and slope, at an edge of the strip."""
        element = min(int(np.floor(xi)), 1)
        weights = np.zeros((2, 4 * NODE))
        unknowns = NODE * (element + 1) + element_unknowns(SLAB)
        for derivative in (0, 1):
            weights[derivative, unknowns] = self.model.shape(xi - element, derivative)
        return weights


class Bands:
    """Matrices of the track in wide bands, ``band[i, WIDE + j - i]``, at every phase."""

    def __init__(self, model: TrackModel, inertia: float, damping: float) -> None:
        self.model, self.factors = model, ((inertia, 0.0), (0.0, damping))
        self.phases: dict[int, tuple[Array, Array, Array]] = {}

    def at(self, phase: int) -> tuple[Array, Array, Array]:
        """``inertia M``, ``damping C``, and their sum with ``K``."""
        if phase not in self.phases:
            wide = ((0, 0), (WIDE - HALF_BANDWIDTH,) * 2)
            stiffness = np.pad(self.model.band(self.model.cells, phase), wide)
            mass, damping = (
                np.pad(self.model.band(self.model.cells, phase, *each), wide) - stiffness for each in self.factors
            )
            self.phases[phase] = mass, damping, mass + damping + stiffness
        return self.phases[phase]


def _times(band: Array, x: Array) -> Array:
    """A banded matrix times a vector."""
    windows = np.lib.stride_tricks.sliding_window_view(np.pad(x, WIDE), 2 * WIDE + 1)
    return np.einsum("ij,ij->i", band, windows)


@compiled
def _solved(band: Array, loads: Array) -> Array:
    """Solutions for some loads (n, loads), by elimination without pivoting; both arguments are overwritten."""
    size, columns = loads.shape
    for i in range(size):
        for row in range(i + 1, min(i + WIDE + 1, size)):
            factor = band[row, WIDE + i - row] / band[i, WIDE]
            if factor != 0.0:
                for j in range(1, WIDE + 1):
                    band[row, WIDE + i - row + j] -= factor * band[i, WIDE + j]
                for column in range(columns):
                    loads[row, column] -= factor * loads[i, column]
    for i in range(size - 1, -1, -1):
        for column in range(columns):
            total = loads[i, column]
            for j in range(1, min(WIDE, size - 1 - i) + 1):
                total -= band[i, WIDE + j] * loads[i + j, column]
            loads[i, column] = total / band[i, WIDE]
    return loads


@compiled
def _add(band: Array, rows: Array, matrix: Array) -> None:
    """Add a matrix to a band, from each of some rows on."""
    for first in rows:
        for i in range(matrix.shape[0]):
            for j in range(max(0, i - WIDE), min(matrix.shape[0], i + WIDE + 1)):
                band[first + i, WIDE + j - i] += matrix[i, j]


class March:
    """Track and vehicle from rest, step by step."""

    def __init__(self, case: Case, width: float | str) -> None:
        self.case, self.width, self.model = case, width, TrackModel(case)
        self.k = integrator(case.time_step, case.numerics.spectral_radius)
        self.wheels = wheel_positions(case.vehicle)
        self.loads = self.model.unit_loads(self.wheels)
        self.bands = Bands(self.model, self.k.inertia, self.k.damping)
        self.strips = Strips(self.model, width)
        self.left, self.slope = self.model.absorption(case.time_step).T
        self.hertz, self.matrices = hertz_constant(case.vehicle), vehicle_matrices(case.vehicle)
        m = self.matrices
        self.inverse = np.linalg.inv(m.stiffness + self.k.damping * m.damping + self.k.inertia * m.mass)
        steady = self.model.steady_response(0, self.loads)
        car, self.penetration, force = static_equilibrium(case.vehicle, self.loads.T @ steady)
        self.u, self.v, self.a = steady @ force, np.zeros(len(steady)), np.zeros(len(steady))
        self.car = [car, np.zeros_like(car), np.zeros_like(car)]
        row, self.weights = self.model.point(self.wheels[0], RAIL)
        self.under = slice(row, row + 2 * NODE)
        self.xi = self.model.locate(self.wheels[0])[1]

    def step(self, number: int, eta: Array) -> dict[str, float]:
        """Take one step; what there is at its end."""
        k, matrices = self.k, self.matrices
        inertial, damped = self.u - k.alpha / k.inertia * self.a, self.u - self.v / k.damping
        mass, damping, whole = self.bands.at(number % self.case.phases)
        load, whole = _times(mass, inertial) + _times(damping, damped), whole.copy()
        if self.width:
            own = self.strips.change(number, 0.0, 0.0)
            mass = self.strips.change(number, k.inertia, 0.0) - own
            damping = self.strips.change(number, 0.0, k.damping) - own
            rows = NODE * (self.strips.elements(number) - 1)
            _add(whole, rows, own + mass + damping)
            around = rows[:, None] + np.arange(len(own))
            np.add.at(load, around, inertial[around] @ mass.T + damped[around] @ damping.T)
        answers = _solved(whole, np.column_stack([load, self.loads]))
        u, v, a = self.car
        pushed = (
            matrices.weight + matrices.mass @ (k.inertia * u - k.alpha * a) + matrices.damping @ (k.damping * u - v)
        )
        free, on_rail = self.inverse @ pushed, self.loads.T @ answers
        force = np.zeros(4)
        compliance = on_rail[:, 1:] + self.inverse[WHEELSETS, WHEELSETS]
        close_contacts(free[WHEELSETS] - on_rail[:, 0] - eta, compliance, self.hertz, self.penetration, force)
        x = answers[:, 0] + answers[:, 1:] @ force
        found = self._observed(x, force[0])
        car_new = k.acceleration * (free - self.inverse[:, WHEELSETS] @ force - u)
        self.car = list(self._predicted(u + car_new / k.acceleration, v + k.velocity * car_new, car_new))
        new = k.acceleration * (x - self.u)
        rate = (self.v + k.velocity * new).reshape(-1, NODE)
        rate[:, 1::2] = self.left[:, None] * rate[:, 1::2] + self.slope[:, None] * rate[:, ::2]
        rate[:, ::2] *= self.left[:, None]
        self.u, self.v, self.a = self._predicted(x, rate.ravel(), new)
        return found

    def _predicted(self, x: Array, rate: Array, new: Array) -> tuple[Array, Array, Array]:
        k = self.k
        return x + k.step * rate + k.drift * new, rate + k.kick * new, new

    def _observed(self, x: Array, force: float) -> dict[str, float]:
        """Force, and displacement and material accelerations under the first wheel."""
        k, track, speed, length = self.k, self.case.track, self.case.speed, self.model.element.length
        there = self.under
        new = k.acceleration * (x[there] - self.u[there])
        rate = self.v[there] + k.velocity * new
        moving = (1 - k.alpha) * new + k.alpha * self.a[there]
        n, slope, curvature = (hermite(self.xi, length, derivative) for derivative in range(3))
        bent = -2 * length * (self.xi * (1 - self.xi)) ** 2 * force  # of a load inside an element, beyond its cubic
        found = {"wheel_rail_force": force, "rail_displacement": float(n @ x[there][element_unknowns(RAIL)])}
        for beam, name in ((RAIL, "rail"), (SLAB, "slab"), (BASE, "base")):
            of = element_unknowns(beam)
            curved = float(curvature @ x[there][of])
            if beam == RAIL:
                curved += bent / (track.rail_elastic_modulus * track.rail_second_moment)
            value = n @ moving[of] - 2 * speed * (slope @ rate[of]) + speed**2 * curved
            found[f"{name}_acceleration"] = float(value)
        return found


def peaks_with_strips(case: Case, width: float | str) -> dict[str, float] | None:
    """Largest magnitudes over the window of a case; nothing if the response grows without bounds."""
    march, numerics = March(case, width), case.numerics
    settle, window = int(np.ceil(numerics.settle / case.time_step)), max(1, round(numerics.window / case.time_step))
    steps, advance = settle + window, case.speed * case.time_step
    starts = numerics.start + advance + march.wheels - march.wheels.max()
    ease = np.clip(np.arange(1, steps + 1) * case.time_step / numerics.ease_in, 0, 1)
    eased = ease**3 * (10 - 15 * ease + 6 * ease**2)
    eta = eased[:, None] * np.array([sample(case.irregularity, x, advance, steps) for x in starts]).T
    records = []
    for number in range(1, steps + 1):
        found = march.step(number, eta[number - 1])
        if not abs(found["rail_displacement"]) < LIMIT_M:
            return None
        if number > settle:
            records.append([found[name] for name in MEASURES])
    return {name: float(value) for name, value in zip(MEASURES, np.abs(records).max(axis=0), strict=True)}
