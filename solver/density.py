"""Densities and variances of spectra, whatever their convention, as one-sided PSDs per 1/m."""

import numpy as np
from scipy.special import exprel

from solver.arrays import Array
from solver.spectrum import AnySpectrum, PowerLaw, Rational, Table


def density(spectrum: AnySpectrum, frequency: Array) -> Array:
    """One-sided spatial PSD, m^2/(1/m).

    ``S(f) = 2 pi S(Omega)`` at ``Omega = 2 pi f``, and a one-sided density is twice a two-sided one.

    Parameters
    ----------
    spectrum : PowerLaw, Rational or Table
        In any convention.
    frequency : ndarray
        Frequencies, 1/m.
    """
    unit = _own_unit(spectrum)
    x = frequency * unit
    if isinstance(spectrum, Rational):
        c2, r2 = spectrum.cutoff**2, spectrum.lower_cutoff**2
        own = spectrum.roughness * c2 / ((x**2 + r2) * (x**2 + c2))
    else:
        coefficients, exponents, breaks = _pieces(spectrum)
        piece = np.searchsorted(breaks, x, side="right")
        own = coefficients[piece] / x ** exponents[piece]
    return spectrum.sides * unit * own


def variance_between(spectrum: AnySpectrum, edges: Array) -> Array:
    """Integral of the one-sided PSD between successive frequencies, m^2, from its antiderivative.

    Parameters
    ----------
    spectrum : PowerLaw, Rational or Table
        In any convention.
    edges : ndarray, shape (n + 1,)
        Increasing frequencies, 1/m.

    Returns
    -------
    ndarray, shape (n,)
    """
    x = edges * _own_unit(spectrum)  # S(f) df = S(Omega) dOmega: no other factor
    integral = _rational_integral(spectrum, x) if isinstance(spectrum, Rational) else _power_integral(spectrum, x)
    return spectrum.sides * integral


def _own_unit(spectrum: AnySpectrum) -> float:
    """The spectrum's own frequency per 1/m."""
    return 1.0 if spectrum.per == "1/m" else 2 * np.pi


def _pieces(spectrum: PowerLaw | Table) -> tuple[Array, Array, Array]:
    """Coefficients, exponents and breaks of power laws; those at the ends of a table go on beyond it."""
    if isinstance(spectrum, PowerLaw):
        return np.array(spectrum.coefficients), np.array(spectrum.exponents), np.array(spectrum.breaks)
    x, y = np.log(spectrum.frequencies), np.log(spectrum.densities)
    slope = np.diff(y) / np.diff(x)
    return np.exp(y[:-1] - slope * x[:-1]), -slope, np.array(spectrum.frequencies[1:-1])


def _power_integral(spectrum: PowerLaw | Table, x: Array) -> Array:
    coefficients, exponents, breaks = _pieces(spectrum)
    corners = np.sort(np.concatenate([x, breaks[(x[0] < breaks) & (breaks < x[-1])]]))
    low, width = corners[:-1], np.log1p(np.diff(corners) / corners[:-1])
    piece = np.searchsorted(breaks, low * np.exp(width / 2))
    slope = 1 - exponents[piece]
    # (high^s - low^s) / s, also for s = 0 and where high is close to low
    parts = coefficients[piece] * low**slope * width * exprel(slope * width)
    return np.add.reduceat(parts, np.searchsorted(corners, x[:-1]))


def _rational_integral(spectrum: Rational, x: Array) -> Array:
    c, r = spectrum.cutoff, spectrum.lower_cutoff
    return spectrum.roughness * c**2 / (c**2 - r**2) * (_lorentz_integral(r, x) - _lorentz_integral(c, x))


def _lorentz_integral(a: float, x: Array) -> Array:
    """Integral of ``1 / (x^2 + a^2)`` between successive x: a difference of arctangents as one arctangent."""
    product, width = x[:-1] * x[1:], np.diff(x)
    return np.arctan2(a * width, a * a + product) / a if a > 0 else width / product
