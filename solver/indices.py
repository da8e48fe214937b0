"""Filters and indices of the standards, zero phase, with records mirrored at their edges.

References
----------
EN 14363: 20 Hz low-pass of wheel-rail forces, their 99.85 % quantile, 0.4-10 Hz band of car-body accelerations.
GB/T 5599: wheel unloading, Sperling's index.
"""

from functools import cache
from typing import Literal

import numpy as np
from scipy.signal import butter, sosfiltfilt

from solver.arrays import Array

FILTER_ORDER = 4  # at every edge of the filter that runs forwards and backwards
FORCE_CUTOFF_HZ = 20.0
COMFORT_BAND_HZ = (0.4, 10.0)
QUANTILE = 0.9985
SPERLING_WINDOW_S = 5.0
SPERLING_BAND_HZ = (0.5, 80.0)
CONTACT_LOST_N = 0.0  # contact is lost where its force is not above this


def low_pass(values: Array, step: float) -> Array:
    """A history without what is faster than 20 Hz; ``step`` in s."""
    return _filtered(values, step, _sections(FILTER_ORDER, "lowpass", FORCE_CUTOFF_HZ, step), FORCE_CUTOFF_HZ)


def comfort_band(values: Array, step: float) -> Array:
    """A history between 0.4 and 10 Hz."""
    return _filtered(values, step, _sections(FILTER_ORDER, "bandpass", COMFORT_BAND_HZ, step), COMFORT_BAND_HZ[0])


@cache  # a short case takes less time to filter than its filters to design
def _sections(
    order: int, kind: Literal["lowpass", "bandpass"], edges: float | tuple[float, float], step: float
) -> Array:
    return butter(order, edges, kind, fs=1 / step, output="sos")


def _filtered(values: Array, step: float, sections: Array, slowest: float) -> Array:
    # Mirrored: continued oddly, a record that ends on a crest would drag the mean up to it.
    return sosfiltfilt(sections, values, padtype="even", padlen=mirrored(len(values), step, slowest))


def mirrored(samples: int, step: float, slowest: float) -> int:
    """How many samples are mirrored at either edge of a record: a period of the filter's slowest edge (Hz)."""
    return min(samples - 1, round(1 / (slowest * step)))


def _sperling_weight(frequency: Array) -> Array:
    low, high = frequency < 5.9, frequency >= 20
    return np.where(low, 0.325 * frequency**2, np.where(high, 1.0, 400 / frequency**2))


def sperling(acceleration: Array, step: float) -> Array:
    """Sperling's vertical ride index of successive 5 s windows; one value for a shorter record.

    Parameters
    ----------
    acceleration : ndarray, shape (n,)
        Of the car body, m/s^2.
    step : float
        s.

    Returns
    -------
    ndarray, shape (windows,)
    """
    length, count = sperling_windows(len(acceleration), step)
    windows = acceleration[: count * length].reshape(count, length)
    amplitude = 2 / length * np.abs(np.fft.rfft(windows, axis=1))
    frequency = np.fft.rfftfreq(length, step)
    counted = (frequency >= SPERLING_BAND_HZ[0]) & (frequency <= SPERLING_BAND_HZ[1])
    f = frequency[counted]
    tenth_powers = 3.57**10 * amplitude[:, counted] ** 3 / f * _sperling_weight(f)
    return np.sum(tenth_powers, axis=1) ** 0.1


def sperling_windows(samples: int, step: float) -> tuple[int, int]:
    """Samples of each of Sperling's windows, and how many windows a record holds."""
    length = min(samples, round(SPERLING_WINDOW_S / step))
    return length, samples // length


def contact_lost(force: Array) -> Array:
    """Where contact is lost; bool."""
    return force <= CONTACT_LOST_N


def contact_losses(force: Array, step: float) -> Array:
    """Durations of the intervals without contact, s; at least one value, zero where contact is never lost."""
    lost = np.r_[False, contact_lost(force), False]
    edges = np.flatnonzero(lost[1:] != lost[:-1])
    durations = (edges[1::2] - edges[::2]) * step
    return durations if len(durations) else np.zeros(1)
