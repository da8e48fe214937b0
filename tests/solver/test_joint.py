from dataclasses import replace

import numpy as np
import pytest
from scipy import sparse
from scipy.sparse.linalg import spsolve

from solver.banded import substitute
from solver.block import Block
from solver.case import Harmonic, Joint, Numerics
from solver.catalogue import TRACKS
from solver.errors import UnresolvedError
from solver.joint import JointModel, enrichment
from solver.joint_kernels import first_joint, joint_row, open_joints, solve_joints
from solver.peaks import peaks
from solver.simulate import solve
from solver.track import TrackModel

NUMERICS = Numerics(track_length=140.0, elements_per_pad=6, settle=0.5, window=0.3)


@pytest.fixture
def discontinuous(make_case):
    def make(joint: Joint | None = None, **parts):
        track = replace(TRACKS["crts2"].values, joint=joint or Joint())
        return make_case(**{"slab": "discontinuous", "track": track, "numerics": NUMERICS} | parts)

    return make


def test_shape_functions_jump_and_turn_at_the_joint_and_fade_smoothly():
    d = 0.65
    start, end = (np.array([enrichment(np.array(s), d, k) for k in range(4)]) for s in (0.0, d * (1 - 1e-9)))
    np.testing.assert_allclose(start, [[1, 0], [0, 1], [0, 0], [0, 0]], atol=1e-12)
    np.testing.assert_allclose(end, 0, atol=1e-4)
    np.testing.assert_array_equal(enrichment(np.array([-1e-9, d, 2.0]), d), 0)
    s, h = np.linspace(0.01, 0.6, 60), 1e-5
    for k in (1, 2, 3):
        slope = (enrichment(s + h, d, k - 1) - enrichment(s - h, d, k - 1)) / (2 * h)
        np.testing.assert_allclose(enrichment(s, d, k), slope, atol=1e-4 * np.abs(slope).max())


@pytest.mark.parametrize(("pads_per_slab", "position"), [(10, 0.5), (4, 0.3)])
def test_elimination_is_the_solution_of_the_whole_system(discontinuous, pads_per_slab, position):
    """One step with all joints, in one lane, against a sparse matrix that holds track and joints together."""
    block = Block([discontinuous(Joint(pads_per_slab=pads_per_slab, position=position))])
    c, state, k, step = block.joints, block.joint_state, block.scheme, 37
    model = TrackModel(block.case)
    band = model.band(model.cells, step % block.case.phases, k.inertia, k.damping)
    diagonals = [band[max(0, -i) : len(band) - max(0, i), 9 + i] for i in range(-9, 10)]
    track = sparse.diags_array(diagonals, offsets=range(-9, 10)).tolil()
    blocks = JointModel(model).blocks(step % block.case.phases)
    factors = np.array([k.inertia, k.damping, 1.0])[:, None, None]
    column, row, own = ((factors * part).sum(axis=0) for part in (blocks.column, blocks.row, blocks.own))
    columns, rows = (sparse.lil_array((track.shape[0], 2 * c.joints)) for _ in range(2))
    first = first_joint(c, step)
    for joint in range(first, first + c.joints):
        at, slot = joint_row(c, step, joint), 2 * (joint % c.joints)
        columns[at : at + len(column), slot : slot + 2] = column
        rows[at : at + len(row), slot : slot + 2] = row
    own_of_all = sparse.block_diag([own] * c.joints).tolil()
    rng = np.random.default_rng(5)
    right = rng.standard_normal((track.shape[0], 1))
    right[:6] = 0
    state.g[:] = rng.standard_normal(state.g.shape) * np.abs(own).max() * 1e-8
    # The springs that hold the joints near the ends, read back from the inverses.
    x = right.copy()
    substitute(block.operator.blocks, block.operator.block_of_cell[step % block.case.phases], x, (0.0,))
    solve_joints(c, state, step, x, (0.0,))
    held = np.linalg.inv(state.inverse) - c.remainder[step % block.case.phases]
    for slot in range(c.joints):
        own_of_all[2 * slot, 2 * slot] += held[slot, 0, 0]
        own_of_all[2 * slot + 1, 2 * slot + 1] += held[slot, 1, 1]
    open_joints(c, state, step, x, np.zeros((4, 1)), (0.0,))
    whole = sparse.block_array([[track, columns], [rows.T, own_of_all]]).tocsc()
    exact = spsolve(whole, np.r_[right[:, 0], state.g[:, 0]])
    n = track.shape[0]
    np.testing.assert_allclose(x[:, 0], exact[:n], atol=1e-9 * np.abs(exact[:n]).max())
    np.testing.assert_allclose(state.x[:, 0], exact[n:], atol=1e-9 * np.abs(exact[n:]).max())


def peak(response, quantity):
    return next(p for p in peaks(response) if p.quantity == quantity).peak


def test_limits_of_the_shear_spring(discontinuous, make_case):
    """No spring: two free ends, no shear. A rigid spring: a row of hinges, which is not the continuous slab."""
    free, soft, hinge, rigid = solve(
        [
            discontinuous(Joint(shear_stiffness=k, shear_damping=c))
            for k, c in ((0.0, 0.0), (1e4, 0.0), (1e11, 0.0), (1e12, 0.0))
        ]
    )
    continuous = solve([make_case(numerics=NUMERICS)])[0]
    assert peak(free, "joint_shear") == 0
    assert peak(free, "joint_opening") == pytest.approx(peak(soft, "joint_opening"), rel=1e-2)
    assert peak(hinge, "joint_opening") < 2e-3 * peak(free, "joint_opening")
    for quantity in ("rail_displacement", "slab_acceleration", "wheel_rail_force", "joint_slope_jump"):
        assert peak(hinge, quantity) == pytest.approx(peak(rigid, quantity), rel=1e-2), quantity
    assert peak(hinge, "slab_acceleration") > 1.05 * peak(continuous, "slab_acceleration")
    assert peak(hinge, "joint_slope_jump") > 1e-4


def test_lanes_with_joints_are_solved_as_if_alone(discontinuous):
    cases = [discontinuous(), discontinuous(irregularity=Harmonic(wavelength=1.5, amplitude=2e-4))]
    for case, response in zip(cases, solve(cases), strict=True):
        np.testing.assert_array_equal(solve([case])[0].values, response.values)


@pytest.mark.parametrize("elements_per_pad", [6, 48])
def test_joints_around_the_vehicle_are_open_on_any_mesh(discontinuous, elements_per_pad):
    block = Block([discontinuous(numerics=replace(NUMERICS, elements_per_pad=elements_per_pad))])
    rear = block.model.wheel_cell - 2 * block.wheels[0] / 0.65
    assert block.joints.first_cell < rear - 20
    assert block.joints.first_cell + 10 * block.joints.joints > block.model.wheel_cell + 20


def test_a_step_over_which_joints_reach_too_far_is_refused_by_name(discontinuous):
    numerics = Numerics(track_length=95.0, time_step=1e-3, elements_per_pad=6)
    stiff = replace(TRACKS["crts2"].values, slab_elastic_modulus=1e12)
    (result,) = solve([discontinuous(speed=40 / 3.6, numerics=numerics, track=stiff)])
    assert isinstance(result, UnresolvedError)
    assert result.code == "unresolved"
    assert "time_step_s" in str(result)
