import numpy as np
import pytest
from scipy.linalg import eigh

from solver.catalogue import VEHICLES
from solver.start import static_equilibrium
from solver.vehicle import vehicle_matrices, wheel_positions
from solver.wheel import static_wheel_load

VEHICLE = VEHICLES["crh3"].values


def test_frequencies_of_the_car_on_held_wheels():
    m = vehicle_matrices(VEHICLE)
    squared = eigh(m.stiffness[:6, :6], m.mass[:6, :6], eigvals_only=True)
    frequencies = np.sqrt(squared) / (2 * np.pi)
    np.testing.assert_allclose(frequencies, [0.920, 2.138, 4.921, 4.921, 6.279, 6.347], atol=5e-4)


def test_springs_and_dampers_resist_no_rigid_motion():
    m = vehicle_matrices(VEHICLE)
    bounce = np.array([1, 0, 1, 0, 1, 0, 1, 1, 1, 1])
    a, b = VEHICLE.half_bogie_distance, VEHICLE.half_wheelbase
    pitch = np.array([0, 1, a, 1, -a, 1, a + b, a - b, -a + b, -a - b])
    for matrix in (m.stiffness, m.damping):
        np.testing.assert_allclose(matrix @ np.c_[bounce, pitch], 0, atol=1e-8)
    assert m.weight @ pitch == pytest.approx(0, abs=1e-9)


def test_static_wheel_load():
    assert static_wheel_load(VEHICLE) == pytest.approx(68_670)
    assert wheel_positions(VEHICLE).tolist() == [9.9375, 7.4375, -7.4375, -9.9375]


def test_at_rest_every_wheel_carries_its_weight_on_an_even_rail():
    compliance = 1e-8 * np.eye(4)
    displacement, penetration, force = static_equilibrium(VEHICLE, compliance)
    np.testing.assert_allclose(force, 68_670, rtol=1e-12)
    np.testing.assert_allclose(penetration, 7.13e-5, rtol=1e-3)  # 0.0713 mm
    m = vehicle_matrices(VEHICLE)
    np.testing.assert_allclose(m.stiffness @ displacement + np.r_[np.zeros(6), force], m.weight, atol=1e-6)


def test_at_rest_the_wheels_of_an_articulated_car_carry_the_same_on_an_uneven_rail():
    compliance = np.diag([1e-8, 5e-8, 1e-8, 2e-8])
    displacement, _, force = static_equilibrium(VEHICLE, compliance)
    m = vehicle_matrices(VEHICLE)
    np.testing.assert_allclose(m.stiffness @ displacement + np.r_[np.zeros(6), force], m.weight, atol=1e-4)
