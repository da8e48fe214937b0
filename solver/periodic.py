"""The step's operator at every phase: periodic factors and short windows instead of whole matrices.

The matrix repeats from pad to pad, and after a few cells so do its factors, to rounding. A phase therefore keeps
the factors of the first cells, the last of which serves the whole length. The inverse is local as well: what a
wheel's force does within one step is kept as a short window.
"""

from dataclasses import dataclass

import numpy as np

from solver.arrays import Array
from solver.banded import FACTOR_COLUMNS, factorise, substitute
from solver.integrator import Integrator
from solver.track import NODE, RAIL, TrackModel

FACTOR_TOLERANCE = 1e-10  # relative change of the factors from cell to cell that counts as none, above rounding
WINDOW_TOLERANCE = 1e-13  # part of a window's largest entry below which it is cut


@dataclass(frozen=True)
class PeriodicOperator:
    """All that a step needs of the track's matrices.

    Attributes
    ----------
    blocks : ndarray, shape (blocks, rows per cell, 19)
        Factors cut into cells.
    block_of_cell : ndarray of int, shape (phases, cells)
        Which block serves a cell at a phase.
    window_start : ndarray of int, shape (wheels,)
        First row of each wheel's window.
    windows : ndarray, shape (phases, wheels, rows)
        Displacement in response to a unit force at each wheel, within one step.
    compliance : ndarray, shape (phases, wheels, wheels)
        Rail displacement under wheel i for a unit force at wheel j, within one step.
    """

    blocks: Array
    block_of_cell: Array
    window_start: Array
    windows: Array
    compliance: Array


def periodic_operator(model: TrackModel, scheme: Integrator, wheels: Array) -> PeriodicOperator:
    """Factorise ``inertia M + damping C + K`` at every phase and answer a unit force at every wheel.

    Parameters
    ----------
    model : TrackModel
    scheme : Integrator
    wheels : ndarray, shape (wheels,)
        Positions of the wheels, m.
    """
    transition = 8
    while (factors := _blocks(model, scheme, transition)) is None:
        transition += 4
    phases, kept = factors.shape[:2]
    table = np.arange(phases)[:, None] * kept + np.minimum(np.arange(model.cells), kept - 1)
    blocks = factors.reshape(phases * kept, *factors.shape[2:])
    return PeriodicOperator(blocks, table, *_windows(model, wheels, blocks, table))


def _blocks(model: TrackModel, scheme: Integrator, transition: int) -> Array | None:
    """Factors (phases, cells, rows, 19) of the first cells, or None if so many do not make them periodic."""
    rows, phases = NODE * model.case.numerics.elements_per_pad, model.case.phases
    kept = min(transition, model.cells)
    blocks = np.empty((phases, kept, rows, FACTOR_COLUMNS))
    for phase in range(phases):
        band = model.band(min(kept + 1, model.cells), phase, scheme.inertia, scheme.damping)
        blocks[phase] = factorise(band)[: kept * rows].reshape(kept, rows, FACTOR_COLUMNS)
        if kept < model.cells and not _alike(blocks[phase, -1], blocks[phase, -2]):
            return None
    return blocks


def _alike(block: Array, other: Array) -> bool:
    scale = np.abs(block).max(axis=0)
    return bool(np.all(np.abs(block - other) <= FACTOR_TOLERANCE * scale))


def _windows(model: TrackModel, wheels: Array, blocks: Array, table: Array) -> tuple[Array, Array, Array]:
    """Windows of the inverse under each wheel, and the compliances between the wheels."""
    loads = model.unit_loads(wheels)
    points = [model.point(position, RAIL) for position in wheels]
    lanes = (0.0,) * len(wheels)
    half = 0
    windows: Array = np.empty((0, 0, 0))
    compliance = np.empty((len(table), len(wheels), len(wheels)))
    start = np.zeros(len(wheels), np.int64)
    for phase, block_of_cell in enumerate(table):
        response: Array = loads.copy()
        substitute(blocks, block_of_cell, response, lanes)
        if phase == 0:
            half = max(max(reach(response[:, j], row)) for j, (row, _) in enumerate(points))
            start = np.array([max(0, row - half) for row, _ in points])
            start = np.minimum(start, len(loads) - min(2 * half, len(loads)))
            windows = np.empty((len(table), len(wheels), min(2 * half, len(loads))))
        for j in range(len(wheels)):
            windows[phase, j] = response[start[j] : start[j] + windows.shape[2], j]
            for i, (row, weights) in enumerate(points):
                compliance[phase, i, j] = weights @ response[row : row + 2 * NODE, j]
    return start, windows, compliance


def reach(response: Array, row: int, tolerance: float = WINDOW_TOLERANCE) -> tuple[int, int]:
    """Rows before and from a row on beyond which a response is below a part of its largest entries, in whole nodes."""
    by_kind = np.abs(response.reshape(-1, 2))  # displacements and slopes
    significant = np.flatnonzero((by_kind > tolerance * by_kind.max(axis=0)).any(axis=1)) * 2
    before, after = row - significant[0] + 2 * NODE, significant[-1] - row + 2 * NODE
    return int(-(-before // NODE) * NODE), int(-(-after // NODE) * NODE)
