from dataclasses import replace

import numpy as np
import pytest

from solver.catalogue import TRACKS, VEHICLES
from solver.reference.layered import LayeredTrack, contact_force, wheel_receptance
from solver.reference.winkler import WinklerBeam
from solver.vehicle import vehicle_matrices, wheel_positions
from solver.wheel import static_wheel_load

TRACK = replace(TRACKS["crts2"].values, pad_spacing=0.625)
VEHICLE = replace(VEHICLES["crh3"].values, wheel_tread="conical")


def test_static_deflection_of_the_three_layers():
    # The rail's 0.903 mm stems from a sum over fewer wavenumbers, which slab and base do not need.
    wheels = wheel_positions(VEHICLE)
    loads = np.full(4, static_wheel_load(VEHICLE))
    for track, expected in (
        (TRACK, [0.903, 0.440, 0.403]),
        (replace(TRACK, mortar_stiffness=4.5e8, roadbed_stiffness=3e7), [1.277, 0.816, 0.748]),
    ):
        deflection = LayeredTrack(track, 0.0).static_deflection(loads, wheels, wheels[0]) * 1e3
        np.testing.assert_allclose(deflection, expected, rtol=3e-3)


def test_on_a_rigid_slab_it_is_the_winkler_beam():
    track = replace(TRACK, mortar_stiffness=1e16, roadbed_stiffness=1e16, pad_stiffness=6.25e6, pad_damping=3000.0)
    beam = WinklerBeam(
        bending_stiffness=track.rail_elastic_modulus * track.rail_second_moment,
        mass=track.rail_mass,
        stiffness=1e7,
        damping=4800.0,
    )
    at = np.array([-1.5, 0.0, 0.7])
    receptance = LayeredTrack(track, 97.22).receptances(0.0, at)[0]
    np.testing.assert_allclose(receptance.real, beam.deflection(at, 1.0, 97.22), rtol=1e-6)


def test_wheel_receptance_is_that_of_the_vehicle_matrices():
    m, omega = vehicle_matrices(VEHICLE), 2 * np.pi * 30.0
    dynamic = m.stiffness + 1j * omega * m.damping - omega**2 * m.mass
    np.testing.assert_allclose(wheel_receptance(VEHICLE, omega), np.linalg.inv(dynamic)[6:, 6:], rtol=1e-12)


@pytest.mark.parametrize(("speed_kmh", "force_kn"), [(160, 32.3), (200, 62.0), (250, 57.0), (300, 53.7), (350, 43.5)])
def test_contact_force_of_a_harmonic_irregularity(speed_kmh, force_kn):
    force = np.abs(contact_force(TRACK, VEHICLE, speed_kmh / 3.6, 1.0)[0]) * 3e-4 / 1e3
    assert force == pytest.approx(force_kn, rel=0.03)
