"""Fewer samples for a screen, by which no peak is lost."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def peaks_of_bins(values: NDArray[Any], max_points: int) -> NDArray[np.intp]:
    """Which samples to draw: the least and the greatest of each of ``max_points // 2`` stretches of equal length.

    Parameters
    ----------
    values : ndarray, shape (n,)
        Samples.
    max_points : int
        How many may be drawn, at least two.

    Returns
    -------
    ndarray, shape (m,)
        Increasing indices, not more than ``max_points``; all if there are no more.
    """
    n = len(values)
    if n <= max_points:
        return np.arange(n)
    length = -(-n // (max_points // 2))
    bins = -(-n // length)
    # Filled up with the last value, which is found earlier: no index lies beyond the end.
    filled = np.pad(values, (0, bins * length - n), mode="edge").reshape(bins, length)
    first = np.arange(bins) * length
    return np.unique(np.concatenate([first + filled.argmin(axis=1), first + filled.argmax(axis=1)]))
