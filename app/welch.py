"""Power spectral densities of evenly spaced samples, by Welch's method."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def welch(values: NDArray[Any], rate: float, segment: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """One-sided density: the mean of periodograms of segments that overlap by half, under Hann windows.

    Parameters
    ----------
    values : ndarray, shape (n,)
        Samples.
    rate : float
        Samples per second, or per metre.
    segment : int
        Samples of a segment, 2 to n. Means of segments are taken off.

    Returns
    -------
    frequencies, density : ndarray, shape (segment // 2 + 1,)
        In the unit of ``rate``, and in that of the samples squared, per unit of ``rate``.
    """
    segments = np.lib.stride_tricks.sliding_window_view(values, segment)[:: max(1, segment // 2)]
    window = np.sin(np.pi * np.arange(segment) / segment) ** 2
    total = np.zeros(segment // 2 + 1)
    for part in segments:  # one by one: all of them at once would take twice the memory of a whole history
        total += np.abs(np.fft.rfft((part - part.mean(dtype=float)) * window)) ** 2
    density = total / (len(segments) * rate * (window**2).sum())
    density[1 : (segment + 1) // 2] *= 2  # negative frequencies too, which zero and half the rate have none of
    return np.fft.rfftfreq(segment, 1 / rate), density
