import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from solver.catalogue import SPECTRA
from solver.density import density, variance_between
from solver.quantity import InvalidParameterError
from solver.spectrum import PowerLaw, Rational, Table

TB = SPECTRA["tb3352-ballastless"].values
FLAT_STEP = PowerLaw(
    per="1/m", sides=1, coefficients=(2e-7, 3e-8, 1e-8), exponents=(0.0, 1.0, 1 + 1e-9), breaks=(0.1, 1.0)
)
TABLE = Table(per="rad/m", sides=2, frequencies=(0.01, 0.1, 0.7, 60.0), densities=(1e-4, 2e-6, 2e-6, 1e-12))
ALL = {name: entry.values for name, entry in SPECTRA.items()} | {"logarithmic": FLAT_STEP, "table": TABLE}

spectra = st.sampled_from(list(ALL.values()))
bands = st.tuples(st.floats(1 / 400, 5.0), st.floats(1e-6, 2.0)).map(lambda b: np.array([b[0], b[0] * (1 + b[1])]))


@pytest.mark.parametrize(("shortest", "longest", "rms_mm"), [(2, 200, 1.2203026), (2, 30, 0.3123), (4, 30, 0.3059)])
def test_rms_of_the_mean_spectrum(shortest, longest, rms_mm):
    rms = np.sqrt(variance_between(TB, np.array([1 / longest, 1 / shortest])).sum()) * 1e3
    assert rms == pytest.approx(rms_mm, rel=1e-6 if longest == 200 else 2e-4)


@pytest.mark.parametrize(
    ("name", "frequency", "millimetres"),
    [
        ("tb3352-ballastless", [1 / 2, 1 / 10], [4.32016e-3, 0.457735]),
        # The high German spectrum as the program GENSYS tabulates it under the name ORE B176, m^2/(1/m).
        ("german-high", [0.02, 0.1, 0.2], [4.0897e2, 1.0863e1, 1.2931]),
        # 0.25 * 0.0339 cm^2 rad/m * 100 * 2 pi / (2 Omega^2) at Omega = cutoff
        ("fra-6", [0.8245 / (2 * math.pi)], [0.25 * 3.39 * math.pi / 0.8245**2]),
    ],
)
def test_densities(name, frequency, millimetres):
    np.testing.assert_allclose(density(ALL[name], np.array(frequency)) * 1e6, millimetres, rtol=4e-5)


def test_german_high_is_german_low_scaled():
    f = np.geomspace(0.005, 5, 20)
    ratio = density(ALL["german-high"], f) / density(ALL["german-low"], f)
    np.testing.assert_allclose(ratio, 10.80 / 4.032, rtol=1e-12)


@given(spectra, bands)
def test_the_closed_form_of_the_variance_is_the_integral_of_the_density(spectrum, band):
    def per_decade(log_f: float) -> float:
        return float(density(spectrum, np.exp([log_f]))[0] * math.exp(log_f))

    low, high = np.log(band)
    own_unit = 1 if spectrum.per == "1/m" else 2 * math.pi
    corners = getattr(spectrum, "breaks", getattr(spectrum, "frequencies", ()))
    inside = [c for c in (math.log(f / own_unit) for f in corners) if low < c < high]
    numeric, _ = quad(per_decade, low, high, points=inside or None, epsabs=0, epsrel=1e-11, limit=200)
    assert variance_between(spectrum, band)[0] == pytest.approx(numeric, rel=1e-9)


@given(spectra, st.lists(st.floats(1 / 400, 10.0), min_size=3, max_size=20, unique=True).map(sorted).map(np.array))
def test_variances_of_parts_add_up_to_that_of_the_whole(spectrum, edges):
    parts = variance_between(spectrum, edges)
    assert parts.shape == (len(edges) - 1,)
    assert (parts >= 0).all()
    assert parts.sum() == pytest.approx(variance_between(spectrum, edges[[0, -1]])[0], rel=1e-9)


def test_narrow_bins_keep_their_digits():
    edges = 10 * (1 + 1e-9 * np.arange(2))
    for name, spectrum in ALL.items():
        expected = density(spectrum, edges[:1])[0] * np.diff(edges)[0]
        assert variance_between(spectrum, edges)[0] == pytest.approx(expected, rel=1e-8), name


def in_radians(spectrum):
    """The same spectrum per rad/m instead of per 1/m: S(Omega) = S(f) / (2 pi)."""
    turn = 2 * math.pi
    if isinstance(spectrum, Table):
        parts = {"frequencies": [f * turn for f in spectrum.frequencies]}
        return replace(spectrum, per="rad/m", densities=[s / turn for s in spectrum.densities], **parts)
    coefficients = [a * turn ** (k - 1) for a, k in zip(spectrum.coefficients, spectrum.exponents, strict=True)]
    return replace(spectrum, per="rad/m", coefficients=coefficients, breaks=[b * turn for b in spectrum.breaks])


FREQUENCIES = np.geomspace(0.003, 8, 57)


@pytest.mark.parametrize("spectrum", [TB, FLAT_STEP, replace(TABLE, per="1/m")], ids=["TB", "logarithmic", "table"])
def test_per_rad_and_per_metre_give_one_density(spectrum):
    np.testing.assert_allclose(density(in_radians(spectrum), FREQUENCIES), density(spectrum, FREQUENCIES), rtol=1e-12)
    edges = FREQUENCIES[::8]
    np.testing.assert_allclose(
        variance_between(in_radians(spectrum), edges), variance_between(spectrum, edges), rtol=1e-12
    )


@pytest.mark.parametrize("spectrum", ALL.values(), ids=ALL)
def test_a_two_sided_density_counts_twice(spectrum):
    one, two = replace(spectrum, sides=1), replace(spectrum, sides=2)
    np.testing.assert_array_equal(density(two, FREQUENCIES), 2 * density(one, FREQUENCIES))
    np.testing.assert_array_equal(variance_between(two, FREQUENCIES), 2 * variance_between(one, FREQUENCIES))


def test_a_table_of_a_power_law_is_the_power_law():
    power = PowerLaw(per="rad/m", sides=2, coefficients=(3e-7,), exponents=(2.7,))
    at = (0.01, 0.3, 7.0, 100.0)
    table = Table(per="rad/m", sides=2, frequencies=at, densities=tuple(3e-7 / f**2.7 for f in at))
    np.testing.assert_allclose(density(table, FREQUENCIES), density(power, FREQUENCIES), rtol=1e-12)
    np.testing.assert_allclose(variance_between(table, FREQUENCIES), variance_between(power, FREQUENCIES), rtol=1e-12)


GERMAN = ALL["german-low"]


@pytest.mark.parametrize(
    ("spectrum", "parts", "parameter"),
    [
        (TB, {"per": "1/mm"}, "per"),
        (TB, {"sides": 3}, "sides"),
        (TB, {"sides": True}, "sides"),
        (TB, {"sides": 1.0}, "sides"),
        (TB, {"exponents": (2.0,)}, "exponents"),
        (TB, {"coefficients": (1e-9, 1e-9, math.nan, 1e-9)}, "coefficients.2"),
        (TB, {"coefficients": (1e-9, 1e-9, -1e-9, 1e-9)}, "coefficients.2"),
        (TB, {"breaks": (0.02, 0.01, 0.1)}, "breaks"),
        (TB, {"breaks": (0.0, 0.01, 0.1)}, "breaks"),
        (TB, {"wavelength_range": (2.0,)}, "wavelength_range"),
        (GERMAN, {"lower_cutoff": 0.9}, "lower_cutoff"),
        (GERMAN, {"cutoff": 1e-4}, "cutoff"),
        (GERMAN, {"roughness": -1.0}, "roughness"),
        (TABLE, {"frequencies": (1.0, 0.5, 2.0, 3.0)}, "frequencies"),
        (TABLE, {"frequencies": (1.0,)}, "frequencies"),
        (TABLE, {"densities": (1e-6, 1e-6)}, "densities"),
        (TABLE, {"densities": (1e-6, 0.0, 1e-6, 1e-6)}, "densities.1"),
    ],
)
def test_what_is_no_spectrum_is_refused_by_name(spectrum, parts, parameter):
    with pytest.raises(InvalidParameterError) as caught:
        replace(spectrum, **parts)
    assert caught.value.parameter == f"irregularity.spectrum.{parameter}"


@pytest.mark.parametrize("cls", [PowerLaw, Rational, Table])
def test_no_spectrum_leaves_its_convention_open(cls):
    with pytest.raises(TypeError, match="'per', 'sides'"):
        cls()


@pytest.mark.parametrize("lower_cutoff", [0.0, 0.99e-3])
def test_the_least_cutoffs_leave_the_variance_positive(lower_cutoff):
    """It is a difference, of which the more is lost the lower the cut-offs and the higher the frequency."""
    spectrum = Rational(per="rad/m", sides=1, roughness=1.0, cutoff=1e-3, lower_cutoff=lower_cutoff)
    edges = np.geomspace(1e-3, 50.0, 200)
    middle = np.sqrt(edges[:-1] * edges[1:])
    assert variance_between(spectrum, edges) == pytest.approx(density(spectrum, middle) * np.diff(edges), rel=0.05)
