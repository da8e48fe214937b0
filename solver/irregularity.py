"""Irregularity of the rail head along the track, positive downwards."""

import math

import numpy as np

from solver.arrays import Array
from solver.case import Harmonic, Irregularity, Smooth, Spectral
from solver.catalogue import SPECTRA, PowerLaw

# Components of a realisation stand 1/2048 m apart whatever the band, the speed and the window, so that equal seeds mean
# the same track, and a narrower band the same track without the rest.
FREQUENCY_STEP = 1 / 2048


def spectral_density(spectrum: PowerLaw, frequency: Array) -> Array:
    """One-sided spatial PSD, m^2/(1/m), at frequencies in 1/m."""
    piece = np.searchsorted(spectrum.breaks, frequency, side="right")
    return np.take(spectrum.coefficients, piece) / frequency ** np.take(spectrum.exponents, piece)


def variance_between(spectrum: PowerLaw, edges: Array) -> Array:
    """Integral of the PSD between successive frequencies (1/m), m^2: exact, piece by piece."""
    corners = np.union1d(edges, [b for b in spectrum.breaks if edges[0] < b < edges[-1]])
    low, high = corners[:-1], corners[1:]
    piece = np.searchsorted(spectrum.breaks, np.sqrt(low * high))
    a, k = np.take(spectrum.coefficients, piece), np.take(spectrum.exponents, piece)
    parts = a * (high ** (1 - k) - low ** (1 - k)) / (1 - k)
    return np.add.reduceat(parts, np.searchsorted(corners, edges[:-1]))


def percentile_factor(percentile: float) -> float:
    """What multiplies the mean spectrum at a percentile: an ordinate is distributed exponentially."""
    return -math.log1p(-percentile / 100)


def _uniform_phases(seed: int, realisation: int, first: int, count: int) -> Array:
    """Random phases of the components first, first + 1, …: bits of PCG64, the same on any machine."""
    bits = np.random.PCG64(np.random.SeedSequence([seed, realisation]))
    bits.advance(first)
    return (bits.random_raw(count) >> np.uint64(11)) * (2 * np.pi / 2**53)


def components(irregularity: Irregularity) -> tuple[Array, Array, Array]:
    """Frequencies (1/m), amplitudes (m) and phases of the cosines that sum to the irregularity."""
    if isinstance(irregularity, Smooth):
        return np.zeros((3, 0))[0], np.zeros(0), np.zeros(0)
    if isinstance(irregularity, Harmonic):
        return np.array([1 / irregularity.wavelength]), np.array([irregularity.amplitude]), np.array([-np.pi / 2])
    return _realisation(irregularity)


def _realisation(irregularity: Spectral) -> tuple[Array, Array, Array]:
    lowest, highest = 1 / irregularity.wavelength_max, 1 / irregularity.wavelength_min
    first, last = math.floor(lowest / FREQUENCY_STEP), math.ceil(highest / FREQUENCY_STEP)
    edges = np.clip(np.arange(first, last + 1) * FREQUENCY_STEP, lowest, highest)
    spectrum = SPECTRA[irregularity.spectrum].values
    variance = percentile_factor(irregularity.percentile) * variance_between(spectrum, edges)
    phases = _uniform_phases(irregularity.seed, irregularity.realisation, first, len(variance))
    return (edges[:-1] + edges[1:]) / 2, np.sqrt(2 * variance), phases


def sample(irregularity: Irregularity, start: float, spacing: float, count: int) -> Array:
    """The irregularity, m, at ``count`` positions ``start + i spacing`` (m).

    The exponentials of the sum are products of those of a coarse and of a fine grid, so that the sum is a matrix
    product: exact, and hundreds of times quicker than cosine by cosine.
    """
    frequency, amplitude, phase = components(irregularity)
    fine = max(1, math.isqrt(count))
    coarse = -(-count // fine)
    omega = 2j * np.pi * frequency
    left = np.exp(np.outer(start + spacing * fine * np.arange(coarse), omega) + 1j * phase) * amplitude
    right = np.exp(np.outer(omega, spacing * np.arange(fine)))
    return (left @ right).real.ravel()[:count]
