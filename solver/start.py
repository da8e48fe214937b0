"""The state a run starts from: vehicle and track at rest under their weight."""

import numpy as np

from solver.arrays import Array
from solver.case import Vehicle
from solver.vehicle import SIZE, WHEELSETS, vehicle_matrices
from solver.wheel import hertz_constant, static_wheel_load


def static_equilibrium(vehicle: Vehicle, compliance: Array) -> tuple[Array, Array, Array]:
    """Vehicle at rest on a rail that yields.

    Bogies and car body hang on two springs each and are free to pitch, so every wheel carries the same however the
    rail yields.

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
    force = np.full(4, static_wheel_load(vehicle))
    penetration = hertz_constant(vehicle) * force ** (2 / 3)
    wheels = penetration + compliance @ force
    matrices = vehicle_matrices(vehicle)
    body, wheelsets = slice(WHEELSETS.start), slice(WHEELSETS.start, SIZE)
    load = matrices.weight[body] - matrices.stiffness[body, wheelsets] @ wheels
    return np.r_[np.linalg.solve(matrices.stiffness[body, body], load), wheels], penetration, force
