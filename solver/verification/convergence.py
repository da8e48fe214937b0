"""How the answers change with mesh, step, integrator, blending of the joints and length of track."""

import itertools
from dataclasses import replace
from typing import Any

import numpy as np

from solver.arrays import Array
from solver.case import Case, Harmonic, Irregularity, Numerics
from solver.channels import CHANNELS
from solver.simulate import Response
from solver.track import NODE, TrackModel
from solver.vehicle import wheel_positions
from solver.verification.finding import Bound, Comparison, Curve, Finding, Plot, Row
from solver.verification.problems import (
    RANDOM,
    SINE,
    history,
    jointed,
    magnitude,
    make_case,
    over_one_repeat,
    solved,
)

QUANTITIES = ("wheel_rail_force", "rail_displacement", "rail_acceleration", "slab_acceleration", "base_acceleration")
UNITS = {channel.quantity: channel.unit for channel in CHANNELS}


def element_length() -> Finding:
    """Rail displacement under a steady load inside an element."""
    counts = np.array([2, 3, 4, 6, 8, 12])

    def deflection(elements_per_pad: int) -> float:
        numerics = Numerics(track_length=95.0, elements_per_pad=elements_per_pad)
        model = TrackModel(make_case(numerics=numerics))
        wheel = wheel_positions(model.case.vehicle)[0]
        response = model.steady_response(0, model.unit_loads(np.array([wheel])))[:, 0]
        row, weights = model.point(wheel, 0)
        return float(weights @ response[row : row + 2 * NODE])

    exact = deflection(48)
    errors = np.abs([deflection(int(count)) / exact - 1 for count in counts])
    length = 0.65 / counts
    order = float(np.polyfit(np.log(length), np.log(errors), 1)[0])
    plot = Plot(
        x_label="length of an element, m",
        y_label="relative error of the rail's displacement",
        curves=(
            Curve(label="moving elements", x=length, y=errors, style="o-"),
            Curve(label="third order", x=length, y=errors[-1] * (length / length[-1]) ** 3, style="--"),
        ),
        logarithmic=True,
    )
    return Finding(
        rows=[Bound(what="order, the slope of a line through all", ours=order, low=2.8, high=3.2)], plots=[plot]
    )


def time_step(halvings: int) -> Finding:
    """Contact force over a sine of 3 m, the step halved again and again."""
    counts = 10 * 2 ** np.arange(halvings + 1)

    def force(phases: int) -> Array:
        step = 0.65 / (97.5 * phases)
        numerics = Numerics(track_length=95.0, time_step=step, settle=0.4, window=0.1)
        sine = Harmonic(wavelength=3.0, amplitude=3e-4)
        (response,) = solved([make_case(speed=97.5, irregularity=sine, numerics=numerics)])
        return history(response, "wheel_rail_force")[phases - 1 :: phases][:12]

    forces = [force(int(count)) for count in counts]
    errors = np.array([np.abs(a - b).max() for a, b in itertools.pairwise(forces)])
    steps = 0.65 / 97.5 / counts[:-1]
    order = float(np.polyfit(np.log(steps), np.log(errors), 1)[0])
    plot = Plot(
        x_label="time step, s",
        y_label="change of the contact force when the step is halved, N",
        curves=(
            Curve(label="moving elements", x=steps, y=errors, style="o-"),
            Curve(label="second order", x=steps, y=errors[-1] * (steps / steps[-1]) ** 2, style="--"),
        ),
        logarithmic=True,
    )
    return Finding(
        rows=[Bound(what="order, the slope of a line through all", ours=order, low=1.8, high=2.2)], plots=[plot]
    )


def _changed(
    base: Case, changes: dict[str, dict[str, Any]], tolerances: dict[str, float], measure: str = "peak"
) -> list[Row]:
    """Peaks of a case with other numerics beside those with its own."""
    (expected,) = solved([base])
    rows: list[Row] = []
    for what, change in changes.items():
        (ours,) = solved([replace(base, numerics=replace(base.numerics, **change))])
        rows += [
            Comparison(
                what=f"{quantity} {measure}, {what}",
                ours=_peak(ours, quantity),
                expected=_peak(expected, quantity),
                tolerance=tolerance,
                unit=UNITS[quantity],
            )
            for quantity, tolerance in tolerances.items()
        ]
    return rows


def _peak(response: Response, quantity: str) -> float:
    return magnitude(history(response, quantity))


def _tolerances(force: float, displacement: float, rail: float, layers: float) -> dict[str, float]:
    return dict(zip(QUANTITIES, (force, displacement, rail, layers, layers), strict=True))


def numerics(irregularity: Irregularity, rail: float) -> Finding:
    """A jointed case at 350 km/h with finer mesh and step, and with another integrator."""
    base = make_case(**jointed(), irregularity=irregularity, numerics=over_one_repeat(350))
    settle = base.numerics.settle
    earlier = {"settle": 2 * settle, "start": -settle * base.speed}  # observed at the same place
    changes: dict[str, dict[str, Any]] = {
        "half the step": {"time_step": 5e-5},
        "twice the elements": {"elements_per_pad": 24},
        "spectral radius 0.9": {"spectral_radius": 0.9},
        "spectral radius 0.6": {"spectral_radius": 0.6},
        "twice the settling": earlier,
    }
    return Finding(rows=_changed(base, changes, _tolerances(1e-3, 1e-3, rail, 0.01)))


def blending() -> Finding:
    """The length over which a joint's shape functions fade."""
    base = make_case(**jointed(), irregularity=RANDOM, numerics=over_one_repeat(350))
    lengths = np.array([0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0])
    responses = [solved([replace(base, numerics=replace(base.numerics, joint_blending=float(d)))])[0] for d in lengths]
    finest = replace(base.numerics, joint_blending=3.0, elements_per_pad=24)
    (exact,) = solved([replace(base, numerics=finest)])
    curves = tuple(
        Curve(
            label=quantity.replace("_", " "),
            x=lengths,
            y=[abs(_peak(r, quantity) / _peak(exact, quantity) - 1) * 100 for r in responses],
            style="o-",
        )
        for quantity in QUANTITIES
    )
    default = responses[list(lengths).index(base.numerics.joint_blending)]
    rows: list[Row] = [
        Comparison(
            what=f"{quantity} peak, over {base.numerics.joint_blending:g} spacings",
            ours=_peak(default, quantity),
            expected=_peak(exact, quantity),
            tolerance=tolerance,
            unit=UNITS[quantity],
        )
        for quantity, tolerance in _tolerances(1e-3, 1e-3, 0.015, 0.005).items()
    ]
    y_label = "change of a peak against 3 spacings and 24 elements, %"
    plot = Plot(x_label="blending, pad spacings", y_label=y_label, curves=curves, logarithmic=True)
    return Finding(rows=rows, plots=[plot])


def track_length() -> Finding:
    """More track changes little: a thousandth where the slab is continuous, a few where joints scatter waves."""
    rows: list[Row] = []
    for name, irregularity in (("sine", SINE), ("random", RANDOM)):
        base = make_case(irregularity=irregularity, numerics=over_one_repeat(350, track_length=280.0))
        changes = {f"continuous, {name}, 140 m instead of 280 m": {"track_length": 140.0}}
        rows += _changed(base, changes, _tolerances(1e-3, 1e-3, 1e-3, 1e-3))
    curves = []
    lengths = np.array([110.0, 125.0, 140.0, 160.0, 180.0, 200.0, 240.0])
    for speed in (250, 350):
        longest = over_one_repeat(speed, track_length=360.0, elements_per_pad=6)
        base = make_case(**jointed(), speed=speed / 3.6, irregularity=SINE, numerics=longest)
        changes = {
            f"joints, {speed} km/h, {length:g} m instead of 360 m": {"track_length": length} for length in lengths
        }
        found = _changed(base, changes, _tolerances(0.002, 0.001, 0.002, 0.01))
        rows += [row for row in found if any(f" {length:g} m" in row.what for length in (140, 200))]
        worst = [
            max(abs(r.difference) for r in found if isinstance(r, Comparison) and f" {length:g} m instead" in r.what)
            for length in lengths
        ]
        curves.append(Curve(label=name, x=lengths, y=np.array(worst) * 100, style="o-"))
    y_label = "largest change of a peak against 360 m, %"
    plot = Plot(x_label="length of track, m", y_label=y_label, curves=tuple(curves), logarithmic=True)
    return Finding(rows=rows, plots=[plot])
