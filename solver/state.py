"""What the time stepping of a block of lanes works on."""

from typing import NamedTuple

from solver.arrays import Array

SIZE = 10  # unknowns of a vehicle


class Operator(NamedTuple):
    """The track's side of a step; see :class:`solver.periodic.PeriodicOperator`."""

    blocks: Array
    block_of_cell: Array
    window_start: Array
    windows: Array
    compliance: Array
    wheel_row: Array  # (4,) first row of the two nodes around a wheel
    wheel_place: Array  # (4,) where a wheel stands in its element
    wheel_shape: Array  # (4, 4) rail shape functions under a wheel
    point_shape: Array  # (3, 4) shape functions and their first two derivatives under the first wheel
    curvature_per_force: float  # what the load inside its element adds to the rail's second derivative, 1/(m N)


class Vehicles(NamedTuple):
    """The vehicles of all lanes."""

    solution: Array  # (lanes, 10, 10) inverse of the step's matrix
    mass: Array  # (lanes, 10)
    damping: Array  # (lanes, 10, 10)
    weight: Array  # (lanes, 10) but for what the springs bear at rest
    hertz: Array  # (lanes,)


class State(NamedTuple):
    """Everything that changes from step to step."""

    x: Array  # (unknowns, lanes) displacements
    u: Array  # (unknowns, lanes) displacements as predicted for the end of the step
    v: Array  # (unknowns, lanes) velocities likewise
    vehicle_u: Array  # (lanes, 10), of car body and bogies from where they hang at rest
    vehicle_v: Array  # (lanes, 10)
    vehicle_a: Array  # (lanes, 10)
    point_a: Array  # (12, lanes) accelerations of the two nodes around the first wheel
    penetration: Array  # (lanes, 4)
    force: Array  # (4, lanes)
    failed: Array  # (lanes,)
