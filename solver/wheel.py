"""A wheel at rest and the spring of its contact, in numbers that need no arrays."""

from solver.case import Vehicle
from solver.catalogue import TREADS

GRAVITY = 9.81  # m/s^2


def static_wheel_load(vehicle: Vehicle) -> float:
    """Weight on one wheel, N."""
    mass = vehicle.car_body_mass + 2 * vehicle.bogie_mass + 4 * vehicle.wheelset_mass
    return mass * GRAVITY / 8


def hertz_constant(vehicle: Vehicle) -> float:
    """G of ``F = (penetration / G)^(3/2)``, m/N^(2/3)."""
    tread = TREADS[vehicle.wheel_tread].values
    return float(tread.factor * vehicle.wheel_radius**tread.exponent)


def hertz_stiffness(constant: float, force: float) -> float:
    """Slope dF/d(penetration) at a force, N/m."""
    return 1.5 * force ** (1 / 3) / constant
