"""Irregularities as people write them: m and mm, own spectra in SI units with their convention."""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import Discriminator, Field, Tag

from app.boundary import Strict, bounded
from solver.case import Dip, Harmonic, Irregularity, Measured, Smooth, Spectral, Sum
from solver.catalogue import SPECTRA
from solver.quantity import InvalidParameterError
from solver.railhead import MAX_POINTS as MAX_PROFILE
from solver.railhead import MAX_TERMS
from solver.spectrum import MAX_POINTS, SPECTRUM_KINDS, AnySpectrum, Per, Rational, Sides

# The conversion is part of a case's digest: another expression for the same number can round differently.
M_PER_MM = 1e-3

Percentile = Annotated[float, bounded(Spectral, "percentile")]
Wavelength = Annotated[float, bounded(Harmonic, "wavelength")]
AmplitudeMm = Annotated[float, bounded(Harmonic, "amplitude", 1 / M_PER_MM, "mm")]
Seed = Annotated[int, bounded(Spectral, "seed")]

if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know
    SpectrumName: TypeAlias = str
else:
    SpectrumName = Literal[tuple(SPECTRA)]


class Band(Strict):
    """A band of wavelengths, m."""

    min: Annotated[float, bounded(Spectral, "wavelength_min")]
    max: Annotated[float, bounded(Spectral, "wavelength_max")]


class OwnSpectrum(Strict):
    """A spectrum that is not in the catalogue, with the convention in which its values are meant."""

    kind: str
    per: Per = Field(description="Unit of its frequency: S is in m^2/(1/m), or in m^2/(rad/m) of 2 pi times that.")
    sides: Sides = Field(
        description="Whether its integral over positive frequencies is the variance (1) or half of it."
    )

    def spectrum(self) -> AnySpectrum:
        """As the solver takes it."""
        return SPECTRUM_KINDS[self.kind](**self.model_dump(exclude={"kind"}))


class PowerLawSpectrum(OwnSpectrum):
    """``S = A / f^k``, piece by piece."""

    kind: Literal["power-law"]
    coefficients: list[float] = Field(description="A of each piece.", min_length=1, max_length=MAX_POINTS)
    exponents: list[float] = Field(description="k of each piece.", min_length=1, max_length=MAX_POINTS)
    breaks: list[float] = Field(
        description="Frequencies between the pieces.", max_length=MAX_POINTS, default_factory=list
    )


class RationalSpectrum(OwnSpectrum):
    """``S = A c^2 / ((f^2 + r^2) (f^2 + c^2))``."""

    kind: Literal["rational"]
    roughness: Annotated[float, bounded(Rational, "roughness")]
    cutoff: Annotated[float, bounded(Rational, "cutoff")]
    lower_cutoff: Annotated[float, bounded(Rational, "lower_cutoff")] = 0.0


class TableSpectrum(OwnSpectrum):
    """Densities at frequencies, with straight lines between them in double logarithmic scale."""

    kind: Literal["table"]
    frequencies: list[float] = Field(description="Increasing frequencies.", min_length=2, max_length=MAX_POINTS)
    densities: list[float] = Field(description="Densities there.", min_length=2, max_length=MAX_POINTS)


def _kind_of_spectrum(value: object) -> str | None:
    if isinstance(value, str):
        return "name"
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return kind if isinstance(kind, str) else None


SpectrumChoice = Annotated[
    Annotated[SpectrumName, Tag("name")]
    | Annotated[PowerLawSpectrum, Tag("power-law")]
    | Annotated[RationalSpectrum, Tag("rational")]
    | Annotated[TableSpectrum, Tag("table")],
    Discriminator(_kind_of_spectrum),
]


def chosen_spectrum(choice: str | OwnSpectrum) -> str | AnySpectrum:
    """As the solver takes it."""
    return choice if isinstance(choice, str) else choice.spectrum()


class Single(Strict):
    """One irregularity, which is also a sweep of one."""

    @abstractmethod
    def irregularity(self) -> Irregularity:
        """As the solver takes it.

        Raises
        ------
        InvalidParameterError
            If values that are valid by themselves are not together.
        """

    def count(self) -> int:
        """How many there are."""
        return 1

    def expand(self) -> Iterator[Irregularity]:
        """Every irregularity."""
        yield self.irregularity()


class SmoothRail(Single):
    """A perfectly even rail head."""

    kind: Literal["none"]

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Smooth()


class HarmonicWave(Single):
    """A sine wave."""

    kind: Literal["harmonic"]
    wavelength_m: Wavelength
    amplitude_mm: AmplitudeMm

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Harmonic(wavelength=self.wavelength_m, amplitude=self.amplitude_mm * M_PER_MM)


class SpectrumSample(Single):
    """One realisation of a spectrum."""

    kind: Literal["spectrum"]
    spectrum: SpectrumChoice = next(iter(SPECTRA))
    percentile: Percentile = 63.2
    wavelength_band_m: Band
    seed: Seed = 1
    realisation: Annotated[int, bounded(Spectral, "realisation")] = 0

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Spectral(
            spectrum=chosen_spectrum(self.spectrum),
            percentile=self.percentile,
            wavelength_min=self.wavelength_band_m.min,
            wavelength_max=self.wavelength_band_m.max,
            seed=self.seed,
            realisation=self.realisation,
        )


class SingleDip(Single):
    """One cosine dip, as at a weld; a bump if its depth is negative."""

    kind: Literal["dip"]
    position_m: Annotated[float, bounded(Dip, "position")]
    length_m: Annotated[float, bounded(Dip, "length")]
    depth_mm: Annotated[float, bounded(Dip, "depth", 1 / M_PER_MM, "mm")]

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Dip(position=self.position_m, length=self.length_m, depth=self.depth_mm * M_PER_MM)


class MeasuredProfile(Single):
    """Measured heights, positive downwards, of which a band of wavelengths is used."""

    kind: Literal["measured"]
    positions_m: list[float] = Field(description="Increasing positions.", min_length=16, max_length=MAX_PROFILE)
    heights_m: list[float] = Field(description="Heights there.", min_length=16, max_length=MAX_PROFILE)
    wavelength_band_m: Band

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Measured(
            positions=tuple(self.positions_m),
            heights=tuple(self.heights_m),
            wavelength_min=self.wavelength_band_m.min,
            wavelength_max=self.wavelength_band_m.max,
        )


class SumOf(Single):
    """Several irregularities added up."""

    kind: Literal["sum"]
    terms: list[Annotated[HarmonicWave | SpectrumSample | SingleDip, Field(discriminator="kind")]] = Field(
        min_length=1, max_length=MAX_TERMS
    )

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return _sum(self.terms)


class SumWithMeasured(Single):
    """Several irregularities added up, measured ones too."""

    kind: Literal["sum"]
    terms: list[Annotated[HarmonicWave | SpectrumSample | SingleDip | MeasuredProfile, Field(discriminator="kind")]] = (
        Field(min_length=1, max_length=MAX_TERMS)
    )

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return _sum(self.terms)


def _sum(terms: Sequence[Single]) -> Sum:
    solver_terms: list[Any] = []
    for n, term in enumerate(terms):
        try:
            solver_terms.append(term.irregularity())
        except InvalidParameterError as error:
            inside = error.parameter.removeprefix("irregularity.")
            raise InvalidParameterError(f"irregularity.terms.{n}.{inside}", error.problem) from None
    return Sum(terms=tuple(solver_terms))


def at_boundary(irregularity: dict[str, Any]) -> dict[str, Any]:
    """What people would write for an irregularity of a ``Case.to_dict()``.

    Rounding takes back what the conversions above did to the last digit.
    """
    outside = dict(irregularity)
    for name in ("wavelength", "position", "length", "positions", "heights"):
        if name in outside:
            outside[f"{name}_m"] = outside.pop(name)
    for name in ("amplitude", "depth"):
        if name in outside:
            outside[f"{name}_mm"] = round(outside.pop(name) / M_PER_MM, 9)
    if "wavelength_min" in outside:
        outside["wavelength_band_m"] = {"min": outside.pop("wavelength_min"), "max": outside.pop("wavelength_max")}
    if isinstance(spectrum := outside.get("spectrum"), dict):
        scope = ("wavelength_range", "speed_range_kmh")  # only those of the catalogue have any
        outside["spectrum"] = {name: value for name, value in spectrum.items() if name not in scope}
    if "terms" in outside:
        outside["terms"] = [at_boundary(term) for term in outside["terms"]]
    return outside
