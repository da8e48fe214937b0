"""Irregularities as people write them: m and mm, own spectra in SI units with their convention."""

from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import Discriminator, Field, StringConstraints, Tag

from app.boundary import Strict, bounded, counted
from solver.case import Dip, Harmonic, Irregularity, Measured, Smooth, Spectral, Sum
from solver.catalogue import SPECTRA
from solver.quantity import InvalidParameterError
from solver.railhead import LONGEST, MAX_TERMS, MIN_POINTS, SHORTEST, Profiles, Samples
from solver.railhead import MAX_POINTS as MAX_PROFILE
from solver.spectrum import MAX_POINTS, SPECTRUM_KINDS, AnySpectrum, Per, Rational, Sides

# The conversion is part of a case's digest: another expression for the same number can round differently.
M_PER_MM = 1e-3

Percentile = Annotated[float, bounded(Spectral, "percentile")]
Wavelength = Annotated[float, bounded(Harmonic, "wavelength")]
AmplitudeMm = Annotated[float, bounded(Harmonic, "amplitude", 1 / M_PER_MM, "mm")]
Seed = Annotated[int, bounded(Spectral, "seed")]
ProfileId = Annotated[str, StringConstraints(pattern="^[0-9a-f]{64}$")]

if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know
    SpectrumName: TypeAlias = str
else:
    SpectrumName = Literal[tuple(SPECTRA)]


Numbers = Annotated[list[float], counted(MAX_POINTS)]


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
    coefficients: Numbers = Field(description="A of each piece.", min_length=1, max_length=MAX_POINTS)
    exponents: Numbers = Field(description="k of each piece.", min_length=1, max_length=MAX_POINTS)
    breaks: Numbers = Field(description="Frequencies between the pieces.", max_length=MAX_POINTS, default_factory=list)


class RationalSpectrum(OwnSpectrum):
    """``S = A c^2 / ((f^2 + r^2) (f^2 + c^2))``."""

    kind: Literal["rational"]
    roughness: Annotated[float, bounded(Rational, "roughness")]
    cutoff: Annotated[float, bounded(Rational, "cutoff")]
    lower_cutoff: Annotated[float, bounded(Rational, "lower_cutoff")] = 0.0


class TableSpectrum(OwnSpectrum):
    """Densities at frequencies, with straight lines between them in double logarithmic scale."""

    kind: Literal["table"]
    frequencies: Numbers = Field(description="Increasing frequencies.", min_length=2, max_length=MAX_POINTS)
    densities: Numbers = Field(description="Densities there.", min_length=2, max_length=MAX_POINTS)


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


def chosen_spectrum(choice: str | OwnSpectrum | AnySpectrum) -> str | AnySpectrum:
    """As the solver takes it."""
    return choice.spectrum() if isinstance(choice, OwnSpectrum) else choice


class Irregularities(Strict):
    """One irregularity or many of one kind, each chosen by a value on every axis."""

    def axes(self) -> dict[str, Sequence[Any]]:
        """What is listed, by the name of its field."""
        return {}

    @property
    def repeats(self) -> int:
        """How many irregularities there are for one value on every axis."""
        return 1

    @abstractmethod
    def chosen(self, values: Mapping[str, Any], profiles: Profiles) -> Iterator[Irregularity]:
        """The irregularities of one value on every axis, as the solver takes them.

        Parameters
        ----------
        values : mapping
            Value on each of the axes.
        profiles : callable
            Positions and heights of a stored profile by its identifier.

        Raises
        ------
        InvalidParameterError
            If values that are valid by themselves are not together.
        """


class Single(Irregularities):
    """One irregularity."""

    @abstractmethod
    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it; see :meth:`chosen`."""

    def chosen(self, values: Mapping[str, Any], profiles: Profiles) -> Iterator[Irregularity]:
        """Itself."""
        yield self.irregularity(profiles)


class SmoothRail(Single):
    """A perfectly even rail head."""

    kind: Literal["none"]

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        return Smooth()


class HarmonicWave(Single):
    """A sine wave."""

    kind: Literal["harmonic"]
    wavelength_m: Wavelength
    amplitude_mm: AmplitudeMm

    def irregularity(self, profiles: Profiles) -> Irregularity:
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

    def irregularity(self, profiles: Profiles) -> Irregularity:
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

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        return Dip(position=self.position_m, length=self.length_m, depth=self.depth_mm * M_PER_MM)


class MeasuredProfile(Single):
    """Measured heights, positive downwards, of which a band of wavelengths is used."""

    kind: Literal["measured"]
    positions_m: list[float] = Field(description="Increasing positions.", min_length=MIN_POINTS, max_length=MAX_PROFILE)
    heights_m: list[float] = Field(description="Heights there.", min_length=MIN_POINTS, max_length=MAX_PROFILE)
    wavelength_band_m: Band

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        return Measured(
            positions=tuple(self.positions_m),
            heights=tuple(self.heights_m),
            wavelength_min=self.wavelength_band_m.min,
            wavelength_max=self.wavelength_band_m.max,
        )


class StoredProfile(Single):
    """A stored profile, of which a band of wavelengths is used: all that it holds if none is given."""

    kind: Literal["measured"]
    profile_id: ProfileId
    wavelength_band_m: Band | None = None

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        try:
            positions, heights = profiles(self.profile_id)
        except KeyError:
            raise InvalidParameterError("irregularity.profile_id", "names no stored profile") from None
        band = self.wavelength_band_m or whole_band(positions)
        try:
            return Measured(positions=positions, heights=heights, wavelength_min=band.min, wavelength_max=band.max)
        except InvalidParameterError as error:  # of samples that are fine by themselves: too few for this band
            if not error.parameter.startswith("irregularity.positions_m"):
                raise
            sample = error.parameter.rpartition(".")[2]
            raise InvalidParameterError(
                "irregularity.wavelength_band_m", f"is too short for the profile: sample {sample} {error.problem}"
            ) from None


class SumOf(Single):
    """Several irregularities added up."""

    kind: Literal["sum"]
    terms: Annotated[
        list[Annotated[HarmonicWave | SpectrumSample | SingleDip | StoredProfile, Field(discriminator="kind")]],
        counted(MAX_TERMS),
    ] = Field(min_length=1, max_length=MAX_TERMS)

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        return _sum(self.terms, profiles)


class SumWithMeasured(Single):
    """Several irregularities added up, measured ones with their samples."""

    kind: Literal["sum"]
    terms: list[Annotated[HarmonicWave | SpectrumSample | SingleDip | MeasuredProfile, Field(discriminator="kind")]] = (
        Field(min_length=1, max_length=MAX_TERMS)
    )

    def irregularity(self, profiles: Profiles) -> Irregularity:
        """As the solver takes it."""
        return _sum(self.terms, profiles)


def whole_band(positions: Sequence[float]) -> Band:
    """The widest band of a profile that the solver takes: from twice its widest gap to its length."""
    widest = max(there - here for here, there in pairwise(positions))
    return Band.model_construct(min=max(SHORTEST, 2 * widest), max=min(LONGEST, positions[-1] - positions[0]))


def _sum(terms: Sequence[Single], profiles: Profiles) -> Sum:
    solver_terms: list[Any] = []
    for n, term in enumerate(terms):
        try:
            solver_terms.append(term.irregularity(profiles))
        except InvalidParameterError as error:
            inside = error.parameter.removeprefix("irregularity.")
            raise InvalidParameterError(f"irregularity.terms.{n}.{inside}", error.problem) from None
    return Sum(terms=tuple(solver_terms))


def no_profiles(profile_id: str) -> Samples:
    """Where no profiles are stored."""
    raise KeyError(profile_id)


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
    if "profile" in outside:
        outside["profile_id"] = outside.pop("profile")
    if "wavelength_min" in outside:
        outside["wavelength_band_m"] = {"min": outside.pop("wavelength_min"), "max": outside.pop("wavelength_max")}
    if isinstance(spectrum := outside.get("spectrum"), dict):
        scope = ("wavelength_range", "speed_range_kmh")  # only those of the catalogue have any
        outside["spectrum"] = {name: value for name, value in spectrum.items() if name not in scope}
    if "terms" in outside:
        outside["terms"] = [at_boundary(term) for term in outside["terms"]]
    return outside
