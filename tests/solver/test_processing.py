"""What is recorded is enough to derive the indices again, with other code."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import butter, sosfilt, sosfilt_zi

from solver import indices
from solver.case import Case, Smooth
from solver.catalogue import TRACKS, VEHICLES
from solver.channels import CHANNELS
from solver.peaks import peaks
from solver.processing import processing
from solver.simulate import Response, solve

CASE = Case(speed=80.0, irregularity=Smooth(), track=TRACKS["crts2"].values, vehicle=VEHICLES["crh3"].values)


def response_of(samples: int, step: float) -> Response:
    """Noise in every channel; a force that is lost now and then."""
    time = step * np.arange(1, samples + 1)
    values = np.random.default_rng(samples).normal(1.0, 0.8, (len(CHANNELS), samples))
    return Response(
        case=CASE, time=time, track_position=CASE.speed * time, channels=CHANNELS, values=values, time_step=step
    )


def filtered(values, step, record):
    assert (record["kind"], record["edges"]) == ("Butterworth", "mirrored")
    assert record["passes"] == "forwards and backwards, zero phase"
    edge = round(record["mirrored_s"] / step)
    values = np.pad(values, edge, mode="reflect")
    kind = record["band"].replace("-", "")
    sections = butter(record["order_of_one_pass_per_edge"], record["cutoff_hz"], kind, fs=1 / step, output="sos")
    for _ in range(2):
        values = sosfilt(sections, values, zi=sosfilt_zi(sections) * values[0])[0][::-1]
    return values[edge : len(values) - edge]


def sperling_index(values, step, record):
    length = round(record["window_s"] / step)
    low, high = record["band_hz"]
    f = np.fft.rfftfreq(length, step)
    f, counted = f[(f >= low) & (f <= high)], (f >= low) & (f <= high)
    weight = np.select([f < 5.9, f < 20], [0.325 * f**2, 400 / f**2], 1.0)
    windows = values[: record["windows"] * length].reshape(record["windows"], length)
    spectra = 2 / length * np.abs(np.fft.rfft(windows)[:, counted])
    return max(3.57 * np.sum(spectra**3 / f * weight, axis=1) ** 0.1)


def assert_enough(response: Response) -> None:
    """The record, having gone through JSON, leads to the peaks that are stored with it."""
    record = json.loads(json.dumps(processing(response)))
    assert record == processing(response)
    step, samples = record["sampling_step_s"], record["samples"]
    assert record["window_s"] == pytest.approx(response.time[-1])
    by_quantity = dict(zip((channel.quantity for channel in CHANNELS), response.values, strict=False))
    force, body = response.values[0], by_quantity["car_body_acceleration"]
    slow_force = filtered(force, step, record["filters"]["wheel_rail_force_20hz"])
    lost = force <= record["contact_lost_at_or_below_n"]
    assert samples == len(force)
    expected = {
        "wheel_rail_force_20hz": slow_force.max(),
        "wheel_rail_force_quantile": np.quantile(force, record["quantile"]),
        "wheel_rail_force_20hz_quantile": np.quantile(slow_force, record["quantile"]),
        "contact_loss_events": np.count_nonzero(np.diff(lost, prepend=False) & lost),
        "car_body_acceleration_comfort": np.abs(
            filtered(body, step, record["filters"]["car_body_acceleration_comfort"])
        ).max(),
        "sperling_index": sperling_index(body, step, record["sperling_index"]),
    }
    stored = {p.quantity: p.peak for p in peaks(response) if p.position in ("wheelset_1", "car_body")}
    assert {name: stored[name] for name in expected} == pytest.approx(expected, rel=1e-6, abs=1e-9)


@given(st.integers(10, 20_000), st.floats(5e-5, 1e-3))
def test_the_record_is_enough_for_any_window(samples, step):
    assert_enough(response_of(samples, step))


@pytest.mark.parametrize(
    ("constant", "value"),
    [
        ("FILTER_ORDER", 2),
        ("FORCE_CUTOFF_HZ", 35.0),
        ("COMFORT_BAND_HZ", (0.8, 6.0)),
        ("QUANTILE", 0.95),
        ("SPERLING_WINDOW_S", 1.5),
        ("SPERLING_BAND_HZ", (2.0, 30.0)),
        ("CONTACT_LOST_N", 0.3),
    ],
)
def test_the_record_follows_what_is_done(monkeypatch, constant, value):
    response = response_of(7001, 1e-3)
    record, before = processing(response), peaks(response)
    monkeypatch.setattr(indices, constant, value)
    assert processing(response) != record
    assert peaks(response) != before
    assert_enough(response)


def test_a_long_window_holds_whole_windows_of_sperling_and_a_short_one_is_one():
    assert processing(response_of(12_345, 1e-3))["sperling_index"] == {
        "window_s": 5.0,
        "windows": 2,
        "band_hz": [0.5, 80.0],
    }
    short = processing(response_of(50, 1e-3))
    assert short["sperling_index"]["window_s"] == short["window_s"] == 0.05
    assert short["filters"]["car_body_acceleration_comfort"]["mirrored_s"] == 0.049


def test_signs_are_those_of_the_conventions(make_case):
    (response,) = solve([make_case(irregularity=Smooth())])
    record = processing(response)
    numerics, conventions = response.case.numerics, record["conventions"]
    assert (record["settle_s"], record["ease_in_s"]) == (numerics.settle, numerics.ease_in)
    mean = {p.quantity: p.mean for p in peaks(response) if p.position in ("wheelset_1", "pads")}
    assert "positive downwards" in conventions["direction"]
    assert mean["rail_displacement"] > mean["slab_displacement"] > mean["base_displacement"] > 0
    assert "positive where the underside is stretched" in conventions["slab_moment"]
    for pushed in ("slab_moment", "pad_force", "roadbed_pressure"):
        assert mean[pushed] > 0
    assert "per length of track, N/m" in conventions["roadbed_pressure"]
    stiffness = response.case.track.roadbed_stiffness  # per length, N/m^2
    assert mean["roadbed_pressure"] == pytest.approx(stiffness * mean["base_displacement"], rel=0.05)
