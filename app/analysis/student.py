"""Student's t distribution, without SciPy in the service."""

import math
from functools import lru_cache


@lru_cache(maxsize=1024)
def t_limit(confidence: float, freedom: int) -> float:
    """What the magnitude of t stays below with a given probability.

    Parameters
    ----------
    confidence : float
        The probability, between 0 and 1.
    freedom : int
        Degrees of freedom, at least one.

    References
    ----------
    Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.3 and 26.7.4.
    """
    low, high = 0.0, math.pi / 2
    for _ in range(60):  # halvings: as exact as a double
        angle = (low + high) / 2
        low, high = (angle, high) if _within(angle, freedom) < confidence else (low, angle)
    return math.sqrt(freedom) * math.tan(low)


def _within(angle: float, freedom: int) -> float:
    """Probability that ``|t| < sqrt(freedom) tan(angle)``."""
    sine, square = math.sin(angle), math.cos(angle) ** 2
    odd = freedom % 2
    term, total = (math.cos(angle), 0.0) if odd else (1.0, 0.0)
    for n in range(1 + odd, freedom, 2):
        total += term
        term *= square * n / (n + 1)
    return 2 / math.pi * (angle + sine * total) if odd else sine * total
