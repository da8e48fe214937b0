"""One case in all lanes: the lanes are segments of its track.

What happens to the track at one place does not reach far within one step. So segments that overlap by that reach are
solved side by side, each as if the track were endless beyond, and of each the inner part is kept.
"""

import math
from typing import NamedTuple

import numpy as np

from solver.arrays import Array, aligned_zeros
from solver.banded import backward, backward_node, by_pivots, forward, forward_node, load_node, nothing, store_node
from solver.compiled import compiled
from solver.periodic import PeriodicOperator
from solver.simd import MAX_LANES
from solver.track import NODE

SEGMENTS = MAX_LANES
TOGETHER = (0.0,) * SEGMENTS
ALONE = (0.0,)


class Segments(NamedTuple):
    """How the track is cut: once for the passes from node to node, and once, with overlaps, for the substitution."""

    nodes: tuple[int, ...]  # rows from a segment to the next, as lanes
    cells: tuple[int, ...]  # the same for the substitution
    lead: int  # cells before the first segment, whose factors are not yet periodic
    margin: int  # cells at either end of a segment that its neighbour keeps
    kept: int  # cells between them
    room: Array  # (rows of a segment, segments) to work in


def segments(operator: PeriodicOperator) -> Segments | None:
    """Segments of a track, or None if it is too short to be cut."""
    rows, cells = operator.blocks.shape[1], operator.block_of_cell.shape[1]
    lead = int(operator.block_of_cell[0, -1] - operator.block_of_cell[0, 0])
    margin = math.ceil(operator.windows.shape[2] / 2 / rows)
    kept = (cells - lead - 2 * margin) // SEGMENTS
    if kept < 1:
        return None
    length = cells - lead - (SEGMENTS - 1) * kept
    return Segments(
        nodes=(padded(rows * cells) // SEGMENTS,) * SEGMENTS,
        cells=(rows * kept,) * SEGMENTS,
        lead=lead,
        margin=margin,
        kept=kept,
        room=aligned_zeros((rows * length, SEGMENTS)),
    )


def padded(unknowns: int) -> int:
    """Unknowns rounded up so that every segment has as many nodes."""
    return -(-unknowns // (NODE * SEGMENTS)) * NODE * SEGMENTS


@compiled
def substitute_segments(blocks: Array, block_of_cell: Array, x: Array, c: Segments) -> None:
    """Solve in place for one lane; see :func:`solver.banded.substitute`.

    The cells before the first segment come first and last, as their factors are not yet periodic.
    """
    lead, f = block_of_cell[: c.lead], blocks[block_of_cell[c.lead]]
    first, edge = np.zeros((NODE, 1)), np.zeros((NODE, SEGMENTS))  # what passes between them and the first segment
    store_node(first, 0, forward(blocks, lead, x, ALONE), ALONE)
    edge[:, 0] = first[:, 0]
    _forward_segments(f, x, c, edge)
    _backward_segments(f, x, c, edge)
    first[:, 0] = edge[:, 0]
    backward(blocks, lead, x, load_node(first, 0, ALONE), ALONE)


@compiled
def _forward_segments(f: Array, x: Array, c: Segments, edge: Array) -> None:
    rows, start = f.shape[0], c.lead * f.shape[0]
    passed = load_node(edge, 0, TOGETHER)
    for cell in range(0, c.room.shape[0], rows):
        for i in range(0, rows, NODE):
            v, passed = forward_node(f, i, load_node(x, start + cell + i, c.cells), passed)
            store_node(c.room, cell + i, by_pivots(f, i, v), TOGETHER)


@compiled
def _backward_segments(f: Array, x: Array, c: Segments, edge: Array) -> None:
    rows, start = f.shape[0], c.lead * f.shape[0]
    kept = c.margin * rows, (c.margin + c.kept) * rows
    passed = nothing(TOGETHER)
    for cell in range(c.room.shape[0] - rows, -1, -rows):
        for i in range(rows - NODE, -1, -NODE):
            v, passed = backward_node(f, i, load_node(c.room, cell + i, TOGETHER), passed)
            if kept[0] <= cell < kept[1]:
                store_node(x, start + cell + i, v, c.cells)
            else:
                store_node(c.room, cell + i, v, TOGETHER)
    store_node(edge, 0, passed, TOGETHER)
    # The outer segments keep their outer margins as well.
    x[start : start + kept[0], 0] = c.room[: kept[0], 0]
    last = start + (SEGMENTS - 1) * c.cells[0]
    x[last + kept[1] : last + c.room.shape[0], 0] = c.room[kept[1] :, SEGMENTS - 1]
