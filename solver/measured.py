"""A measured profile made ready to drive over: resampled, detrended, limited to its band, zero at its ends."""

from functools import lru_cache

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft, rfftfreq
from scipy.interpolate import BSpline, make_interp_spline

from solver.arrays import Array
from solver.railhead import Measured

POINTS_PER_WAVE = 16  # of the shortest wavelength: the last spline is then right to 1e-6 of its amplitude


def measured_heights(measured: Measured, x: Array) -> Array:
    """Heights of the band at positions (m), m; zero beyond the ends of the profile."""
    inside = (measured.positions[0] <= x) & (x <= measured.positions[-1])
    heights = np.zeros(len(x))
    heights[inside] = _band_limited(measured)(x[inside])
    return heights


@lru_cache(maxsize=16)  # four wheels in each lane ask for it
def _band_limited(measured: Measured) -> BSpline[np.float64]:
    positions = np.array(measured.positions)
    length = positions[-1] - positions[0]
    # No coarser than the profile, or what is shorter than the band would be mistaken for what is in it.
    spacing = min(measured.wavelength_min / POINTS_PER_WAVE, length / (len(positions) - 1))
    grid = np.linspace(positions[0], positions[-1], int(np.ceil(length / spacing)) + 1)
    heights = make_interp_spline(positions, np.array(measured.heights), k=5)(grid)
    heights -= np.polynomial.Polynomial.fit(grid, heights, 1)(grid)

    # Tapered before the filter, so that the ends are no edges to it, and after it, because it spreads beyond them.
    taper = _taper(grid, min(measured.wavelength_max, length / 4))
    return make_interp_spline(grid, taper * _filtered(taper * heights, grid[1] - grid[0], measured), k=5)


def _taper(grid: Array, length: float) -> Array:
    s = np.clip(np.minimum(grid - grid[0], grid[-1] - grid) / length, 0, 1)
    return s**3 * (10 - 15 * s + 6 * s**2)


def _filtered(heights: Array, spacing: float, band: Measured) -> Array:
    """The wavelengths of the band and no others, without shift."""
    padded = next_fast_len(len(heights) + int(band.wavelength_max / spacing), real=True)  # ends must not meet
    frequency = rfftfreq(padded, spacing)
    outside = (frequency < 1 / band.wavelength_max) | (frequency > 1 / band.wavelength_min)
    spectrum = rfft(heights, padded)
    spectrum[outside] = 0
    return irfft(spectrum, padded)[: len(heights)]
