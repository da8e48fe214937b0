"""The solver through its one door, against answers found in other ways."""

from dataclasses import replace

import numpy as np
import pytest

from solver.case import Harmonic, Numerics, Smooth, Spectral
from solver.catalogue import TRACKS
from solver.errors import DivergedError
from solver.peaks import peaks
from solver.simulate import Response, solve

TB = Spectral(wavelength_min=2.0, wavelength_max=30.0)


def history(response: Response, quantity: str, position: str = "wheelset_1") -> np.ndarray:
    index = next(i for i, c in enumerate(response.channels) if (c.quantity, c.position) == (quantity, position))
    return response.values[index]


def peak(response: Response, quantity: str, position: str = "wheelset_1"):
    return next(p for p in peaks(response) if (p.quantity, p.position) == (quantity, position))


@pytest.mark.parametrize("irregularity", [Harmonic(wavelength=1.0, amplitude=3e-4), TB], ids=["harmonic", "spectrum"])
def test_twice_the_track_changes_no_peak_by_more_than_a_thousandth(make_case, irregularity):
    once, twice = (
        solve([make_case(irregularity=irregularity, numerics=Numerics(track_length=length, settle=0.6, window=0.4))])[0]
        for length in (140.0, 280.0)
    )
    for short, long in zip(peaks(once), peaks(twice), strict=True):
        assert short.peak == pytest.approx(long.peak, rel=1e-3), short


def test_a_lane_does_not_know_its_neighbours(make_case, conical_vehicle):
    one, two, three, four = (
        make_case(),
        make_case(irregularity=TB),
        make_case(vehicle=conical_vehicle),
        make_case(irregularity=Smooth()),
    )
    elsewhere = make_case(speed=300 / 3.6)
    together = solve([one, two, elsewhere, three])
    assert [response.case for response in together] == [one, two, elsewhere, three]
    others = solve([three, four, one])
    np.testing.assert_array_equal(together[0].values, others[2].values)
    np.testing.assert_array_equal(together[3].values, others[0].values)


@pytest.mark.parametrize("slab", ["continuous", "discontinuous"])
def test_segments_of_one_track_say_what_a_lane_says(make_case, slab):
    case = make_case(slab=slab, irregularity=TB)
    alone = solve([case])[0]
    lane = solve([case, make_case(slab=slab), make_case(slab=slab, irregularity=Smooth())])[0]
    largest = np.abs(lane.values).max(axis=1, keepdims=True)
    np.testing.assert_allclose(alone.values / largest, lane.values / largest, atol=1e-9)
    for peak_alone, peak_in_lane in zip(peaks(alone), peaks(lane), strict=True):
        assert peak_alone.peak == pytest.approx(peak_in_lane.peak, rel=1e-9, abs=1e-12)


def test_a_diverging_lane_fails_alone(make_case):
    soft = replace(TRACKS["crts2"].values, roadbed_stiffness=2e6)
    sane = make_case(track=soft)
    heavy = replace(sane.vehicle, car_body_mass=1e6, bogie_mass=1e5, wheelset_mass=1e5)
    wild = make_case(track=soft, irregularity=Harmonic(wavelength=3.0, amplitude=0.02), vehicle=heavy)
    good, bad, _ = solve([sane, wild, sane])
    np.testing.assert_array_equal(good.values, solve([sane, sane, sane])[0].values)
    assert isinstance(bad, DivergedError)
    bad = solve([wild])[0]
    assert isinstance(bad, DivergedError)
    assert bad.code == "diverged"


def test_progress_grows_to_one_and_an_exception_ends_the_solve(make_case):
    seen: list[float] = []
    solve([make_case(), make_case(speed=80.0)], seen.append)
    assert seen == sorted(seen)
    assert seen[0] == 0
    assert seen[-1] == 1
    assert len(seen) > 10

    class StopSolvingError(Exception):
        pass

    def stop(fraction: float) -> None:
        if fraction > 0.3:
            raise StopSolvingError

    with pytest.raises(StopSolvingError):
        solve([make_case()], stop)


def test_peaks_are_read_off_the_histories(make_case):
    response = solve([make_case()])[0]
    for p in peaks(response):
        if p.quantity in {c.quantity for c in response.channels}:
            values = history(response, p.quantity, p.position)
            at = np.argmin(np.abs(response.time - p.time))
            assert p.maximum == values.max()
            assert p.minimum == values.min()
            assert p.peak == (values[at] if p.quantity == "wheel_rail_force" else abs(values[at]))
            assert p.peak == max(p.maximum, 0 if p.quantity == "wheel_rail_force" else -p.minimum)
            assert p.rms**2 == pytest.approx(p.mean**2 + p.std**2)
            assert response.track_position[at] == p.track_position
    unloading = peak(response, "wheel_unloading")
    assert unloading.peak == pytest.approx(1 - peak(response, "wheel_rail_force").minimum / 68_670)
    assert response.track_position[-1] == pytest.approx(response.case.speed * 0.7, abs=0.02)
