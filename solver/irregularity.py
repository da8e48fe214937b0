"""Irregularity of the rail head along the track, positive downwards."""

import math

import numpy as np

from solver.arrays import Array
from solver.case import Dip, Harmonic, Irregularity, Measured, Smooth, Spectral, Sum
from solver.catalogue import SPECTRA
from solver.density import variance_between
from solver.measured import measured_heights

# Components of a realisation stand 1/2048 m apart whatever the band, the speed and the window, so that equal seeds mean
# the same track, and a narrower band the same track without the rest.
FREQUENCY_STEP = 1 / 2048


def percentile_factor(percentile: float) -> float:
    """What multiplies the mean spectrum at a percentile: an ordinate is distributed exponentially."""
    return -math.log1p(-percentile / 100)


def _uniform_phases(seed: int, realisation: int, first: int, count: int) -> Array:
    """Random phases of the components first, first + 1, …: bits of PCG64, the same on any machine."""
    bits = np.random.PCG64(np.random.SeedSequence([seed, realisation]))
    bits.advance(first)
    return (bits.random_raw(count) >> np.uint64(11)) * (2 * np.pi / 2**53)


def components(irregularity: Smooth | Harmonic | Spectral) -> tuple[Array, Array, Array]:
    """Frequencies (1/m), amplitudes (m) and phases of the cosines that sum to the irregularity."""
    if isinstance(irregularity, Smooth):
        return np.zeros(0), np.zeros(0), np.zeros(0)
    if isinstance(irregularity, Harmonic):
        return np.array([1 / irregularity.wavelength]), np.array([irregularity.amplitude]), np.array([-np.pi / 2])
    return _realisation(irregularity)


def _realisation(irregularity: Spectral) -> tuple[Array, Array, Array]:
    lowest, highest = 1 / irregularity.wavelength_max, 1 / irregularity.wavelength_min
    first, last = math.floor(lowest / FREQUENCY_STEP), math.ceil(highest / FREQUENCY_STEP)
    edges = np.clip(np.arange(first, last + 1) * FREQUENCY_STEP, lowest, highest)
    spectrum = irregularity.spectrum
    if isinstance(spectrum, str):
        spectrum = SPECTRA[spectrum].values
    variance = percentile_factor(irregularity.percentile) * variance_between(spectrum, edges)
    phases = _uniform_phases(irregularity.seed, irregularity.realisation, first, len(variance))
    return (edges[:-1] + edges[1:]) / 2, np.sqrt(2 * variance), phases


def sample(irregularity: Irregularity, start: float, spacing: float, count: int) -> Array:
    """The irregularity, m, at ``count`` positions ``start + i spacing`` (m)."""
    if isinstance(irregularity, Sum):
        return np.sum([sample(term, start, spacing, count) for term in irregularity.terms], axis=0)
    if isinstance(irregularity, Measured):
        return measured_heights(irregularity, start + spacing * np.arange(count))
    if isinstance(irregularity, Dip):
        return _dip(irregularity, start + spacing * np.arange(count))
    return _waves(*components(irregularity), start, spacing, count)


def _dip(dip: Dip, x: Array) -> Array:
    from_middle = np.minimum(np.abs(x - dip.position) / dip.length, 0.5)
    return dip.depth / 2 * (1 + np.cos(2 * np.pi * from_middle))


def _waves(frequency: Array, amplitude: Array, phase: Array, start: float, spacing: float, count: int) -> Array:
    """Sum of cosines at evenly spaced positions.

    The exponentials are products of those of a coarse and of a fine grid, so that the sum is a matrix product: exact,
    and hundreds of times quicker than cosine by cosine.
    """
    fine = max(1, math.isqrt(count))
    coarse = -(-count // fine)
    omega = 2j * np.pi * frequency
    left = np.exp(np.outer(start + spacing * fine * np.arange(coarse), omega) + 1j * phase) * amplitude
    right = np.exp(np.outer(omega, spacing * np.arange(fine)))
    return (left @ right).real.ravel()[:count]
