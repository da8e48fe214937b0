"""Cubic Hermite beam elements: shape functions and their integrals.

An element of length l between two nodes carries the values ``(u1, u1', u2, u2')``.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import leggauss
from numpy.polynomial.polynomial import polyder

from solver.arrays import Array

# Shape functions on 0 <= xi <= 1; those of the slopes still to be multiplied by l.
_SHAPES = np.array([[1.0, 0, -3, 2], [0, 1, -2, 1], [0, 0, 3, -2], [0, 0, -1, 1]]).T  # powers, functions
_DERIVATIVES = [polyder(_SHAPES, order) for order in range(4)]
_POINTS, _WEIGHTS = leggauss(4)  # exact to degree 7, the products have 6


def hermite(xi: float | Array, length: float, derivative: int = 0) -> Array:
    """Shape functions or their derivatives with respect to position.

    Parameters
    ----------
    xi : float or ndarray
        Position inside the element, 0 to 1.
    length : float
        Length of the element, m.
    derivative : int
        Order of the derivative.

    Returns
    -------
    ndarray, shape (..., 4)
    """
    scale = np.array([1.0, length, 1.0, length]) / length**derivative
    return polynomials(_DERIVATIVES[derivative], xi) * scale


def polynomials(coefficients: Array, x: float | Array) -> Array:
    """Values (..., functions) of polynomials with coefficients (powers, functions)."""
    return np.asarray(x, float)[..., None] ** np.arange(len(coefficients)) @ coefficients


@dataclass(frozen=True)
class HermiteElement:
    """Integrals over one element, each of shape (4, 4) and exact."""

    length: float

    def _integral(self, left: int, right: int) -> Array:
        xi = (_POINTS + 1) / 2
        n, m = hermite(xi, self.length, left), hermite(xi, self.length, right)
        return np.einsum("g,gi,gj->ij", _WEIGHTS * self.length / 2, n, m)

    @cached_property
    def mass(self) -> Array:
        """Integral of N'N, with ' the transpose."""
        return self._integral(0, 0)

    @cached_property
    def gradient(self) -> Array:
        """Integral of N' dN/dr."""
        return self._integral(0, 1)

    @cached_property
    def stretch(self) -> Array:
        """Integral of dN/dr' dN/dr."""
        return self._integral(1, 1)

    @cached_property
    def bending(self) -> Array:
        """Integral of d2N/dr2' d2N/dr2."""
        return self._integral(2, 2)

    @cached_property
    def convection(self) -> Array:
        """Integral of N' dN/dr - dN/dr' N: skew, so that motion of the frame creates no energy."""
        return self.gradient - self.gradient.T
