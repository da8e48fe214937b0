"""The solver through its one door, against answers found in other ways."""

from dataclasses import replace

import numpy as np
import pytest

from solver.case import Harmonic, Numerics, Smooth, Spectral
from solver.catalogue import TRACKS
from solver.errors import DivergedError
from solver.peaks import peaks
from solver.reference.layered import LayeredTrack, contact_force
from solver.reference.winkler import WinklerBeam
from solver.simulate import Response, solve
from solver.track import BASE, RAIL, SLAB, TrackModel
from solver.vehicle import static_wheel_load, wheel_positions

TB = Spectral(wavelength_min=2.0, wavelength_max=30.0)


def history(response: Response, quantity: str, position: str = "wheelset_1") -> np.ndarray:
    index = next(i for i, c in enumerate(response.channels) if (c.quantity, c.position) == (quantity, position))
    return response.values[index]


def peak(response: Response, quantity: str, position: str = "wheelset_1"):
    return next(p for p in peaks(response) if (p.quantity, p.position) == (quantity, position))


@pytest.mark.parametrize(
    ("speed", "damping"), [(10 / 3.6, 0.0), (50.0, 0.0), (97.22, 0.0), (97.22, 4900.0), (1.2 * 510.655, 4900.0)]
)
def test_moving_force_on_a_winkler_beam(make_case, speed, damping):
    """Pads 25 mm apart on a slab that cannot move are a Winkler foundation."""
    spacing, bending_stiffness = 0.025, 6.12e6
    track = replace(
        TRACKS["crts2"].values,
        rail_second_moment=bending_stiffness / TRACKS["crts2"].values.rail_elastic_modulus,
        rail_mass=60.0,
        pad_spacing=spacing,
        pad_stiffness=1e7 * spacing,
        pad_damping=damping * spacing,
        mortar_stiffness=1e16,
        roadbed_stiffness=1e16,
    )
    case = make_case(track=track, numerics=Numerics(track_length=95.0, elements_per_pad=2, time_step=1e-4), speed=25.0)
    model = TrackModel(case)
    object.__setattr__(model.case, "speed", speed)  # beyond what a train may do
    at = 0.3
    response = model.steady_response(0, model.unit_loads(np.array([at])))[:, 0] * 1e5
    beam = WinklerBeam(bending_stiffness=bending_stiffness, mass=60.0, stiffness=1e7, damping=damping)
    distances = np.array([-2.0, 0.0, 1.0])
    points = [model.point(at + distance, RAIL) for distance in distances]
    deflection = [weights @ response[row : row + 12] for row, weights in points]
    expected = beam.deflection(distances, 1e5, speed)
    np.testing.assert_allclose(deflection, expected, atol=1e-3 * np.abs(expected).max())


def test_displacement_under_a_load_converges_with_the_third_power_of_the_element_or_better(make_case):
    def deflection(elements_per_pad: int) -> float:
        numerics = Numerics(track_length=95.0, elements_per_pad=elements_per_pad)
        model = TrackModel(make_case(numerics=numerics))
        first_wheel = wheel_positions(model.case.vehicle)[0]
        response = model.steady_response(0, model.unit_loads(np.array([first_wheel])))[:, 0]
        row, weights = model.point(first_wheel, RAIL)
        return float(weights @ response[row : row + 12])

    exact = deflection(32)
    errors = np.abs([deflection(count) - exact for count in (2, 4, 8)])
    slopes = -np.log2(errors[1:] / errors[:-1])
    assert (slopes > 2.9).all(), slopes


def test_at_rest_forces_equal_weight_and_the_track_meets_the_static_three_layers(make_case):
    case = make_case(irregularity=Smooth(), track=replace(TRACKS["crts2"].values, pad_spacing=0.625), speed=20 / 3.6)
    model, wheels = TrackModel(case), wheel_positions(case.vehicle)
    loads = np.full(4, static_wheel_load(case.vehicle))
    layered = LayeredTrack(case.track, 0.0).static_deflection(loads, wheels, wheels[0])
    phases = np.linspace(0, case.phases, 8, endpoint=False).astype(int)
    mean = np.zeros(3)
    for phase in phases:
        response = model.steady_response(phase, model.unit_loads(wheels) @ loads)
        for beam in (RAIL, SLAB, BASE):
            row, weights = model.point(wheels[0], beam)
            mean[beam] += weights @ response[row : row + 12] / len(phases)
    assert (np.abs(mean / layered - 1) < [1e-2, 2e-3, 2e-3]).all()


def test_a_slow_train_on_a_smooth_rail_meets_the_static_answer(make_case):
    numerics = Numerics(track_length=95.0, elements_per_pad=6, time_step=5e-4, settle=1.5, window=0.4)
    case = make_case(irregularity=Smooth(), speed=10 / 3.6, numerics=numerics)
    response = solve([case])[0]
    load = static_wheel_load(case.vehicle)
    np.testing.assert_allclose(response.values[:4].mean(axis=1), load, rtol=1e-3)
    assert np.ptp(history(response, "wheel_rail_force")) < 0.01 * load
    # Over a pad and between pads the rail yields as the track held at that phase does.
    model, wheels = TrackModel(case), wheel_positions(case.vehicle)
    step = np.round((numerics.settle + response.time) / case.time_step).astype(int)
    for phase in (0, case.phases // 2):
        steady = model.steady_response(phase, model.unit_loads(wheels) @ np.full(4, load))
        row, weights = model.point(wheels[0], RAIL)
        rail = history(response, "rail_displacement")[(step % case.phases) == phase]
        np.testing.assert_allclose(rail, weights @ steady[row : row + 12], rtol=2e-3)


@pytest.mark.parametrize("speed_kmh", [160, 200, 250, 300, 350])
def test_harmonic_irregularity_meets_the_frequency_domain(make_case, conical_vehicle, speed_kmh):
    """Amplitudes within 5 % where the wheels keep contact; loss of contact is reported where they do not."""
    track = replace(TRACKS["crts2"].values, pad_spacing=0.625)
    numerics = Numerics(track_length=95.0, settle=0.9, window=0.5)
    parts = {"speed": speed_kmh / 3.6, "track": track, "vehicle": conical_vehicle, "numerics": numerics}
    small, full = (make_case(irregularity=Harmonic(wavelength=1.0, amplitude=a), **parts) for a in (3e-5, 3e-4))
    reference = np.abs(contact_force(track, conical_vehicle, small.speed, 1.0))
    for response in solve([small, full]):
        whole = response.time <= np.floor(response.time[-1] * small.speed) / small.speed  # whole wavelengths
        turn = np.exp(-2j * np.pi * small.speed * response.time[whole])
        amplitude = 2 * np.abs((response.values[:4, whole] * turn).mean(axis=1))
        tolerance = 0.01 if response.case is small else 0.05
        lost = any(peak(response, "contact_loss", f"wheelset_{i}").peak for i in (1, 2, 3, 4))
        if not lost:
            np.testing.assert_allclose(amplitude, reference * response.case.irregularity.amplitude, rtol=tolerance)
        assert lost == (response.case is full and speed_kmh == 200)


@pytest.mark.parametrize("irregularity", [Harmonic(wavelength=1.0, amplitude=3e-4), TB], ids=["harmonic", "spectrum"])
def test_twice_the_track_changes_no_peak_by_more_than_a_thousandth(make_case, irregularity):
    once, twice = (
        solve([make_case(irregularity=irregularity, numerics=Numerics(track_length=length, settle=0.6, window=0.4))])[0]
        for length in (140.0, 280.0)
    )
    for short, long in zip(peaks(once), peaks(twice), strict=True):
        assert short.peak == pytest.approx(long.peak, rel=1e-3), short


def test_second_order_in_time(make_case):
    irregularity = Harmonic(wavelength=3.0, amplitude=3e-4)

    def force(phases: int) -> np.ndarray:
        step = 0.65 / (97.5 * phases)
        numerics = Numerics(track_length=95.0, elements_per_pad=2, time_step=step, settle=0.4, window=0.1)
        response = solve([make_case(speed=97.5, irregularity=irregularity, numerics=numerics)])[0]
        assert response.time_step == pytest.approx(step)
        return history(response, "wheel_rail_force")[phases - 1 :: phases][:12]

    coarse, middle, fine, finest = (force(n) for n in (20, 40, 80, 160))
    errors = [np.abs(a - b).max() for a, b in ((coarse, middle), (middle, fine), (fine, finest))]
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert slopes[-1] == pytest.approx(2, abs=0.3), slopes


def test_lanes_are_solved_as_if_alone_whatever_their_neighbours(make_case, conical_vehicle):
    cases = [
        make_case(),
        make_case(irregularity=TB),
        make_case(speed=300 / 3.6),
        make_case(vehicle=conical_vehicle),
        make_case(irregularity=Smooth()),
    ]
    together = solve(cases)
    assert [r.case for r in together] == cases
    for case, response in zip(cases, together, strict=True):
        np.testing.assert_array_equal(solve([case])[0].values, response.values)


def test_a_diverging_lane_fails_alone(make_case):
    soft = replace(TRACKS["crts2"].values, roadbed_stiffness=2e6)
    sane = make_case(track=soft)
    heavy = replace(sane.vehicle, car_body_mass=1e6, bogie_mass=1e5, wheelset_mass=1e5)
    wild = make_case(track=soft, irregularity=Harmonic(wavelength=3.0, amplitude=0.02), vehicle=heavy)
    good, bad = solve([sane, wild])
    np.testing.assert_array_equal(good.values, solve([sane])[0].values)
    assert isinstance(bad, DivergedError)
    assert bad.code == "diverged"


def test_percentiles_scale_the_dynamic_part_in_the_linear_regime(make_case):
    low, mean = (make_case(irregularity=replace(TB, percentile=p)) for p in (1e-6, 4e-6))
    smooth, one, two = solve([make_case(irregularity=Smooth()), low, mean])
    first, second = ((r.values - smooth.values)[:11] for r in (one, two))  # of forces and track
    scale = np.abs(second).max(axis=1, keepdims=True)
    np.testing.assert_allclose(second / scale, 2.0 * first / scale, atol=2e-3)


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
