"""Spatial power spectral densities of the rail head, each with its convention: per 1/m or rad/m, one- or two-sided.

What a density means depends on that convention, so no spectrum has a default for it. Values are in SI units: m^2/(1/m)
or m^2/(rad/m). :mod:`solver.density` evaluates all of them as one-sided densities in m^2/(1/m).
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, get_args

from solver.quantity import Checked, InvalidParameterError, floats, quantity

Per = Literal["1/m", "rad/m"]
Sides = Literal[1, 2]
MAX_POINTS = 10_000
_PATH = "irregularity.spectrum."
_LARGEST = 1e12


def _check_increasing(name: str, frequencies: tuple[float, ...]) -> None:
    if any(low >= high for low, high in pairwise((0.0, *frequencies))):
        raise InvalidParameterError(_PATH + name, "must be positive and increase")


@dataclass(frozen=True, kw_only=True)
class Spectrum(Checked):
    """What every spectrum states of itself.

    Attributes
    ----------
    per : {"1/m", "rad/m"}
        Unit of its frequency: S is in m^2/(1/m) of f, or in m^2/(rad/m) of ``Omega = 2 pi f``.
    sides : {1, 2}
        Whether its integral over positive frequencies is the variance (1) or half of it (2).
    wavelength_range : tuple of float, optional
        Shortest and longest wavelength, m, for which it was drawn up.
    speed_range_kmh : tuple of float, optional
        Lowest and highest speed, km/h, for which it was drawn up.
    """

    _path = _PATH

    per: Per
    sides: Sides
    wavelength_range: tuple[float, float] | None = None
    speed_range_kmh: tuple[float, float] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, choices in (("per", get_args(Per)), ("sides", get_args(Sides))):
            if (value := getattr(self, name)) not in choices or isinstance(value, bool | float):
                raise InvalidParameterError(_PATH + name, f"must be {' or '.join(map(str, choices))}, is {value!r}")
        for name in ("wavelength_range", "speed_range_kmh"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, floats(_PATH + name, getattr(self, name), 0, _LARGEST, 2, 2))


@dataclass(frozen=True, kw_only=True)
class PowerLaw(Spectrum):
    """``S = A / f^k``, piece by piece.

    Attributes
    ----------
    coefficients : tuple of float
        A of each piece.
    exponents : tuple of float
        k of each piece.
    breaks : tuple of float
        Frequencies between the pieces.
    """

    coefficients: tuple[float, ...]
    exponents: tuple[float, ...]
    breaks: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        super().__post_init__()
        pieces = len(self.breaks) + 1
        limits = {"coefficients": (0, _LARGEST, pieces), "exponents": (-20, 20, pieces), "breaks": (0, _LARGEST, 0)}
        for name, (low, high, least) in limits.items():
            most = least or MAX_POINTS
            object.__setattr__(self, name, floats(_PATH + name, getattr(self, name), low, high, least, most))
        _check_increasing("breaks", self.breaks)


@dataclass(frozen=True, kw_only=True)
class Rational(Spectrum):
    """``S = A c^2 / ((Omega^2 + r^2) (Omega^2 + c^2))``, c and r in its own unit of frequency."""

    roughness: float = quantity("", "A, m^2 times the unit of frequency", ge=0, le=1)
    cutoff: float = quantity("", "c, cut-off frequency", ge=1e-3, le=1e3)
    lower_cutoff: float = quantity("", "r, lower cut-off frequency, at most 0.99 c", ge=0, lt=1e3, default=0.0)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.lower_cutoff > 0.99 * self.cutoff:  # the density's integral is a difference that would be lost
            raise InvalidParameterError(
                _PATH + "lower_cutoff",
                f"must be at most {0.99 * self.cutoff:g} (0.99 cutoff), is {self.lower_cutoff:g}",
            )


@dataclass(frozen=True, kw_only=True)
class Table(Spectrum):
    """Densities at frequencies, straight lines between them in double logarithmic scale: power laws.

    Attributes
    ----------
    frequencies : tuple of float
        Increasing frequencies.
    densities : tuple of float
        Densities there.
    """

    frequencies: tuple[float, ...]
    densities: tuple[float, ...]

    def __post_init__(self) -> None:
        super().__post_init__()
        frequencies = floats(_PATH + "frequencies", self.frequencies, 0, _LARGEST, 2, MAX_POINTS)
        count = len(frequencies)
        object.__setattr__(self, "frequencies", frequencies)
        _check_increasing("frequencies", frequencies)
        densities = floats(_PATH + "densities", self.densities, 1e-100, _LARGEST, count, count)
        object.__setattr__(self, "densities", densities)


AnySpectrum = PowerLaw | Rational | Table
SPECTRUM_KINDS: dict[str, type[AnySpectrum]] = {"power-law": PowerLaw, "rational": Rational, "table": Table}
