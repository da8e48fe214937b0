"""Against linear theory in the frequency domain: three infinite layers and the whole vehicle."""

from dataclasses import replace

import numpy as np
from scipy.interpolate import CubicSpline

from solver.arrays import Array
from solver.case import Case, Harmonic, Numerics, Smooth, Spectral
from solver.irregularity import components
from solver.reference.layered import contact_force
from solver.simulate import Response
from solver.verification.finding import Bound, Comparison, Curve, Finding, Plot, Row
from solver.verification.problems import CONICAL, QUICK, RANDOM, SMEARABLE, make_case, solved

AMPLITUDE = 3e-4
MEAN_PERCENTILE = -100 * float(np.expm1(-1.0))  # of the mean spectrum, 63.2 %


def harmonic(speeds_kmh: tuple[float, ...]) -> Finding:
    """Amplitudes of the contact forces over a sine of 1 m, at a tenth of 0.3 mm and at the whole."""
    rows: list[Row] = []
    whole = []
    for speed in speeds_kmh:
        numerics = Numerics(track_length=95.0, settle=0.9, window=0.5)
        small, full = (
            make_case(
                speed=speed / 3.6,
                track=SMEARABLE,
                irregularity=Harmonic(wavelength=1.0, amplitude=a),
                numerics=numerics,
            )
            for a in (AMPLITUDE / 10, AMPLITUDE)
        )
        expected = np.abs(contact_force(SMEARABLE, CONICAL, small.speed, 1.0))
        linear, real = solved([small, full])
        amplitudes = _amplitudes(linear)
        rows += [
            Comparison(
                what=f"wheelset {i + 1}, {speed:g} km/h, 0.03 mm",
                ours=amplitudes[i] / 1e3,
                expected=expected[i] * AMPLITUDE / 10 / 1e3,
                tolerance=0.01,
                unit="kN",
            )
            for i in range(4)
        ]
        whole.append(_amplitudes(real)[0] / 1e3)
        if (real.values[:4] > 0).all():
            rows.append(
                Comparison(
                    what=f"wheelset 1, {speed:g} km/h, 0.3 mm, contact kept",
                    ours=whole[-1],
                    expected=expected[0] * AMPLITUDE / 1e3,
                    tolerance=0.05,
                    unit="kN",
                )
            )
        else:
            share = float((real.values[:4] <= 0).mean())
            rows.append(Bound(what=f"{speed:g} km/h, 0.3 mm: share of time without contact", ours=share, low=1e-6))
    sweep = np.linspace(100, 400, 61)
    theory = [abs(contact_force(SMEARABLE, CONICAL, v / 3.6, 1.0)[0]) * AMPLITUDE / 1e3 for v in sweep]
    plot = Plot(
        x_label="speed, km/h",
        y_label="force amplitude of wheelset 1, kN",
        curves=(
            Curve(label="linear theory", x=sweep, y=np.array(theory)),
            Curve(label="moving elements, 0.3 mm", x=speeds_kmh, y=whole, style="o"),
        ),
    )
    return Finding(rows=rows, plots=[plot])


def _amplitudes(response: Response) -> Array:
    """Amplitudes (4,) at the passing frequency of a wave of 1 m, N."""
    speed = response.case.speed
    window = response.time <= np.floor(response.time[-1] * speed) / speed  # whole wavelengths
    turn = np.exp(-2j * np.pi * speed * response.time[window])
    return 2 * np.abs((response.values[:4, window] * turn).mean(axis=1))


def random(seeds: int, window: float) -> Finding:
    """Standard deviation of the contact force over many realisations in the linear limit."""
    small = 1e-4  # of the mean spectrum's heights: percentiles scale the density by -log(1 - p)
    percentile = -100 * np.expm1(-(small**2))
    numerics = replace(QUICK, settle=1.0, window=window, elements_per_pad=6)
    parts = {"track": SMEARABLE, "numerics": numerics}
    (smooth,) = solved([make_case(irregularity=Smooth(), **parts)])
    responses = solved(
        [make_case(irregularity=replace(RANDOM, percentile=percentile, seed=seed), **parts) for seed in range(seeds)]
    )
    variance = np.array([np.mean((r.values[:4] - smooth.values[:4]) ** 2, axis=1) for r in responses]) / small**2
    expected = expected_deviation(responses[0].case)
    rows: list[Row] = []
    for wheel in range(4):
        mean, error = variance[:, wheel].mean(), variance[:, wheel].std(ddof=1) / np.sqrt(seeds)
        sigma = float(np.sqrt(mean))
        # Three standard errors of the mean variance, as part of the standard deviation.
        rows.append(
            Comparison(
                what=f"standard deviation of the force, wheelset {wheel + 1}",
                ours=sigma / 1e3,
                expected=expected[wheel] / 1e3,
                tolerance=float(1.5 * error / mean),
                unit="kN",
            )
        )
        rows.append(Bound(what="its standard error", ours=float(0.5 * error / mean) * 100, high=2.0, unit="%"))
    deviations = np.sort(np.sqrt(variance[:, 0])) / 1e3
    plot = Plot(
        x_label="standard deviation of the force of wheelset 1 in one realisation, kN",
        y_label="share of realisations",
        curves=(
            Curve(label="moving elements", x=deviations, y=np.arange(1, seeds + 1) / seeds),
            Curve(label="linear theory, whole spectrum", x=[expected[0] / 1e3] * 2, y=[0.0, 1.0], style="--"),
        ),
    )
    return Finding(rows=rows, plots=[plot])


def expected_deviation(case: Case) -> Array:
    """Standard deviations (4,) of the contact forces over the components that every realisation has, N."""
    if not isinstance(case.irregularity, Spectral):
        raise TypeError("the irregularity of the case has no spectrum")
    frequency, amplitude, _ = components(replace(case.irregularity, percentile=MEAN_PERCENTILE))
    coarse = np.geomspace(frequency[0], frequency[-1], 160)
    force = np.abs([contact_force(case.track, case.vehicle, case.speed, 1 / f) for f in coarse])
    return np.sqrt(np.sum((amplitude[:, None] * CubicSpline(coarse, force)(frequency)) ** 2, axis=0) / 2)


def percentiles() -> Finding:
    """In the linear regime the dynamic part grows as the square root of -log(1 - p)."""
    low, high = (make_case(irregularity=replace(RANDOM, percentile=p), numerics=QUICK) for p in (1e-6, 4e-6))
    (smooth,), (one, two) = solved([make_case(irregularity=Smooth(), numerics=QUICK)]), solved([low, high])
    first, second = ((r.values - smooth.values)[:11] for r in (one, two))  # of forces and track
    worst = max(float(np.abs(b - 2 * a).max() / np.abs(b).max()) for a, b in zip(first, second, strict=True))
    return Finding(rows=[Bound(what="largest deviation from twice the response", ours=100 * worst, high=0.2, unit="%")])
