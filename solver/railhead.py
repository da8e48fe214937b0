"""Irregularities of the rail head that a case may have, positive downwards, in SI units, frozen and checked."""

import hashlib
import math
import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property
from itertools import combinations, pairwise
from typing import Any

from solver.quantity import Checked, InvalidParameterError, floats, quantity
from solver.spectrum import SPECTRUM_KINDS, AnySpectrum, Table

SHORTEST, LONGEST = 0.1, 400.0  # m of wavelength
FARTHEST = 1e6  # m along the track
HIGHEST = 0.1  # m of deviation of a measured profile
MIN_POINTS, MAX_POINTS = 16, 200_000
MAX_TERMS = 10
ROUNDING = 1e-6  # relative, in positions and frequencies that were written in decimals

Samples = tuple[tuple[float, ...], tuple[float, ...]]  # positions and heights, m
Profiles = Callable[[str], Samples]  # by digest


@dataclass(frozen=True, kw_only=True)
class Smooth:
    """A perfectly even rail head."""

    @property
    def shortest_wavelength(self) -> float:
        """Shortest wavelength contained, m."""
        return math.inf


@dataclass(frozen=True, kw_only=True)
class Harmonic(Checked):
    """``A sin(2 pi x / wavelength)`` (Eq. 16 of the article)."""

    _path = "irregularity."

    wavelength: float = quantity("m", "wavelength", ge=0.1, le=200)
    amplitude: float = quantity("m", "amplitude", ge=0, le=0.02)

    @property
    def shortest_wavelength(self) -> float:
        """Shortest wavelength contained, m."""
        return self.wavelength


@dataclass(frozen=True, kw_only=True)
class Banded(Checked):
    """Base of what is limited to a band of wavelengths."""

    _path = "irregularity."

    wavelength_min: float = quantity("m", "shortest wavelength", ge=SHORTEST, le=LONGEST)
    wavelength_max: float = quantity("m", "longest wavelength", ge=SHORTEST, le=LONGEST)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.wavelength_min >= self.wavelength_max:
            raise self._band_error("must have min < max")

    def _band_error(self, problem: str) -> InvalidParameterError:
        return InvalidParameterError(
            "irregularity.wavelength_band_m", f"{problem}, is {self.wavelength_min:g} to {self.wavelength_max:g} m"
        )

    @property
    def shortest_wavelength(self) -> float:
        """Shortest wavelength contained, m."""
        return self.wavelength_min


@dataclass(frozen=True, kw_only=True)
class Spectral(Banded):
    """One realisation of a power spectral density within a wavelength band.

    ``spectrum`` is a name of the catalogue or a spectrum of the user's own.
    """

    spectrum: str | AnySpectrum = "tb3352-ballastless"
    percentile: float = quantity("%", "percentile of the spectrum", gt=0, lt=100, default=63.2)
    seed: int = quantity("", "seed of the random phases", ge=0, lt=2**63, default=1)
    realisation: int = quantity("", "number of the realisation, from 0", ge=0, lt=2**31, default=0)

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.spectrum, Table):
            unit = 1 if self.spectrum.per == "1/m" else 2 * math.pi
            first, last = self.spectrum.frequencies[0] / unit, self.spectrum.frequencies[-1] / unit
            if 1 / self.wavelength_max < first * (1 - ROUNDING) or 1 / self.wavelength_min > last * (1 + ROUNDING):
                raise self._band_error(f"must lie within the table of the spectrum, {1 / last:g} to {1 / first:g} m")


@dataclass(frozen=True, kw_only=True)
class Measured(Banded):
    """A measured profile: heights at positions along the track, of which a band of wavelengths is used.

    Attributes
    ----------
    positions : tuple of float
        Increasing positions, m, where the first wheel stands at ``numerics.start_m`` at first.
    heights : tuple of float
        Deviations there, m, positive downwards.
    """

    positions: tuple[float, ...]
    heights: tuple[float, ...]

    def __post_init__(self) -> None:
        super().__post_init__()
        positions = floats("irregularity.positions_m", self.positions, -FARTHEST, FARTHEST, MIN_POINTS, MAX_POINTS)
        count = len(positions)
        heights = floats("irregularity.heights_m", self.heights, -HIGHEST, HIGHEST, count, count)
        object.__setattr__(self, "positions", positions)
        object.__setattr__(self, "heights", heights)
        for n, (here, there) in enumerate(pairwise(positions), 1):
            if not 0 < there - here <= self.wavelength_min / 2 * (1 + ROUNDING):
                raise InvalidParameterError(
                    f"irregularity.positions_m.{n}",
                    f"must lie beyond {here:g} m, by half the shortest wavelength ({self.wavelength_min / 2:g} m) "
                    f"at most, is {there:g}",
                )
        if positions[-1] - positions[0] < self.wavelength_max * (1 - ROUNDING):
            raise self._band_error(f"must not be longer than the profile, {positions[-1] - positions[0]:g} m")

    @cached_property
    def profile(self) -> str:
        """Digest of positions and heights, which name them where they are not written out."""
        return profile_digest(self.positions, self.heights)


@dataclass(frozen=True, kw_only=True)
class Dip(Checked):
    """One cosine dip, ``depth (1 + cos(2 pi (x - position) / length)) / 2``, as at a weld; a bump if depth < 0."""

    _path = "irregularity."

    position: float = quantity("m", "position of the middle", ge=-FARTHEST, le=FARTHEST)
    length: float = quantity("m", "length from end to end", ge=0.1, le=200)
    depth: float = quantity("m", "depth in the middle", ge=-0.02, le=0.02)

    @property
    def shortest_wavelength(self) -> float:
        """Shortest wavelength contained, m."""
        return self.length


Term = Smooth | Harmonic | Spectral | Measured | Dip


@dataclass(frozen=True, kw_only=True)
class Sum:
    """Several irregularities added up."""

    terms: tuple[Term, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "terms", tuple(self.terms))
        if not 1 <= len(self.terms) <= MAX_TERMS or not all(isinstance(term, Term) for term in self.terms):
            raise InvalidParameterError("irregularity.terms", f"must be 1 to {MAX_TERMS} irregularities, none a sum")
        spectral = [(n, term) for n, term in enumerate(self.terms) if isinstance(term, Spectral)]
        for (m, one), (n, other) in combinations(spectral, 2):
            alike = (one.seed, one.realisation) == (other.seed, other.realisation)
            if alike and one.wavelength_min < other.wavelength_max and other.wavelength_min < one.wavelength_max:
                raise InvalidParameterError(
                    f"irregularity.terms.{n}.seed", f"must differ from that of term {m}: the two would add in phase"
                )

    @property
    def shortest_wavelength(self) -> float:
        """Shortest wavelength contained, m."""
        return min(term.shortest_wavelength for term in self.terms)


Irregularity = Term | Sum
IRREGULARITY_KINDS: dict[str, type[Irregularity]] = {
    "none": Smooth,
    "harmonic": Harmonic,
    "spectrum": Spectral,
    "measured": Measured,
    "dip": Dip,
    "sum": Sum,
}
_KIND_OF: dict[type, str] = {cls: kind for kind, cls in (IRREGULARITY_KINDS | SPECTRUM_KINDS).items()}


def profile_digest(positions: Sequence[float], heights: Sequence[float]) -> str:
    """SHA-256, as 64 hexadecimal digits, of a measured profile: equal for equal numbers, on any machine."""
    return hashlib.sha256(struct.pack(f"<{2 * len(positions)}d", *positions, *heights)).hexdigest()


def irregularity_to_dict(irregularity: Irregularity, *, samples: bool = True) -> dict[str, Any]:
    """Plain numbers, strings, lists and dicts, with the kind of every irregularity and spectrum.

    Parameters
    ----------
    irregularity : Irregularity
        What to write.
    samples : bool
        Whether measured profiles are written out, or only named by their digest.
    """
    data: dict[str, Any] = _plain(irregularity, samples)
    return data


def _plain(value: Any, samples: bool) -> Any:
    if is_dataclass(value):
        names = [f.name for f in fields(value)]
        if isinstance(value, Measured) and not samples:
            names = [name for name in names if name not in ("positions", "heights")] + ["profile"]
        return {"kind": _KIND_OF[type(value)]} | {name: _plain(getattr(value, name), samples) for name in names}
    if isinstance(value, tuple):
        return [_plain(each, samples) for each in value] if value and is_dataclass(value[0]) else list(value)
    return value


def irregularity_from_dict(data: dict[str, Any], profiles: Profiles | None = None) -> Irregularity:
    """The irregularity of an :func:`irregularity_to_dict`; ``profiles`` finds what is only named."""
    values = dict(data)
    cls = IRREGULARITY_KINDS[values.pop("kind")]
    if isinstance(spectrum := values.get("spectrum"), dict):
        own = dict(spectrum)
        values["spectrum"] = SPECTRUM_KINDS[own.pop("kind")](**own)
    if profiles is not None and "profile" in values:
        values["positions"], values["heights"] = profiles(values.pop("profile"))
    if cls is Sum:
        values["terms"] = tuple(irregularity_from_dict(term, profiles) for term in values["terms"])
    return cls(**values)
