from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.catalogue import VEHICLES
from solver.contact import close_contacts
from solver.wheel import hertz_constant, hertz_stiffness

VEHICLE = VEHICLES["crh3"].values


def test_hertz_constants_and_penetration():
    worn = hertz_constant(VEHICLE)
    assert worn == pytest.approx(4.2534e-8, rel=1e-4)
    assert hertz_constant(replace(VEHICLE, wheel_tread="conical")) == pytest.approx(5.1824e-8, rel=1e-4)
    assert worn * 68_670 ** (2 / 3) == pytest.approx(0.0713e-3, rel=1e-3)
    assert hertz_stiffness(worn, 68_670) == pytest.approx(1.444e9, rel=1e-3)


def solve(approach: np.ndarray, compliance: np.ndarray, constant: float) -> tuple[np.ndarray, np.ndarray]:
    penetration, force = np.full(4, 5e-5), np.empty(4)
    assert close_contacts(approach, compliance, constant, penetration, force)
    return penetration, force


@given(
    st.lists(st.floats(-1e-3, 1e-3), min_size=4, max_size=4).map(np.array),
    st.floats(1e-11, 1e-8),
    st.floats(-0.3, 0.3),
)
def test_forces_and_penetrations_agree_and_no_wheel_is_pulled(approach, own, other):
    compliance = own * (np.eye(4) + other * (1 - np.eye(4)))
    penetration, force = solve(approach, compliance, 4.25e-8)
    np.testing.assert_allclose(penetration + compliance @ force, approach, atol=1e-13)
    np.testing.assert_allclose(force, np.maximum(penetration / 4.25e-8, 0) ** 1.5)


def test_a_lifted_wheel_carries_nothing_and_leaves_its_neighbours_alone():
    compliance = 1e-10 * np.eye(4)
    _, together = solve(np.array([1e-4, -2e-4, 1e-4, 1e-4]), compliance, 4.25e-8)
    assert together[1] == 0
    assert (together[[0, 2, 3]] > 0).all()


def test_failure_to_converge_is_reported():
    penetration, force = np.full(4, 5e-5), np.empty(4)
    assert not close_contacts(np.full(4, np.nan), np.eye(4), 4e-8, penetration, force)
