"""The compiled passes and the periodic factors against sparse matrices of the whole track."""

from dataclasses import replace

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from solver.banded import factorise, substitute
from solver.case import Numerics
from solver.integrator import integrator
from solver.kernels import advance, stencils
from solver.periodic import periodic_operator
from solver.segments import padded, segments, substitute_segments
from solver.track import RAIL, TrackModel
from solver.vehicle import wheel_positions

WIDTHS = [1, 2, 4, 8]


def sparse_from(band: np.ndarray) -> sparse.csc_array:
    n = len(band)
    diagonals = [band[max(0, -k) : n - max(0, k), 9 + k] for k in range(-9, 10)]
    return sparse.diags_array(diagonals, offsets=range(-9, 10)).tocsc()


def random_band(rng: np.random.Generator, n: int) -> np.ndarray:
    """Unknowns couple to those of the same node and of the two neighbouring ones, and not further than nine rows."""
    i, j = np.arange(n)[:, None], np.arange(n)[:, None] + np.arange(-9, 10)
    band = np.where(abs(i // 6 - j // 6) <= 1, rng.standard_normal((n, 19)), 0.0)
    band[:, 9] += 12
    return band


def matrix(model: TrackModel, phase: int, inertia: float, damping: float) -> sparse.csc_array:
    return sparse_from(model.band(model.cells, phase, inertia, damping))


@pytest.mark.parametrize("width", WIDTHS)
def test_banded_solution(width):
    rng = np.random.default_rng(width)
    rows, cells = 18, 5
    band = random_band(rng, rows * cells)
    full = sparse_from(band)
    factors = factorise(band.copy()).reshape(cells, rows, 19)
    right = rng.standard_normal((rows * cells, width))
    x = right.copy()
    substitute(factors, np.arange(cells), x, (0.0,) * width)
    np.testing.assert_allclose(full @ x, right, atol=1e-12)


def test_a_lane_does_not_know_its_neighbours():
    rng = np.random.default_rng(0)
    band = random_band(rng, 90)
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


def absorbed(model, k, velocity):
    """What the ends leave of a velocity (unknowns, lanes): the field times what a step leaves at each place."""
    left, slope = (part[:, None, None] for part in model.absorption(k.step).T)
    value, turn = velocity.reshape(len(left), 3, 2, -1).transpose(2, 0, 1, 3)
    return np.stack([left * value, left * turn + slope * value], axis=2).reshape(velocity.shape)


@pytest.mark.parametrize("width", [*WIDTHS, "segments"])
def test_advance_is_the_integrator_on_the_whole_matrices(make_case, width):
    case = make_case(numerics=Numerics(track_length=91.0))  # 140 cells: nodes are no multiple of eight
    model, k = TrackModel(case), integrator(case.time_step, 0.8)
    phase, big = 5, 1e13  # large factors keep M and C from drowning in K
    stiffness = matrix(model, phase, 0, 0)
    mass = (matrix(model, phase, big, 0) - stiffness) / big
    damping = (matrix(model, phase, 0, big) - stiffness) / big
    unknowns, lanes = stiffness.shape[0], (0.0,) * (1 if width == "segments" else width)
    along = (padded(unknowns) // 8,) * 8 if width == "segments" else lanes
    rng = np.random.default_rng(0)
    state = np.zeros((3, padded(unknowns) if width == "segments" else unknowns, len(lanes)))
    x, u, v = state
    state[:, 6:unknowns] = rng.standard_normal((3, unknowns - 6, len(lanes)))
    u[:] = x + 1e-9 * u
    acceleration = k.acceleration * (x - u)[:unknowns]
    velocity = absorbed(model, k, v[:unknowns] + k.velocity * acceleration)
    pu, pv = x[:unknowns] + k.step * velocity + k.drift * acceleration, velocity + k.kick * acceleration
    expected = mass @ (k.inertia * pu - k.alpha * acceleration) + damping @ (k.damping * pu - pv)
    expected[:6] = 0
    advance(k, stencils(model, k), phase, x, u, v, lanes, along)
    np.testing.assert_allclose(u[:unknowns], pu, atol=1e-13)
    np.testing.assert_allclose(v[:unknowns], pv, atol=1e-12)
    np.testing.assert_allclose(x[:unknowns], expected, atol=1e-12 * np.abs(expected).max())
    assert not state[:, unknowns:].any()


def test_what_the_ends_leave_of_a_velocity_has_the_right_slope(make_case):
    model = TrackModel(make_case())
    left, slope = model.absorption(1e-4).T
    np.testing.assert_allclose(slope[1:-1], (left[2:] - left[:-2]) / (2 * model.element.length), atol=2e-4)
    assert left[0] < 0.9
    assert left[-1] < 0.9
    assert (left[len(left) // 3 : 2 * len(left) // 3] == 1).all()


@pytest.mark.parametrize("length", [100.0, 140.0])
@pytest.mark.parametrize("phase", [0, 33])
def test_segments_of_a_track_solve_as_the_whole(make_case, length, phase):
    model = TrackModel(make_case(numerics=Numerics(track_length=length)))
    operator = periodic_operator(model, integrator(1e-4, 0.8), wheel_positions(model.case.vehicle))
    cut = segments(operator)
    right = np.random.default_rng(phase).standard_normal((6 * model.cells * 12, 1))
    right[:6] = 0
    whole, parts = right.copy(), right.copy()
    substitute(operator.blocks, operator.block_of_cell[phase], whole, (0.0,))
    substitute_segments(operator.blocks, operator.block_of_cell[phase], parts, cut)
    for kind in (0, 1):  # displacements and slopes
        np.testing.assert_allclose(parts[kind::2], whole[kind::2], atol=1e-12 * np.abs(whole[kind::2]).max())


def test_a_track_too_short_for_segments_stays_whole(make_case):
    operator = periodic_operator(TrackModel(make_case()), integrator(1e-4, 0.8), np.array([0.0]))
    short = replace(operator, block_of_cell=operator.block_of_cell[:, :30])
    assert segments(short) is None
