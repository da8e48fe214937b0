import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import Polynomial

from solver.beam import HermiteElement, hermite

lengths = st.floats(0.01, 10)
cubics = st.lists(st.floats(-5, 5), min_size=4, max_size=4).map(Polynomial)


def nodal(p: Polynomial, length: float) -> np.ndarray:
    return np.array([p(0), p.deriv()(0), p(length), p.deriv()(length)])


@given(cubics, lengths, st.floats(0, 1), st.integers(0, 3))
def test_shape_functions_reproduce_cubics_and_their_derivatives(p, length, xi, derivative):
    expected = p.deriv(derivative)(xi * length)
    scale = 1 + np.abs(nodal(p, length)).max() / min(length, 1) ** derivative
    assert hermite(xi, length, derivative) @ nodal(p, length) == pytest.approx(expected, abs=1e-10 * scale)


@given(cubics, cubics, lengths)
def test_integrals_are_those_of_the_polynomials(p, q, length):
    element = HermiteElement(length)
    u, v = nodal(p, length), nodal(q, length)
    for matrix, left, right in (
        (element.mass, p, q),
        (element.gradient, p, q.deriv()),
        (element.stretch, p.deriv(), q.deriv()),
        (element.bending, p.deriv(2), q.deriv(2)),
    ):
        exact = (left * right).integ()(length)
        scale = np.abs(u) @ np.abs(matrix) @ np.abs(v)
        assert u @ matrix @ v == pytest.approx(exact, abs=1e-11 * scale + 1e-12)


@given(lengths)
def test_convection_creates_no_energy(length):
    convection = HermiteElement(length).convection
    np.testing.assert_array_equal(convection, -convection.T)


def test_textbook_matrices():
    element = HermiteElement(2.0)
    np.testing.assert_allclose(element.mass[0] * 420 / 2, [156, 44, 54, -26], rtol=1e-13)
    np.testing.assert_allclose(element.bending[0] * 8, [12, 12, -12, 12], rtol=1e-13)
