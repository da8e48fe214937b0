"""Previews of irregularities: what the solver would drive over, and its density; on both databases."""

from collections.abc import Callable
from typing import Any

import httpx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import signal

from app.welch import welch
from solver.case import Spectral
from solver.irregularity import sample

Check = Callable[..., dict[str, Any]]

URL = "/v1/irregularity-previews"
SPECTRUM = {"kind": "spectrum", "percentile": 90, "wavelength_band_m": {"min": 2, "max": 30}, "seed": 3}
WAVE = {"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.3}


@given(st.integers(2, 300), st.integers(0, 300), st.floats(0.1, 1e4))
def test_densities_as_scipy_has_them(segment: int, more: int, rate: float) -> None:
    values = np.random.default_rng(segment).normal(3, 1, segment + more)
    expected = signal.welch(values, rate, nperseg=segment, noverlap=segment - max(1, segment // 2))
    for found, wanted in zip(welch(values, rate, segment), expected, strict=True):
        np.testing.assert_allclose(found, wanted, atol=1e-12)


def preview(client: httpx.Client, irregularity: dict[str, Any], **more: Any) -> dict[str, Any]:
    response = client.post(URL, json={"irregularity": irregularity, **more})
    assert response.status_code == 200, response.text
    found: dict[str, Any] = response.json()
    return found


def test_a_realisation_is_the_solvers(lenient_client: httpx.Client) -> None:
    found = preview(lenient_client, SPECTRUM, start_m=7, length_m=200, max_points=10_000)
    spectral = Spectral(percentile=90, wavelength_min=2, wavelength_max=30, seed=3)
    heights = sample(spectral, 7, found["spacing_m"], found["samples"])
    np.testing.assert_allclose(found["profile"]["heights_mm"], heights * 1e3)
    assert found["profile"]["positions_m"][0] == 7
    assert found["profile"]["positions_m"][-1] == pytest.approx(207)
    assert (found["lowest_mm"], found["highest_mm"]) == pytest.approx((heights.min() * 1e3, heights.max() * 1e3))
    few = preview(lenient_client, SPECTRUM, start_m=7, length_m=200, max_points=100)
    assert len(few["profile"]["heights_mm"]) <= 100
    assert max(few["profile"]["heights_mm"]) == found["highest_mm"]  # no peak is lost


def test_the_density_is_that_of_the_spectrum(lenient_client: httpx.Client) -> None:
    """Within the band the means over octaves agree, and the variance is the integral of what it was drawn from."""
    found = preview(lenient_client, SPECTRUM, length_m=2048)
    target = found["drawn_from"]
    frequency, density = (np.array(found["density"][name]) for name in ("frequencies_per_m", "densities_m3"))
    for low, high in ((0.05, 0.1), (0.1, 0.2), (0.2, 0.4)):
        inside = (low < frequency) & (frequency < high)
        wanted = np.interp(frequency[inside], target["frequencies_per_m"], target["densities_m3"])
        assert density[inside].mean() == pytest.approx(wanted.mean(), rel=0.3)
    variance = np.trapezoid(target["densities_m3"], target["frequencies_per_m"])
    assert found["rms_mm"] * 1e-3 == pytest.approx(variance**0.5, rel=0.02)


def test_other_irregularities(client: httpx.Client) -> None:
    wave = preview(client, WAVE, length_m=20)
    assert wave["drawn_from"] is None
    assert (wave["highest_mm"], wave["rms_mm"]) == pytest.approx((0.3, 0.3 / 2**0.5), rel=0.01)
    frequency, density = wave["density"]["frequencies_per_m"], wave["density"]["densities_m3"]
    assert frequency[int(np.argmax(density))] == pytest.approx(1, abs=0.4)
    assert set(preview(client, {"kind": "none"})["profile"]["heights_mm"]) == {0}
    dip = {"kind": "dip", "position_m": 5, "length_m": 1, "depth_mm": 0.4}
    assert preview(client, {"kind": "sum", "terms": [WAVE, dip]}, length_m=10)["highest_mm"] > 0.5
    rows = "".join(f"{n / 4},{np.sin(2 * np.pi * n / 40):.6f}\n" for n in range(801))
    profile = client.post("/v1/profiles", content="x_m,eta_mm\n" + rows, headers={"Content-Type": "text/csv"}).json()
    measured = {"kind": "measured", "profile_id": profile["id"], "wavelength_band_m": {"min": 2, "max": 30}}
    inside = preview(client, measured, start_m=60, length_m=80)
    assert inside["highest_mm"] == pytest.approx(1, rel=0.02)


def test_what_cannot_be_shown(lenient_client: httpx.Client, problem: Check) -> None:
    def pointer(irregularity: dict[str, Any], **more: Any) -> tuple[str, str]:
        response = lenient_client.post(URL, json={"irregularity": irregularity, **more})
        (error,) = problem(response, 422, "invalid")["errors"]
        return error["pointer"], error["code"]

    assert pointer(WAVE, length_m=5000) == ("/length_m", "too-long-for-waves")
    backwards = SPECTRUM | {"wavelength_band_m": {"min": 30, "max": 2}}
    assert pointer(backwards) == ("/irregularity/wavelength_band_m", "contradiction")
    nothing = {"kind": "measured", "profile_id": "0" * 64}
    assert pointer(nothing) == ("/irregularity/profile_id", "contradiction")
    assert pointer(WAVE, length_m=0) == ("/length_m", "greater-than-equal")
    steep = {"kind": "table", "per": "1/m", "sides": 1, "frequencies": [1e-3, 1.0000000000000002e-3, 10]}
    steep["densities"] = [1e-100, 1e12, 1]
    assert pointer(SPECTRUM | {"spectrum": steep}) == ("/irregularity", "too-high")
    narrow = {"kind": "rational", "per": "1/m", "sides": 1, "roughness": 1e-6, "cutoff": 1e-300}
    assert pointer(SPECTRUM | {"spectrum": narrow}) == ("/irregularity/spectrum/cutoff", "greater-than-equal")
