"""The compiled passes and the periodic factors against sparse matrices of the whole track."""

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from solver.banded import factorise, substitute
from solver.case import Numerics
from solver.integrator import integrator
from solver.kernels import absorb, advance, stencils
from solver.periodic import periodic_operator
from solver.track import RAIL, TrackModel
from solver.vehicle import wheel_positions

WIDTHS = [1, 2, 4, 8]


def sparse_from(band: np.ndarray) -> sparse.csc_array:
    n = len(band)
    diagonals = [band[max(0, -k) : n - max(0, k), 9 + k] for k in range(-9, 10)]
    return sparse.diags_array(diagonals, offsets=range(-9, 10)).tocsc()


def matrix(model: TrackModel, phase: int, inertia: float, damping: float) -> sparse.csc_array:
    return sparse_from(model.band(model.cells, phase, inertia, damping))


@pytest.mark.parametrize("width", WIDTHS)
def test_banded_solution(width):
    rng = np.random.default_rng(width)
    rows, cells = 18, 5
    band = rng.standard_normal((rows * cells, 19))
    band[:, 9] += 12
    full = sparse_from(band)
    factors = factorise(band.copy()).reshape(cells, rows, 19)
    right = rng.standard_normal((rows * cells, width))
    x = right.copy()
    substitute(factors, np.arange(cells), x, (0.0,) * width)
    np.testing.assert_allclose(full @ x, right, atol=1e-12)


def test_a_lane_does_not_know_its_neighbours():
    rng = np.random.default_rng(0)
    band = rng.standard_normal((90, 19))
    band[:, 9] += 12
    factors = factorise(band).reshape(5, 18, 19)
    right = rng.standard_normal((90, 8))
    together = right.copy()
    substitute(factors, np.arange(5), together, (0.0,) * 8)
    for lane in range(8):
        alone = np.ascontiguousarray(right[:, lane : lane + 1])
        substitute(factors, np.arange(5), alone, (0.0,))
        np.testing.assert_array_equal(alone[:, 0], together[:, lane])


@pytest.mark.parametrize("phase", [0, 1, 17, 66])
def test_periodic_factors_windows_and_compliances_are_those_of_the_whole_matrix(make_case, phase):
    case = make_case(numerics=Numerics(track_length=100.0))
    model, scheme = TrackModel(case), integrator(case.time_step, 0.8)
    wheels = wheel_positions(case.vehicle)
    operator = periodic_operator(model, scheme, wheels)
    full = matrix(model, phase, scheme.inertia, scheme.damping)
    right = np.random.default_rng(phase).standard_normal((full.shape[0], 4))
    right[:6] = 0
    x = right.copy()
    substitute(operator.blocks, operator.block_of_cell[phase], x, (0.0,) * 4)
    exact = spsolve(full, right)
    np.testing.assert_allclose(x, exact, atol=1e-11 * np.abs(exact).max())
    responses = spsolve(full, model.unit_loads(wheels))
    for j in range(4):
        windowed = np.zeros(full.shape[0])
        start = operator.window_start[j]
        windowed[start : start + operator.windows.shape[2]] = operator.windows[phase, j]
        np.testing.assert_allclose(windowed, responses[:, j], atol=1e-12 * np.abs(responses[:, j]).max())
        for i, position in enumerate(wheels):
            row, weights = model.point(position, RAIL)
            under_wheel = weights @ responses[row : row + 12, j]
            assert operator.compliance[phase, i, j] == pytest.approx(under_wheel, rel=1e-9, abs=1e-22)


@pytest.mark.parametrize("width", WIDTHS)
def test_advance_is_the_integrator_on_the_whole_matrices(make_case, width):
    case = make_case()
    model, k = TrackModel(case), integrator(case.time_step, 0.8)
    phase, big = 5, 1e13  # large factors keep M and C from drowning in K
    stiffness = matrix(model, phase, 0, 0)
    mass = (matrix(model, phase, big, 0) - stiffness) / big
    damping = (matrix(model, phase, 0, big) - stiffness) / big
    rng = np.random.default_rng(width)
    x, u, v = rng.standard_normal((3, stiffness.shape[0], width))
    u = x + 1e-9 * u
    x[:6] = u[:6] = v[:6] = 0
    acceleration = k.acceleration * (x - u)
    velocity = v + k.velocity * acceleration
    pu, pv = x + k.step * velocity + k.drift * acceleration, velocity + k.kick * acceleration
    expected = mass @ (k.inertia * pu - k.alpha * acceleration) + damping @ (k.damping * pu - pv)
    expected[:6] = 0
    advance(k, stencils(model, k.step), phase, x, u, v, x, (0.0,) * width)
    np.testing.assert_allclose(u, pu, atol=1e-13)
    np.testing.assert_allclose(v, pv, atol=1e-12)
    np.testing.assert_allclose(x, expected, atol=1e-12 * np.abs(expected).max())


@pytest.mark.parametrize("width", WIDTHS)
def test_ends_take_away_velocity_as_a_field(make_case, width):
    """Nodal slopes follow: what is left of a velocity is the field times what a step leaves at each place."""
    case = make_case()
    model, k = TrackModel(case), integrator(case.time_step, 0.8)
    node = np.arange(model.cells * case.numerics.elements_per_pad)
    left, slope = model.absorption(k.step).T
    length = model.element.length
    np.testing.assert_allclose(slope[1:-1], (left[2:] - left[:-2]) / (2 * length), atol=2e-4)
    assert left[0] < 0.9
    assert left[-1] < 0.9
    assert (left[len(node) // 3 : 2 * len(node) // 3] == 1).all()
    x, u, v = np.random.default_rng(width).standard_normal((3, 6 * len(node), width))
    u = x + 1e-9 * u
    velocity = v + k.velocity * k.acceleration * (x - u)
    absorb(k, stencils(model, k.step), x, u, v, (0.0,) * width)
    after = (v + k.velocity * k.acceleration * (x - u)).reshape(len(node), 3, 2, width)
    before = velocity.reshape(after.shape)
    np.testing.assert_allclose(after[:, :, 0], left[:, None, None] * before[:, :, 0], atol=1e-12)
    expected = left[:, None, None] * before[:, :, 1] + slope[:, None, None] * before[:, :, 0]
    np.testing.assert_allclose(after[:, :, 1], expected, atol=1e-12)
