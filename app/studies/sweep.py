"""Sweeps: many cases in few words, counted before they are expanded."""

import math
from collections.abc import Iterator
from typing import Annotated, Any, Literal, TypeVar

from pydantic import AfterValidator, Discriminator, Field, Tag, model_validator
from pydantic_core import PydanticCustomError

from app.boundary import Strict
from app.cases.irregularities import (
    M_PER_MM,
    AmplitudeMm,
    Band,
    Percentile,
    Seed,
    SingleDip,
    SmoothRail,
    SpectrumChoice,
    SumOf,
    Wavelength,
    chosen_spectrum,
)
from app.cases.schemas import Speed, make_case
from solver.case import Case, Harmonic, Irregularity, Slab, Spectral
from solver.catalogue import SPECTRA

T = TypeVar("T")


def _distinct(values: list[T]) -> list[T]:
    seen: set[T] = set()
    for value in values:
        if value in seen:
            raise PydanticCustomError("duplicate", "A value is listed twice: {value}", {"value": str(value)})
        seen.add(value)
    return values


Several = Annotated[list[T], Field(min_length=1), AfterValidator(_distinct)]


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


class HarmonicSweep(Strict):
    """Sine waves: every wavelength with every amplitude."""

    kind: Literal["harmonic"]
    wavelength_m: Several[Wavelength]
    amplitude_mm: Several[AmplitudeMm]

    def count(self) -> int:
        """How many there are."""
        return len(self.wavelength_m) * len(self.amplitude_mm)

    def expand(self) -> Iterator[Irregularity]:
        """Every irregularity."""
        for wavelength in self.wavelength_m:
            for amplitude in self.amplitude_mm:
                yield Harmonic(wavelength=wavelength, amplitude=amplitude * M_PER_MM)


class SpectrumSweep(Strict):
    """Realisations of a spectrum: every percentile with every band, each with the same random phases."""

    kind: Literal["spectrum"]
    spectrum: SpectrumChoice = next(iter(SPECTRA))
    percentile: Several[Percentile] = [63.2]  # noqa: RUF012 - Pydantic copies it
    wavelength_band_m: Several[Band]
    realisations: Annotated[int, Field(ge=1, le=2**31, description="Number of realisations of each.")] = 1
    seed: Seed = 1

    def count(self) -> int:
        """How many there are."""
        return len(self.percentile) * len(self.wavelength_band_m) * self.realisations

    def expand(self) -> Iterator[Irregularity]:
        """Every irregularity."""
        spectrum = chosen_spectrum(self.spectrum)
        for percentile in self.percentile:
            for band in self.wavelength_band_m:
                for realisation in range(self.realisations):
                    yield Spectral(
                        spectrum=spectrum,
                        percentile=percentile,
                        wavelength_min=band.min,
                        wavelength_max=band.max,
                        seed=self.seed,
                        realisation=realisation,
                    )


def _list_or_range(value: object) -> str:
    return "range" if isinstance(value, dict | SpeedRange) else "list"


class ProductSweep(Strict):
    """Every speed with every slab with every irregularity."""

    kind: Literal["product"]
    speed_kmh: Annotated[
        Annotated[Several[Speed], Tag("list")] | Annotated[SpeedRange, Tag("range")], Discriminator(_list_or_range)
    ]
    slab: Several[Slab] = ["continuous"]  # noqa: RUF012 - Pydantic copies it
    irregularity: Annotated[SmoothRail | HarmonicSweep | SpectrumSweep | SingleDip | SumOf, Field(discriminator="kind")]

    def count(self) -> int:
        """How many there are."""
        speeds = self.speed_kmh.count() if isinstance(self.speed_kmh, SpeedRange) else len(self.speed_kmh)
        return speeds * len(self.slab) * self.irregularity.count()

    def expand(self, parts: dict[str, Any]) -> Iterator[Case]:
        """Every case, in a fixed order.

        Parameters
        ----------
        parts : dict
            Track, vehicle and numerics, which all share.

        Raises
        ------
        InvalidParameterError
            If values that are valid by themselves are not together.
        """
        speeds = self.speed_kmh.expand() if isinstance(self.speed_kmh, SpeedRange) else self.speed_kmh
        irregularities = list(self.irregularity.expand())
        for speed_kmh in speeds:
            for slab in self.slab:
                for irregularity in irregularities:
                    yield make_case(speed_kmh, slab, irregularity, parts)
