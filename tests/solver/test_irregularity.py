import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.case import Harmonic, Smooth, Spectral
from solver.catalogue import SPECTRA
from solver.density import variance_between
from solver.irregularity import components, percentile_factor, sample
from solver.spectrum import PowerLaw

OWN = PowerLaw(per="rad/m", sides=2, coefficients=(1e-7,), exponents=(2.5,))

bands = st.tuples(st.floats(0.5, 150), st.floats(1.05, 20)).map(lambda b: (b[0], min(200.0, b[0] * b[1])))


def realisation(**parts):
    return Spectral(**{"wavelength_min": 2.0, "wavelength_max": 30.0} | parts)


def test_percentiles():
    assert percentile_factor(25) == pytest.approx(0.2877, abs=5e-5)
    assert percentile_factor(63.2) == pytest.approx(1.000, abs=5e-4)
    assert percentile_factor(90) == pytest.approx(2.303, abs=5e-4)


@given(st.sampled_from([*SPECTRA, OWN]), bands, st.integers(0, 2**62), st.floats(1, 99))
@settings(max_examples=30)
def test_a_realisation_has_the_variance_of_its_band_at_its_percentile(spectrum, band, seed, percentile):
    frequency, amplitude, _ = components(
        realisation(spectrum=spectrum, wavelength_min=band[0], wavelength_max=band[1], seed=seed, percentile=percentile)
    )
    values = spectrum if spectrum is OWN else SPECTRA[spectrum].values
    exact = variance_between(values, np.array([1 / band[1], 1 / band[0]])).sum()
    assert np.sum(amplitude**2) / 2 == pytest.approx(exact * percentile_factor(percentile), rel=1e-9)
    assert 1 / band[1] <= frequency.min()
    assert frequency.max() <= 1 / band[0]


def test_an_own_spectrum_equal_to_a_named_one_is_the_same_track():
    named, own = realisation(spectrum="german-low"), realisation(spectrum=SPECTRA["german-low"].values)
    np.testing.assert_array_equal(sample(named, 0.0, 0.1, 500), sample(own, 0.0, 0.1, 500))


def test_a_long_realisation_has_the_rms_of_the_spectrum():
    eta = sample(realisation(seed=3), 0.0, 0.25, 16 * 4096)
    assert eta.std() == pytest.approx(0.3123e-3, rel=2e-3)


@given(st.floats(-100, 1000), st.floats(0.001, 0.1), st.integers(1, 300), st.integers(0, 5))
@settings(max_examples=30)
def test_samples_are_the_sum_of_the_cosines(start, spacing, count, number):
    irregularity = realisation(realisation=number)
    frequency, amplitude, phase = components(irregularity)
    x = start + spacing * np.arange(count)
    direct = np.cos(2 * np.pi * np.outer(x, frequency) + phase) @ amplitude
    np.testing.assert_allclose(sample(irregularity, start, spacing, count), direct, atol=1e-14)


def test_harmonic_and_smooth():
    x = 0.03 * np.arange(100)
    harmonic = sample(Harmonic(wavelength=1.2, amplitude=3e-4), 0.0, 0.03, 100)
    np.testing.assert_allclose(harmonic, 3e-4 * np.sin(2 * np.pi * x / 1.2), atol=1e-17)
    np.testing.assert_array_equal(sample(Smooth(), 0.0, 0.03, 100), 0)


def test_equal_seeds_mean_the_same_track_and_a_narrower_band_leaves_components_out():
    wide, narrow = components(realisation(seed=7)), components(realisation(seed=7, wavelength_min=4.0))
    shared = len(narrow[0]) - 1  # the last bin is cut by the band
    for w, n in zip(wide, narrow, strict=True):
        np.testing.assert_array_equal(w[:shared], n[:shared])
    other = components(realisation(seed=7, realisation=1))
    assert not np.any(other[2] == wide[2])


def test_phases_are_those_of_this_generator_on_every_machine():
    phases = components(realisation(seed=1))[2][:3]
    np.testing.assert_allclose(phases, [5.058308699090638, 6.054922669216448, 0.9457754028680412], rtol=1e-15)
