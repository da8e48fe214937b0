"""The vehicle: ten degrees of freedom of half a four-axle car.

Order: car body bounce and pitch, leading bogie bounce and pitch, trailing bogie bounce and pitch, wheelsets
one to four from the front. Downwards and nose-down are positive; displacements count from the unloaded state.
"""

from dataclasses import dataclass

import numpy as np

from solver.arrays import Array
from solver.case import Vehicle
from solver.wheel import GRAVITY

CAR_BODY, BOGIES, WHEELSETS = 0, (2, 4), slice(6, 10)
SIZE = 10


@dataclass(frozen=True)
class VehicleMatrices:
    """Mass, damping and stiffness (10, 10) and weight (10,) of half the car, SI."""

    mass: Array
    damping: Array
    stiffness: Array
    weight: Array


def wheel_positions(vehicle: Vehicle) -> Array:
    """Positions of the wheelsets ahead of the car's centre, m, front first."""
    a, b = vehicle.half_bogie_distance, vehicle.half_wheelbase
    return np.array([a + b, a - b, -a + b, -a - b])


def _springs(vehicle: Vehicle, primary: float, secondary: float) -> Array:
    """Matrix of both suspension stages, for their stiffnesses or their dampings."""
    matrix = np.zeros((SIZE, SIZE))
    ends = (1, -1)
    for bogie, side in zip(BOGIES, ends, strict=True):
        stretch = np.zeros(SIZE)
        stretch[[CAR_BODY, CAR_BODY + 1, bogie]] = 1, side * vehicle.half_bogie_distance, -1
        matrix += secondary * np.outer(stretch, stretch)
        for wheelset, end in zip((bogie + 4, bogie + 5), ends, strict=True):
            stretch = np.zeros(SIZE)
            stretch[[bogie, bogie + 1, wheelset]] = 1, end * vehicle.half_wheelbase, -1
            matrix += primary * np.outer(stretch, stretch)
    return matrix


def vehicle_matrices(vehicle: Vehicle) -> VehicleMatrices:
    """Matrices of half the car: every mass, inertia, stiffness and damping is halved."""
    mass = np.array(
        [vehicle.car_body_mass, vehicle.car_body_pitch_inertia]
        + 2 * [vehicle.bogie_mass, vehicle.bogie_pitch_inertia]
        + 4 * [vehicle.wheelset_mass]
    )
    bounce = np.array([1, 0, 1, 0, 1, 0, 1, 1, 1, 1])
    return VehicleMatrices(
        mass=np.diag(mass) / 2,
        damping=_springs(vehicle, vehicle.primary_damping, vehicle.secondary_damping) / 2,
        stiffness=_springs(vehicle, vehicle.primary_stiffness, vehicle.secondary_stiffness) / 2,
        weight=mass * bounce * GRAVITY / 2,
    )
