"""Axes of sweeps: many values in few words, counted before they are expanded."""

import math
from abc import abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from app.boundary import Listed, Strict
from app.cases.irregularities import (
    AmplitudeMm,
    Band,
    HarmonicWave,
    Irregularities,
    Percentile,
    ProfileId,
    Seed,
    Single,
    SingleDip,
    SmoothRail,
    SpectrumChoice,
    SpectrumSample,
    StoredProfile,
    SumOf,
    Wavelength,
    chosen_spectrum,
)
from app.cases.schemas import Speed
from solver.case import Irregularity
from solver.catalogue import SPECTRA
from solver.railhead import Profiles


class SpeedRange(Strict):
    """Evenly spaced speeds, km/h: ``start``, ``start + step`` and so on, not above ``stop``."""

    kind: Literal["range"]
    start: Speed
    stop: Speed
    step: Annotated[float, Field(ge=1e-3, description="Distance between speeds, km/h.")]

    @model_validator(mode="after")
    def _not_backwards(self) -> "SpeedRange":
        if self.stop < self.start:
            raise PydanticCustomError("range-backwards", "stop must not be below start")
        return self

    def count(self) -> int:
        """How many there are."""
        return math.floor((self.stop - self.start) / self.step + 1e-6) + 1

    def expand(self) -> list[float]:
        """Every speed."""
        return [min(round(self.start + n * self.step, 9), self.stop) for n in range(self.count())]


def _list_or_range(value: object) -> str:
    return "range" if isinstance(value, dict | SpeedRange) else "list"


SpeedAxis = Annotated[
    Annotated[Listed[Speed], Tag("list")] | Annotated[SpeedRange, Tag("range")], Discriminator(_list_or_range)
]
Axis = Sequence[Any] | SpeedRange


def length(axis: Axis) -> int:
    """How many values an axis has."""
    return axis.count() if isinstance(axis, SpeedRange) else len(axis)


def values(axis: Axis) -> Sequence[Any]:
    """Every value of an axis."""
    return axis.expand() if isinstance(axis, SpeedRange) else axis


class Swept(Irregularities):
    """Irregularities of one kind, of which some fields are lists."""

    @abstractmethod
    def single(self, **chosen: Any) -> Single:
        """The one with these values in place of lists."""

    def axes(self) -> dict[str, Sequence[Any]]:
        """What is listed, by the name of its field."""
        return {name: value for name in type(self).model_fields if isinstance(value := getattr(self, name), list)}

    def chosen(self, values: Mapping[str, Any], profiles: Profiles) -> Iterator[Irregularity]:
        """The irregularity of one value on every axis."""
        yield self.single(**values).irregularity(profiles)


class HarmonicSweep(Swept):
    """Sine waves of several wavelengths and amplitudes."""

    kind: Literal["harmonic"]
    wavelength_m: Listed[Wavelength]
    amplitude_mm: Listed[AmplitudeMm]

    def single(self, **chosen: Any) -> Single:
        """The wave of one wavelength and one amplitude."""
        return HarmonicWave.model_construct(kind=self.kind, **chosen)


class SpectrumSweep(Swept):
    """Realisations of a spectrum in several percentiles and bands, each with the same random phases."""

    kind: Literal["spectrum"]
    spectrum: SpectrumChoice = next(iter(SPECTRA))
    percentile: Listed[Percentile] = [63.2]  # noqa: RUF012 - Pydantic copies it
    wavelength_band_m: Listed[Band]
    realisations: Annotated[int, Field(ge=1, le=2**31, description="Number of realisations of each.")] = 1
    seed: Seed = 1

    @property
    def repeats(self) -> int:
        """How many irregularities there are for one value on every axis."""
        return self.realisations

    def single(self, **chosen: Any) -> Single:
        """One realisation of one percentile and band."""
        return SpectrumSample.model_construct(kind=self.kind, seed=self.seed, **chosen)

    def chosen(self, values: Mapping[str, Any], profiles: Profiles) -> Iterator[Irregularity]:
        """Every realisation of one percentile and band."""
        spectrum = chosen_spectrum(self.spectrum)
        for realisation in range(self.realisations):
            yield self.single(spectrum=spectrum, realisation=realisation, **values).irregularity(profiles)


class ProfileSweep(Swept):
    """A stored profile, of which several bands of wavelengths are used: all that it holds if none is given."""

    kind: Literal["measured"]
    profile_id: ProfileId
    wavelength_band_m: Listed[Band] | None = None

    def single(self, **chosen: Any) -> Single:
        """One band of it."""
        return StoredProfile.model_construct(kind=self.kind, profile_id=self.profile_id, **chosen)


IrregularityAxes = Annotated[
    SmoothRail | HarmonicSweep | SpectrumSweep | ProfileSweep | SingleDip | SumOf, Field(discriminator="kind")
]
