"""Mesh and matrices of the track-fixed reference: three beams of cubic elements that stay where they are, and a car."""

import math
from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.linalg import lapack

from solver.arrays import Array
from solver.case import Case, Track, Vehicle

GRAVITY = 9.81
BAND = 9  # subdiagonals of the track's matrices
LINK = np.array([[1.0, -1.0], [-1.0, 1.0]])
# Integrals over an element of unit length of products of shape functions and of their second derivatives.
OVERLAP = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) / 420
BENDING = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])


@dataclass(frozen=True, kw_only=True)
class Mesh:
    """Nodes of the window and where their unknowns stand: displacement there, slope next to it.

    A slab's unknowns run from pad to pad, node by node, as rail, slab, base; those of a joint's node as slab behind,
    rail, base, slab ahead, which keeps the band as narrow as elsewhere.
    """

    x: Array  # from the window's start, m
    rail: Array
    slab_behind: Array  # the same as slab_ahead but at joints
    slab_ahead: Array
    base: Array
    pads: Array  # nodes
    joints: Array  # nodes; none if the slab is continuous
    slab_nodes: int
    slab_unknowns: int
    slab_length: float

    @property
    def size(self) -> int:
        """Unknowns."""
        return int(self.base[-1]) + 2

    def elements(self) -> tuple[Array, Array, Array]:
        """Unknowns of every element of rail, slab and base, each (elements, 4)."""
        pairs = ((self.rail, self.rail), (self.slab_ahead, self.slab_behind), (self.base, self.base))
        rail, slab, base = (np.stack([a[:-1], a[:-1] + 1, b[1:], b[1:] + 1], axis=1) for a, b in pairs)
        return rail, slab, base


def build_mesh(case: Case) -> Mesh:
    """The mesh of a case: from pad to pad in even elements, but that a joint's node moves to the joint."""
    joint, spacing, per_pad = case.track.joint, case.track.pad_spacing, case.numerics.elements_per_pad
    discontinuous = case.slab == "discontinuous"
    nodes, length = joint.pads_per_slab * per_pad, joint.pads_per_slab * spacing
    # One slab more than asked for, as the vehicle strays from the middle by half of one.
    slabs = max(4, math.ceil(case.numerics.track_length / length - 1e-9) + 1)
    at = min(max(1, round(per_pad * joint.position)), per_pad - 1)  # node of the joint
    node = np.arange(nodes)
    x = np.interp(node, [0, at, per_pad, nodes], spacing * np.array([0, joint.position, 1, joint.pads_per_slab]))

    rail, slab_behind, slab_ahead, base = (6 * node + 2 * beam for beam in (0, 1, 1, 2))
    unknowns = 6 * nodes
    if discontinuous:
        unknowns += 2
        for field in (rail, slab_behind, slab_ahead, base):
            field[at + 1 :] += 2
        rail[at], slab_behind[at], slab_ahead[at] = 6 * at + 2, 6 * at, 6 * at + 6

    def repeat(values: Array, period: float) -> Array:
        return np.append(np.add.outer(np.arange(slabs) * period, values).ravel(), slabs * period + values[0])

    return Mesh(
        x=repeat(x, length),
        rail=repeat(rail, unknowns),
        slab_behind=repeat(slab_behind, unknowns),
        slab_ahead=repeat(slab_ahead, unknowns),
        base=repeat(base, unknowns),
        pads=np.arange(0, slabs * nodes + 1, per_pad),
        joints=at + nodes * np.arange(slabs if discontinuous else 0),
        slab_nodes=nodes,
        slab_unknowns=unknowns,
        slab_length=length,
    )


def hermite(xi: Array, length: Array) -> Array:
    """Cubic shape functions (4, n) at ``xi``, 0 to 1, along elements of some lengths."""
    return np.array(
        [1 - 3 * xi**2 + 2 * xi**3, length * xi * (1 - xi) ** 2, xi**2 * (3 - 2 * xi), length * xi**2 * (xi - 1)]
    )


def _add(band: Array, unknowns: Array, matrices: Array) -> None:
    """Add symmetric matrices (…, k, k) at their unknowns (elements, k) to a lower band (BAND + 1, n)."""
    i, j = np.broadcast_arrays(unknowns[:, :, None], unknowns[:, None, :])
    lower = i >= j
    np.add.at(band, ((i - j)[lower], j[lower]), np.broadcast_to(matrices, i.shape)[lower])


def track_matrices(track: Track, mesh: Mesh, added_damping: Array) -> tuple[Array, Array, Array]:
    """Mass, damping and stiffness as lower bands; ``added_damping`` is the roadbed's, per element, N s/m^2."""
    t, length = track, np.diff(mesh.x)
    scale = np.stack([np.ones_like(length), length, np.ones_like(length), length], axis=1)
    scale = scale[:, :, None] * scale[:, None, :]
    overlap = OVERLAP * scale * length[:, None, None]
    bending = BENDING * scale / length[:, None, None] ** 3

    mass, damping, stiffness = (np.zeros((BAND + 1, mesh.size), order="F") for _ in range(3))
    rail, slab, base = mesh.elements()
    for unknowns, per_length, rigidity in (
        (rail, t.rail_mass, t.rail_elastic_modulus * t.rail_second_moment),
        (slab, t.slab_mass, t.slab_elastic_modulus * t.slab_second_moment),
        (base, t.base_mass, t.base_elastic_modulus * t.base_second_moment),
    ):
        _add(mass, unknowns, per_length * overlap)
        _add(stiffness, unknowns, rigidity * bending)
    pads = np.stack([mesh.rail[mesh.pads], mesh.slab_ahead[mesh.pads]], axis=1)
    joints = np.stack([mesh.slab_behind[mesh.joints], mesh.slab_ahead[mesh.joints]], axis=1)
    roadbed = t.roadbed_damping + added_damping[:, None, None]
    for band, pad, joint, mortar, bed in (
        (stiffness, t.pad_stiffness, t.joint.shear_stiffness, t.mortar_stiffness, t.roadbed_stiffness),
        (damping, t.pad_damping, t.joint.shear_damping, t.mortar_damping, roadbed),
    ):
        _add(band, pads, pad * LINK)
        _add(band, joints, joint * LINK)
        _add(band, np.hstack([slab, base]), mortar * np.kron(LINK, overlap))
        _add(band, base, bed * overlap)
    return mass, damping, stiffness


def factorise(band: Array) -> Array:
    """Cholesky factor of a symmetric positive definite lower band."""
    factor, failed = lapack.dpbtrf(band, lower=1)
    if failed:
        raise ArithmeticError("the matrix of the track is not positive definite")
    return factor


def whole(band: Array) -> sparse.csr_array:
    """The sparse matrix of a symmetric lower band."""
    lower = sparse.diags_array([row[: row.size - k] for k, row in enumerate(band)], offsets=-np.arange(len(band)))
    whole = (lower + sparse.triu(lower.T, 1)).tocsr()
    whole.eliminate_zeros()
    return whole


def substitute(factor: Array, load: Array) -> Array:
    """Solve with a factor for one or several loads (n, …)."""
    solution, _ = lapack.dpbtrs(factor, load, lower=1)
    return solution


def wheel_positions(vehicle: Vehicle) -> Array:
    """Positions of the wheelsets ahead of the car's centre, m, front first."""
    a, b = vehicle.half_bogie_distance, vehicle.half_wheelbase
    return np.array([a + b, a - b, b - a, -a - b])


def weights(vehicle: Vehicle) -> Array:
    """Weight (10,) of half a car, N."""
    v = vehicle
    masses = [v.car_body_mass, 0, v.bogie_mass, 0, v.bogie_mass, 0] + 4 * [v.wheelset_mass]
    return np.array(masses) * GRAVITY / 2


def vehicle_matrices(vehicle: Vehicle) -> tuple[Array, Array, Array]:
    """Mass, damping and stiffness (10, 10) of half a car: body, leading and trailing bogie, each bounce and pitch
    (nose down), then the wheelsets.
    """
    v = vehicle
    bodies = [v.car_body_mass, v.car_body_pitch_inertia] + 2 * [v.bogie_mass, v.bogie_pitch_inertia]
    mass = np.diag(bodies + 4 * [v.wheelset_mass]) / 2
    secondary, primary = np.zeros((2, 10)), np.zeros((4, 10))
    for bogie, x in enumerate((v.half_bogie_distance, -v.half_bogie_distance)):
        secondary[bogie, [0, 1, 2 + 2 * bogie]] = 1, x, -1
        for end, y in enumerate((v.half_wheelbase, -v.half_wheelbase)):
            wheelset = 2 * bogie + end
            primary[wheelset, [2 + 2 * bogie, 3 + 2 * bogie, 6 + wheelset]] = 1, y, -1
    upper, lower = secondary.T @ secondary / 2, primary.T @ primary / 2
    damping = v.secondary_damping * upper + v.primary_damping * lower
    return mass, damping, v.secondary_stiffness * upper + v.primary_stiffness * lower


def hertz_constant(vehicle: Vehicle) -> float:
    """G of ``F = (penetration / G)^1.5``, m/N^(2/3)."""
    if vehicle.wheel_tread == "worn":
        return 3.86e-8 * vehicle.wheel_radius**-0.115
    return 4.57e-8 * vehicle.wheel_radius**-0.149
