from dataclasses import replace

import numpy as np
import pytest

from solver.case import Harmonic, Joint, Numerics, Smooth
from solver.catalogue import TRACKS
from solver.reference import track_fixed
from solver.reference.layered import LayeredTrack
from solver.reference.track_fixed import solve_track_fixed
from solver.reference.track_fixed_model import build_mesh, track_matrices, wheel_positions, whole

TRACK = TRACKS["crts2"].values
SHORT = Numerics(track_length=110.0, elements_per_pad=6, time_step=2e-4, settle=0.3, window=0.1)


def jointed(stiffness: float, damping: float = 0.0, **parts):
    return replace(TRACK, joint=Joint(shear_stiffness=stiffness, shear_damping=damping, **parts))


@pytest.fixture
def make_short(make_case):
    return lambda **parts: make_case(**{"slab": "discontinuous", "numerics": SHORT} | parts)


@pytest.mark.parametrize("slab", ["continuous", "discontinuous"])
def test_nodes_stand_at_pads_and_joints(make_short, slab):
    case = make_short(slab=slab, track=jointed(1e8, position=0.45, pads_per_slab=7))
    mesh = build_mesh(case)
    np.testing.assert_allclose(mesh.x[mesh.pads], 0.65 * np.arange(len(mesh.pads)))
    np.testing.assert_allclose(mesh.x[mesh.joints], 0.65 * (0.45 + 7 * np.arange(len(mesh.joints))))
    assert len(mesh.joints) == (0 if slab == "continuous" else 26)
    assert np.diff(mesh.x).min() > 0
    unknowns = np.unique(np.concatenate([mesh.rail, mesh.slab_behind, mesh.slab_ahead, mesh.base]))
    np.testing.assert_array_equal(unknowns, np.arange(0, mesh.size, 2))


def test_matrices_weigh_and_carry_the_track(make_short):
    case = make_short(track=jointed(1e8, 8e4, position=0.45))
    mesh = build_mesh(case)
    mass, damping, stiffness = (whole(m) for m in track_matrices(case.track, mesh, np.full(len(mesh.x) - 1, 1e4)))
    length = mesh.x[-1]
    down = np.zeros(mesh.size)
    down[::2] = 1
    assert down @ mass @ down == pytest.approx(length * (TRACK.rail_mass + TRACK.slab_mass + TRACK.base_mass))
    assert down @ damping @ down == pytest.approx(length * (TRACK.roadbed_damping + 1e4))
    assert down @ stiffness @ down == pytest.approx(length * TRACK.roadbed_stiffness)

    behind = mesh.joints[3]
    opened = np.zeros(mesh.size)  # everything behind one joint moves down by 1 with the slab alone
    opened[np.unique([mesh.slab_behind[: behind + 1], mesh.slab_ahead[: behind + 1]])] = 1
    opened[mesh.slab_ahead[behind]] = 0
    work = TRACK.mortar_stiffness * mesh.x[behind] + 1e8 + TRACK.pad_stiffness * (mesh.pads <= behind).sum()
    assert opened @ stiffness @ opened == pytest.approx(work)

    turned = np.zeros(mesh.size)  # a slab turns about its joint without bending it
    nodes = np.arange(mesh.joints[3], mesh.joints[4] + 1)
    for side, part in ((mesh.slab_ahead, nodes[:-1]), (mesh.slab_behind, nodes[1:])):
        turned[side[part]] = mesh.x[part] - mesh.x[nodes[0]]
        turned[side[part] + 1] = 1
    pads = mesh.x[[n for n in mesh.pads if nodes[0] < n < nodes[-1]]] - mesh.x[nodes[0]]
    slab = mesh.slab_length
    work = TRACK.mortar_stiffness * slab**3 / 3 + 1e8 * slab**2 + TRACK.pad_stiffness * (pads**2).sum()
    assert turned @ stiffness @ turned == pytest.approx(work)


def test_creeping_over_even_rail_meets_weight_and_static_deflection(make_case):
    track = replace(TRACK, pad_spacing=0.625)
    numerics = replace(SHORT, window=0.225)  # one pad spacing
    case = make_case(slab="continuous", speed=10 / 3.6, irregularity=Smooth(), track=track, numerics=numerics)
    response = solve_track_fixed(case)
    np.testing.assert_allclose(response.force, 68_670, rtol=3e-4)
    wheels = wheel_positions(case.vehicle)
    expected = LayeredTrack(track, 0.0).static_deflection(np.full(4, 68_670), wheels, wheels[0])
    fields = (response.rail_displacement, response.slab_displacement, response.base_displacement)
    np.testing.assert_allclose([field.mean() for field in fields], expected, rtol=3e-3)


def test_it_matters_not_where_the_track_is_numbered_from(make_short):
    first, second = (
        solve_track_fixed(make_short(numerics=replace(SHORT, start=start, settle=0.3, window=0.02)))
        for start in (3.0, -62.0)
    )
    np.testing.assert_allclose(first.track_position - second.track_position, 65.0)
    np.testing.assert_allclose(first.force, second.force, rtol=1e-9)


@pytest.mark.parametrize(("stiffness", "damping"), [(0.0, 0.0), (1e13, 0.0), (1e13, 1e9)])
def test_joints_without_and_with_rigid_shear_transfer(make_short, stiffness, damping):
    response = solve_track_fixed(make_short(track=jointed(stiffness, damping)))
    assert np.abs(response.slab_acceleration).max() < 80
    assert np.abs(response.force - 68_670).max() < 60e3
    if stiffness:
        assert np.abs(response.joint_jump).max() < 1e-8
    else:
        assert 5e-5 < np.abs(response.joint_jump).max() < 3e-4


@pytest.mark.slow
def test_another_model_with_double_nodes_agrees(make_case, conical_vehicle, monkeypatch):
    """Figures of another model, whose joints stand where the sine begins, that is half a pad spacing from here."""
    sample = track_fixed.sample
    monkeypatch.setattr(track_fixed, "sample", lambda eta, start, *rest: sample(eta, start - 0.325, *rest))
    numerics = Numerics(track_length=110.0, settle=0.7, window=0.27)  # two slabs: the sine's and the joints' period
    r = solve_track_fixed(make_case(slab="discontinuous", vehicle=conical_vehicle, numerics=numerics))
    assert r.force[0].max() == pytest.approx(112.44e3, rel=0.002)
    assert r.force[0].min() == pytest.approx(25.53e3, rel=0.005)
    assert r.rail_displacement.max() == pytest.approx(1.273e-3, rel=0.002)
    for field, expected in ((r.rail_acceleration, 167.6), (r.slab_acceleration, 50.2), (r.base_acceleration, 40.64)):
        assert np.abs(field).max() == pytest.approx(expected, rel=0.01)


@pytest.mark.slow
def test_length_step_and_elements_suffice(make_short):
    numerics = Numerics(track_length=110.0, elements_per_pad=6, settle=0.5, window=0.134)
    irregularity = Harmonic(wavelength=3.0, amplitude=3e-4)
    once = solve_track_fixed(make_short(numerics=numerics, irregularity=irregularity))
    for change, tolerance in (
        ({"track_length": 140.0}, 1e-3),
        ({"time_step": 5e-5}, 2e-3),
        ({"elements_per_pad": 12}, 2e-3),
    ):
        other = solve_track_fixed(make_short(numerics=replace(numerics, **change), irregularity=irregularity))
        assert other.force.max() == pytest.approx(once.force.max(), rel=tolerance)
        assert other.rail_displacement.max() == pytest.approx(once.rail_displacement.max(), rel=tolerance)
