"""Banded factorisation and substitution, compiled, many right-hand sides at once.

Unknowns are ordered node by node, six per node, and couple to those of their own and the two neighbouring nodes, at
most nine rows away. No pivoting is needed. Factors are kept in blocks of one pad cell, and a table says which block
serves which cell, because the factors of a periodic matrix are themselves periodic after a few cells.
"""

from typing import Any

import numpy as np

from solver.arrays import Array
from solver.compiled import compiled, inlined
from solver.simd import add, fma, load, scale, store, zero

HALF_BANDWIDTH = 9
# Columns of a factor block, of ``A = (I + L) D (I + U)``: nine entries of -L in the rows below a pivot, nearest first,
# the pivot's reciprocal, and nine entries of -U in the rows above it, nearest first. With the signs turned, a row
# waits for one multiply-add after the row before it and no more.
FACTOR_COLUMNS = 2 * HALF_BANDWIDTH + 1

Node = tuple[Any, Any, Any, Any, Any, Any]  # the six unknowns of a node, each with its lanes


@compiled
def factorise(band: Array) -> Array:
    """Factors of a banded matrix.

    Parameters
    ----------
    band : ndarray, shape (n, 19)
        ``band[i, 9 + j - i]`` is the entry (i, j); overwritten.

    Returns
    -------
    ndarray, shape (n, 19)
        In the layout of ``FACTOR_COLUMNS``.
    """
    n = band.shape[0]
    factors = np.zeros((n, FACTOR_COLUMNS))
    for i in range(n):
        reciprocal = 1.0 / band[i, HALF_BANDWIDTH]
        factors[i, HALF_BANDWIDTH] = reciprocal
        for k in range(1, min(HALF_BANDWIDTH, n - 1 - i) + 1):
            multiplier = band[i + k, HALF_BANDWIDTH - k] * reciprocal
            factors[i, k - 1] = -multiplier
            factors[i + k, HALF_BANDWIDTH + k] = -band[i, HALF_BANDWIDTH + k] * reciprocal
            for j in range(1, HALF_BANDWIDTH + 1):
                band[i + k, HALF_BANDWIDTH - k + j] -= multiplier * band[i, HALF_BANDWIDTH + j]
    return factors


@inlined
def forward_node(f: Array, i: int, x: Node, passed: Node) -> tuple[Node, Node]:
    """Eliminate a node.

    Parameters
    ----------
    f : ndarray, shape (rows, 19)
        Factors of a cell.
    i : int
        The node's first row in them.
    x : Node
        Right-hand sides.
    passed : Node
        What the node before passes on to this one.

    Returns
    -------
    solved, passed : Node
        Solution of the lower factor, and what this node passes on to the next. The sums end with the latest row, so
        that no row waits longer than it must; entries beyond the half bandwidth are left out.
    """
    a, b, c, d, e, g = f[i], f[i + 1], f[i + 2], f[i + 3], f[i + 4], f[i + 5]
    v0 = add(x[0], passed[0])
    v1 = fma(a[0], v0, add(x[1], passed[1]))
    v2 = fma(b[0], v1, fma(a[1], v0, add(x[2], passed[2])))
    v3 = fma(c[0], v2, fma(b[1], v1, fma(a[2], v0, add(x[3], passed[3]))))
    v4 = fma(d[0], v3, fma(c[1], v2, fma(b[2], v1, fma(a[3], v0, add(x[4], passed[4])))))
    v5 = fma(e[0], v4, fma(d[1], v3, fma(c[2], v2, fma(b[3], v1, fma(a[4], v0, add(x[5], passed[5]))))))
    n0 = fma(g[0], v5, fma(e[1], v4, fma(d[2], v3, fma(c[3], v2, fma(b[4], v1, scale(a[5], v0))))))
    n1 = fma(g[1], v5, fma(e[2], v4, fma(d[3], v3, fma(c[4], v2, fma(b[5], v1, scale(a[6], v0))))))
    n2 = fma(g[2], v5, fma(e[3], v4, fma(d[4], v3, fma(c[5], v2, fma(b[6], v1, scale(a[7], v0))))))
    n3 = fma(g[3], v5, fma(e[4], v4, fma(d[5], v3, fma(c[6], v2, fma(b[7], v1, scale(a[8], v0))))))
    n4 = fma(g[4], v5, fma(e[5], v4, fma(d[6], v3, fma(c[7], v2, scale(b[8], v1)))))
    n5 = fma(g[5], v5, fma(e[6], v4, fma(d[7], v3, scale(c[8], v2))))
    return (v0, v1, v2, v3, v4, v5), (n0, n1, n2, n3, n4, n5)


@inlined
def backward_node(f: Array, i: int, y: Node, passed: Node) -> tuple[Node, Node]:
    """The same for the upper factor, from the last node to the first, where ``y`` is divided by the pivots."""
    a, b, c, d, e, g = f[i], f[i + 1], f[i + 2], f[i + 3], f[i + 4], f[i + 5]
    v5 = add(y[5], passed[5])
    v4 = fma(g[10], v5, add(y[4], passed[4]))
    v3 = fma(e[10], v4, fma(g[11], v5, add(y[3], passed[3])))
    v2 = fma(d[10], v3, fma(e[11], v4, fma(g[12], v5, add(y[2], passed[2]))))
    v1 = fma(c[10], v2, fma(d[11], v3, fma(e[12], v4, fma(g[13], v5, add(y[1], passed[1])))))
    v0 = fma(b[10], v1, fma(c[11], v2, fma(d[12], v3, fma(e[13], v4, fma(g[14], v5, add(y[0], passed[0]))))))
    n5 = fma(a[10], v0, fma(b[11], v1, fma(c[12], v2, fma(d[13], v3, fma(e[14], v4, scale(g[15], v5))))))
    n4 = fma(a[11], v0, fma(b[12], v1, fma(c[13], v2, fma(d[14], v3, fma(e[15], v4, scale(g[16], v5))))))
    n3 = fma(a[12], v0, fma(b[13], v1, fma(c[14], v2, fma(d[15], v3, fma(e[16], v4, scale(g[17], v5))))))
    n2 = fma(a[13], v0, fma(b[14], v1, fma(c[15], v2, fma(d[16], v3, fma(e[17], v4, scale(g[18], v5))))))
    n1 = fma(a[14], v0, fma(b[15], v1, fma(c[16], v2, fma(d[17], v3, scale(e[18], v4)))))
    n0 = fma(a[15], v0, fma(b[16], v1, fma(c[17], v2, scale(d[18], v3))))
    return (v0, v1, v2, v3, v4, v5), (n0, n1, n2, n3, n4, n5)


@inlined
def load_node(x: Array, row: int, lanes: Any) -> Node:
    """The unknowns of the node whose first row is given."""
    return (
        load(x, row, lanes),
        load(x, row + 1, lanes),
        load(x, row + 2, lanes),
        load(x, row + 3, lanes),
        load(x, row + 4, lanes),
        load(x, row + 5, lanes),
    )


@inlined
def store_node(x: Array, row: int, node: Node, lanes: Any) -> None:
    """Write the unknowns of a node."""
    store(x, row, node[0], lanes)
    store(x, row + 1, node[1], lanes)
    store(x, row + 2, node[2], lanes)
    store(x, row + 3, node[3], lanes)
    store(x, row + 4, node[4], lanes)
    store(x, row + 5, node[5], lanes)


@inlined
def by_pivots(f: Array, i: int, v: Node) -> Node:
    """A node divided by its pivots."""
    return (
        scale(f[i, 9], v[0]),
        scale(f[i + 1, 9], v[1]),
        scale(f[i + 2, 9], v[2]),
        scale(f[i + 3, 9], v[3]),
        scale(f[i + 4, 9], v[4]),
        scale(f[i + 5, 9], v[5]),
    )


@inlined
def nothing(lanes: Any) -> Node:
    """A node of zeros."""
    none = zero(lanes)
    return (none, none, none, none, none, none)


@compiled
def substitute(blocks: Array, block_of_cell: Array, x: Array, lanes: tuple[float, ...]) -> None:
    """Solve in place for all lanes.

    Parameters
    ----------
    blocks : ndarray, shape (blocks, rows per cell, 19)
        Factors from :func:`factorise`, cut into cells.
    block_of_cell : ndarray of int, shape (cells,)
        Which block serves each cell.
    x : ndarray, shape (cells * rows per cell, lanes)
        Right-hand sides in, solutions out.
    lanes : tuple of float
        As many as there are lanes.
    """
    forward(blocks, block_of_cell, x, lanes)
    backward(blocks, block_of_cell, x, nothing(lanes), lanes)


@compiled
def forward(blocks: Array, block_of_cell: Array, x: Array, lanes: tuple[float, ...]) -> Node:
    """Solve with the lower factor and the pivots, in place; return what is passed on to the cell after the last."""
    rows, passed = blocks.shape[1], nothing(lanes)
    for cell in range(block_of_cell.shape[0]):
        f = blocks[block_of_cell[cell]]
        for i in range(0, rows, 6):
            v, passed = forward_node(f, i, load_node(x, cell * rows + i, lanes), passed)
            store_node(x, cell * rows + i, by_pivots(f, i, v), lanes)
    return passed


@compiled
def backward(blocks: Array, block_of_cell: Array, x: Array, passed: Node, lanes: tuple[float, ...]) -> None:
    """Solve with the upper factor, in place, from what the cell after the last passes on."""
    rows = blocks.shape[1]
    for cell in range(block_of_cell.shape[0] - 1, -1, -1):
        f = blocks[block_of_cell[cell]]
        for i in range(rows - 6, -1, -6):
            v, passed = backward_node(f, i, load_node(x, cell * rows + i, lanes), passed)
            store_node(x, cell * rows + i, v, lanes)
