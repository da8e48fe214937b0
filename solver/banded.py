"""Banded factorisation and substitution, compiled, many right-hand sides at once.

Unknowns are ordered node by node, six per node, so a row couples to at most nine neighbours on either side.
No pivoting is needed. Factors are kept in blocks of one pad cell, and a table says which block serves which
cell, because the factors of a periodic matrix are themselves periodic after a few cells.
"""

import numpy as np

from solver.arrays import Array
from solver.compiled import compiled
from solver.simd import fma, load, scale, store, subtract, zero

HALF_BANDWIDTH = 9
# Columns of a factor block: nine multipliers of the rows below a pivot, the pivot's reciprocal, and nine
# entries of the upper factor above the pivot, nearest first.
FACTOR_COLUMNS = 2 * HALF_BANDWIDTH + 1


@compiled
def factorise(band: Array) -> Array:
    """LU factors of a banded matrix.

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
            factors[i, k - 1] = multiplier
            factors[i + k, HALF_BANDWIDTH + k] = band[i, HALF_BANDWIDTH + k]
            for j in range(1, HALF_BANDWIDTH + 1):
                band[i + k, HALF_BANDWIDTH - k + j] -= multiplier * band[i, HALF_BANDWIDTH + j]
    return factors


@compiled
def substitute(blocks: Array, block_of_cell: Array, x: Array, lanes: tuple[float, ...]) -> None:
    """Solve in place for all lanes.

    Nine running sums hold what the rows already solved contribute to the next nine rows, so every row
    is read and written once per sweep.

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
    rows = blocks.shape[1]
    row = 0
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = s8 = zero(lanes)
    for cell in range(block_of_cell.shape[0]):
        block = blocks[block_of_cell[cell]]
        for i in range(rows):
            f = block[i]
            v = subtract(load(x, row, lanes), s0)
            store(x, row, v)
            s0 = fma(f[0], v, s1)
            s1 = fma(f[1], v, s2)
            s2 = fma(f[2], v, s3)
            s3 = fma(f[3], v, s4)
            s4 = fma(f[4], v, s5)
            s5 = fma(f[5], v, s6)
            s6 = fma(f[6], v, s7)
            s7 = fma(f[7], v, s8)
            s8 = scale(f[8], v)
            row += 1
    s0 = s1 = s2 = s3 = s4 = s5 = s6 = s7 = s8 = zero(lanes)
    for cell in range(block_of_cell.shape[0] - 1, -1, -1):
        block = blocks[block_of_cell[cell]]
        for i in range(rows - 1, -1, -1):
            f = block[i]
            row -= 1
            v = scale(f[9], subtract(load(x, row, lanes), s0))
            store(x, row, v)
            s0 = fma(f[10], v, s1)
            s1 = fma(f[11], v, s2)
            s2 = fma(f[12], v, s3)
            s3 = fma(f[13], v, s4)
            s4 = fma(f[14], v, s5)
            s5 = fma(f[15], v, s6)
            s6 = fma(f[16], v, s7)
            s7 = fma(f[17], v, s8)
            s8 = scale(f[18], v)
