"""Against closed forms: a beam on an elastic foundation, a track at rest, the rail between two pads."""

from dataclasses import replace

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu

from solver.arrays import Array
from solver.banded import HALF_BANDWIDTH
from solver.case import Case, Numerics, Smooth
from solver.reference.layered import LayeredTrack
from solver.reference.winkler import WinklerBeam
from solver.track import BASE, NODE, RAIL, SLAB, TrackModel
from solver.vehicle import wheel_positions
from solver.verification.finding import Bound, Comparison, Curve, Finding, Plot
from solver.verification.problems import QUICK, SMEARABLE, TRACK, WORN, history, make_case, solved
from solver.wheel import static_wheel_load


def _deflection(model: TrackModel, beam: int, loads: Array, load: Array, at: float) -> float:
    """Displacement of a beam at a place under steady loads (N) at some positions, pads held at phase 0, m."""
    response = model.steady_response(0, model.unit_loads(loads) @ load)
    row, weights = model.point(at, beam)
    return float(weights @ response[row : row + 2 * NODE])


def winkler() -> Finding:
    """A force moving over a beam on an elastic foundation, below and beyond the critical speed."""
    spacing, bending_stiffness, stiffness, at, load = 0.025, 6.12e6, 1e7, 0.3, 1e5
    rows, curves = [], []
    # Beyond the critical speed of 511 m/s by similarity: 25 times the mass at a fifth of the speed, damping times five.
    for speed, mass, damping in (
        (10 / 3.6, 60.0, 0.0),
        (50.0, 60.0, 0.0),
        (97.22, 60.0, 0.0),
        (97.22, 60.0, 4900.0),
        (1.2 * 510.655 / 5, 1500.0, 5 * 4900.0),
    ):
        track = replace(
            TRACK,
            rail_second_moment=bending_stiffness / TRACK.rail_elastic_modulus,
            rail_mass=mass,
            pad_spacing=spacing,
            pad_stiffness=stiffness * spacing,
            pad_damping=damping * spacing,
            mortar_stiffness=1e16,
            roadbed_stiffness=1e16,
        )
        numerics = Numerics(track_length=95.0, elements_per_pad=2, time_step=1e-5, settle=0.3, window=0.1)
        model = TrackModel(make_case(speed=speed, track=track, irregularity=Smooth(), numerics=numerics))
        beam = WinklerBeam(bending_stiffness=bending_stiffness, mass=mass, stiffness=stiffness, damping=damping)
        response = model.steady_response(0, model.unit_loads(np.array([at])))[:, 0] * load
        place = np.linspace(-4, 4, 81)
        ours = np.array([w @ response[r : r + 2 * NODE] for r, w in (model.point(at + x, RAIL) for x in place)])
        exact = beam.deflection(place, load, speed)
        name = f"{speed:.4g} m/s, {mass:g} kg/m, {damping:g} N s/m²"
        for x in (-2.0, 0.0, 1.0):
            i = int(np.argmin(np.abs(place - x)))
            what = f"deflection at {x:+g} m, {name}"
            scale = 1e3 * float(np.abs(exact).max())
            rows.append(
                Comparison(
                    what=what, ours=ours[i] * 1e3, expected=exact[i] * 1e3, tolerance=1e-3, unit="mm", scale=scale
                )
            )
        curves += [
            Curve(label=name, x=place, y=exact * 1e3),
            Curve(label="", x=place[::4], y=ours[::4] * 1e3, style="."),
        ]
    plot = Plot(x_label="place ahead of the load, m", y_label="deflection, mm", curves=tuple(curves))
    return Finding(rows=[*rows], plots=[plot])


def at_rest() -> Finding:
    """Forces equal the weight, and the track sinks as three layers do."""
    case = make_case(irregularity=Smooth(), track=SMEARABLE, vehicle=WORN, speed=20 / 3.6, numerics=QUICK)
    model, wheels = TrackModel(case), wheel_positions(case.vehicle)
    loads = np.full(4, static_wheel_load(case.vehicle))
    layered = LayeredTrack(case.track, 0.0).static_deflection(loads, wheels, wheels[0])
    phases = np.linspace(0, case.phases, 8, endpoint=False).astype(int)
    mean = np.zeros(3)
    for phase in phases:
        response = model.steady_response(phase, model.unit_loads(wheels) @ loads)
        for beam in (RAIL, SLAB, BASE):
            row, weights = model.point(wheels[0], beam)
            mean[beam] += weights @ response[row : row + 2 * NODE] / len(phases)
    rows = [
        Comparison(
            what=f"{name} displacement, mean from pad to pad",
            ours=mean[beam] * 1e3,
            expected=layered[beam] * 1e3,
            tolerance=tolerance,
            unit="mm",
        )
        for name, beam, tolerance in (("rail", RAIL, 1e-2), ("slab", SLAB, 2e-3), ("base", BASE, 2e-3))
    ]
    return Finding(rows=[*rows])


def creeping() -> Finding:
    """A train at 10 km/h over a smooth rail."""
    numerics = Numerics(track_length=95.0, elements_per_pad=6, time_step=5e-4, settle=1.5, window=0.4)
    case = make_case(irregularity=Smooth(), vehicle=WORN, speed=10 / 3.6, numerics=numerics)
    (response,) = solved([case])
    load = static_wheel_load(case.vehicle)
    model, wheels = TrackModel(case), wheel_positions(case.vehicle)
    step = np.round((numerics.settle + response.time) / case.time_step).astype(int)
    steady = model.steady_response(0, model.unit_loads(wheels) @ np.full(4, load))
    row, weights = model.point(wheels[0], RAIL)
    rail = history(response, "rail_displacement")[step % case.phases == 0]
    forces = response.values[:4]
    return Finding(
        rows=[
            *(
                Comparison(
                    what=f"mean force of wheelset {i + 1}", ours=force.mean(), expected=load, tolerance=1e-3, unit="N"
                )
                for i, force in enumerate(forces)
            ),
            Bound(
                what="swing of a force, part of the weight", ours=float(np.ptp(forces, axis=1).max()) / load, high=0.01
            ),
            Comparison(
                what="rail displacement where the run began",
                ours=float(rail.mean()) * 1e3,
                expected=float(weights @ steady[row : row + 2 * NODE]) * 1e3,
                tolerance=2e-3,
                unit="mm",
            ),
        ]
    )


def pinned_pinned() -> Finding:
    """The rail's receptance half-way between two pads peaks where half a wave fits between them."""
    spacing = TRACK.pad_spacing
    bending = TRACK.rail_elastic_modulus * TRACK.rail_second_moment
    expected = np.pi / 2 * np.sqrt(bending / TRACK.rail_mass) / spacing**2
    # The start puts pads half a spacing from the first wheel, or right under it.
    numerics = Numerics(track_length=95.0, time_step=5e-4, start=spacing / 2)
    case = make_case(speed=10 / 3.6, irregularity=Smooth(), track=replace(TRACK, pad_damping=1e4), numerics=numerics)
    frequency = np.linspace(1100, 1350, 126)
    between = _receptance(case, frequency)
    above = _receptance(replace(case, numerics=replace(numerics, start=0.0)), frequency)
    peak = frequency[np.argmax(np.abs(between))]
    plot = Plot(
        x_label="frequency, Hz",
        y_label="receptance of the rail, nm/N",
        curves=(
            Curve(label="between two pads", x=frequency, y=np.abs(between) * 1e9),
            Curve(label="above a pad", x=frequency, y=np.abs(above) * 1e9),
        ),
        logarithmic=True,
    )
    at = int(np.argmin(np.abs(frequency - expected)))
    return Finding(
        rows=[
            Comparison(what="pinned-pinned frequency", ours=peak, expected=expected, tolerance=0.01, unit="Hz"),
            Bound(what="receptance there, between over above", ours=float(abs(between[at] / above[at])), low=3.0),
        ],
        plots=[plot],
    )


def _receptance(case: Case, frequency: Array) -> Array:
    """Rail displacement under the first wheel for a unit force there that vibrates, pads held at phase 0, m/N."""
    model = TrackModel(case)
    big = 1e12  # keeps M and C from drowning in K
    bands = [model.band(model.cells, 0, *factors) for factors in ((0.0, 0.0), (big, 0.0), (0.0, big))]
    stiffness, mass, damping = bands[0], (bands[1] - bands[0]) / big, (bands[2] - bands[0]) / big
    offsets = range(-HALF_BANDWIDTH, HALF_BANDWIDTH + 1)
    load = model.unit_loads(wheel_positions(case.vehicle)[:1])[:, 0].astype(complex)

    def at(omega: float) -> complex:
        band = stiffness + 1j * omega * damping - omega**2 * mass
        diagonals = [band[max(0, -i) : len(band) - max(0, i), HALF_BANDWIDTH + i] for i in offsets]
        return complex(load @ splu(sparse.diags_array(diagonals, offsets=offsets).tocsc()).solve(load))

    return np.array([at(2 * np.pi * f) for f in frequency])
