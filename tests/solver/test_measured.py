from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.case import Dip, Harmonic, Measured, Smooth, Spectral, Sum
from solver.irregularity import sample

LENGTH = 400.0
INNER = slice(6000, 34000)  # of positions 1 cm apart: away from both ends by more than the taper


def profile(wavelength, spacing=0.1, shift=0.0, **band):
    x = np.arange(0, LENGTH + spacing / 2, spacing)
    x[1:-1] += shift * spacing * np.sin(7.3 * np.arange(1, len(x) - 1))
    return Measured(
        positions=tuple(x),
        heights=tuple(0.02 - 3e-5 * x + 1e-3 * np.sin(2 * np.pi * x / wavelength)),
        **{"wavelength_min": 1.0, "wavelength_max": 30.0} | band,
    )


def over_the_profile(measured):
    return sample(measured, 0.0, 0.01, int(LENGTH * 100) + 1)


@given(st.floats(1.2, 15.0), st.sampled_from([0.03, 0.1, 0.2]))
@settings(max_examples=25)
def test_a_sine_inside_the_band_comes_back_without_offset_and_trend(wavelength, spacing):
    x = 0.01 * np.arange(int(LENGTH * 100) + 1)
    sine = 1e-3 * np.sin(2 * np.pi * x / wavelength)
    eta = over_the_profile(profile(wavelength, spacing))
    np.testing.assert_allclose(eta[INNER], sine[INNER], atol=1e-5)


@pytest.mark.parametrize("wavelength", [0.25, 0.5, 0.8, 100.0, 200.0])
def test_a_sine_outside_the_band_vanishes(wavelength):
    assert np.abs(over_the_profile(profile(wavelength, spacing=0.05))[INNER]).max() < 2e-5


def test_shorter_waves_are_not_mistaken_for_longer_ones():
    ripple = profile(1 / 16.2, spacing=0.005)  # would look 5 m long on a grid of 16 points per metre
    assert np.abs(over_the_profile(ripple)[INNER]).max() < 1e-6


@pytest.mark.parametrize(("spacing", "shift"), [(0.05, 0.0), (0.16, 0.0), (0.1, 0.3)])
def test_the_profile_does_not_depend_on_how_it_was_sampled(spacing, shift):
    reference = over_the_profile(profile(3.0, 0.1))
    np.testing.assert_allclose(over_the_profile(profile(3.0, spacing, shift)), reference, atol=2e-6)


def test_positions_between_samples_do_not_depend_on_the_step():
    measured = profile(1.3)
    coarse, fine = sample(measured, 100.0, 0.08, 500), sample(measured, 100.0, 0.01, 4000)
    np.testing.assert_array_equal(coarse, fine[::8])


def test_it_eases_to_zero_at_its_ends_and_is_zero_beyond():
    eta = sample(profile(3.0), -10.0, 0.01, 42000)
    x = -10.0 + 0.01 * np.arange(42000)
    np.testing.assert_array_equal(eta[(x < 0) | (x > LENGTH)], 0)
    assert np.abs(eta[(np.abs(x) < 1) | (np.abs(x - LENGTH) < 1)]).max() < 1e-7
    assert np.abs(np.diff(eta)).max() < 1.1 * 1e-3 * 2 * np.pi / 3.0 * 0.01  # no edge steeper than the sine


def test_bands_of_one_profile_add_up():
    measured = profile(5.0)
    rough = np.random.default_rng(5).normal(0, 1e-3, len(measured.positions))
    whole = replace(measured, heights=tuple(rough))
    short, long = replace(whole, wavelength_max=7.001), replace(whole, wavelength_min=7.001)
    parts = over_the_profile(short)[INNER] + over_the_profile(long)[INNER]
    total = over_the_profile(whole)[INNER]
    assert np.sqrt(np.mean((parts - total) ** 2)) < 0.02 * total.std()


def test_a_dip():
    dip = Dip(position=10.0, length=1.0, depth=5e-4)
    np.testing.assert_allclose(
        sample(dip, 9.0, 0.25, 9)[[0, 2, 3, 4, 5, 6, 8]], 5e-4 * np.array([0, 0, 0.5, 1, 0.5, 0, 0])
    )
    bump = replace(dip, depth=-5e-4)
    np.testing.assert_array_equal(sample(bump, 9.0, 0.25, 9), -sample(dip, 9.0, 0.25, 9))


def test_sums_add():
    terms = (
        Smooth(),
        Harmonic(wavelength=1.2, amplitude=3e-4),
        Spectral(wavelength_min=2.0, wavelength_max=30.0),
        Dip(position=5.0, length=1.0, depth=5e-4),
        profile(3.0),
    )
    grid = (-3.0, 0.013, 1001)
    added = sum(sample(term, *grid) for term in terms)
    np.testing.assert_allclose(sample(Sum(terms=terms), *grid), added, atol=1e-18)
    one = Sum(terms=terms[1:2])
    np.testing.assert_array_equal(sample(one, *grid), sample(terms[1], *grid))
