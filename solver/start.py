"""The state a run starts from: vehicle and track at rest under their weight."""

import numpy as np

from solver.banded import Array
from solver.case import Vehicle
from solver.contact import hertz_constant
from solver.vehicle import SIZE, WHEELSETS, vehicle_matrices

_ITERATIONS = 50


def static_equilibrium(vehicle: Vehicle, compliance: Array) -> tuple[Array, Array, Array]:
    """Vehicle at rest on a rail that yields.

    Parameters
    ----------
    vehicle : Vehicle
    compliance : ndarray, shape (4, 4)
        Rail displacement under wheel i for a steady unit force at wheel j, m/N.

    Returns
    -------
    displacement : ndarray, shape (10,)
        Of the vehicle's unknowns, m and rad.
    penetration : ndarray, shape (4,)
        Of the contacts, m.
    force : ndarray, shape (4,)
        Of the contacts, N.
    """
    matrices = vehicle_matrices(vehicle)
    bodies, wheels = np.arange(WHEELSETS.start), np.arange(WHEELSETS.start, SIZE)
    k = matrices.stiffness
    lifted = np.linalg.solve(k[np.ix_(bodies, bodies)], np.c_[k[np.ix_(bodies, wheels)], matrices.weight[bodies]])
    springs = k[np.ix_(wheels, wheels)] - k[np.ix_(wheels, bodies)] @ lifted[:, :4]
    weight = matrices.weight[wheels] - k[np.ix_(wheels, bodies)] @ lifted[:, 4]
    constant = hertz_constant(vehicle)
    penetration = constant * np.full(4, matrices.weight.sum() / 4) ** (2 / 3)
    for _ in range(_ITERATIONS):
        force = (penetration / constant) ** 1.5
        slope = np.diag(1.5 * force / penetration)
        residual = springs @ (penetration + compliance @ force) + force - weight
        step = np.linalg.solve(springs @ (np.eye(4) + compliance @ slope) + slope, residual)
        penetration = penetration - np.minimum(step, penetration / 2)  # stays in contact on the way
        if np.abs(step).max() < 1e-16:
            break
    force = (penetration / constant) ** 1.5
    wheel_displacement = penetration + compliance @ force
    body_displacement = lifted[:, 4] - lifted[:, :4] @ wheel_displacement
    return np.r_[body_displacement, wheel_displacement], penetration, force
