import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.indices import comfort_band, contact_losses, low_pass, sperling

STEP = 1e-3
TIME = STEP * np.arange(10_000)


@pytest.mark.parametrize(
    ("filtered", "kept_hz", "removed_hz"),
    [(low_pass, (0.5, 5.0), (60.0, 150.0)), (comfort_band, (1.5, 5.0), (0.1, 40.0))],
)
def test_filters_keep_their_band_in_phase_and_remove_the_rest(filtered, kept_hz, removed_hz):
    inside = slice(2000, -2000)
    for frequency in kept_hz:
        wave = np.cos(2 * np.pi * frequency * TIME)
        np.testing.assert_allclose(filtered(wave, STEP)[inside], wave[inside], atol=0.02)
    for frequency in removed_hz:
        wave = np.cos(2 * np.pi * frequency * TIME)
        np.testing.assert_allclose(filtered(wave, STEP)[inside], 0, atol=0.03)


def test_a_constant_force_passes_to_the_edges():
    np.testing.assert_allclose(low_pass(np.full(500, 7e4), STEP), 7e4)


def test_a_record_that_ends_on_a_crest_keeps_its_mean_at_the_edge():
    force = 7e4 + 4e4 * np.cos(2 * np.pi * 97.0 * TIME[:3001])
    np.testing.assert_allclose(low_pass(force, STEP), 7e4, rtol=0.01)


@pytest.mark.parametrize("frequency", [1.0, 4.0, 10.0, 30.0])
def test_sperling_index_of_a_sine(frequency):
    amplitude = 0.3
    weight = 0.325 * frequency**2 if frequency < 5.9 else 400 / frequency**2 if frequency < 20 else 1.0
    expected = 3.57 * (amplitude**3 / frequency * weight) ** 0.1
    values = sperling(amplitude * np.sin(2 * np.pi * frequency * TIME), STEP)
    np.testing.assert_allclose(values, [expected, expected], rtol=1e-6)


@given(st.lists(st.booleans(), min_size=1, max_size=200))
def test_contact_losses_add_up(contact):
    durations = contact_losses(np.where(contact, 1.0, 0.0), 1.0)
    assert durations.sum() == contact.count(False)
    text = "".join("-x"[c] for c in contact)
    assert np.count_nonzero(durations) == len([run for run in text.split("x") if run])
