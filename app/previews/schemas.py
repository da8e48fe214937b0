"""Previews as clients ask for and see them."""

from typing import Annotated

from pydantic import BaseModel, Field

from app.boundary import Strict
from app.cases.irregularities import HarmonicWave, SingleDip, SmoothRail, SpectrumSample, StoredProfile, SumOf
from solver.railhead import FARTHEST

MAX_SAMPLES = 2**14
SAMPLES_PER_WAVE = 16, 4  # of the shortest wavelength: as many as can be, and at least


class PreviewRequest(Strict):
    """An irregularity, and which part of it to look at."""

    irregularity: Annotated[
        SmoothRail | HarmonicWave | SpectrumSample | StoredProfile | SingleDip | SumOf, Field(discriminator="kind")
    ]
    start_m: Annotated[float, Field(ge=-FARTHEST, le=FARTHEST, description="Where to begin, m.")] = 0.0
    length_m: Annotated[
        float,
        Field(
            ge=1,
            le=20_000,
            description=f"How long, m; at most {MAX_SAMPLES // SAMPLES_PER_WAVE[1]} of the shortest wavelengths.",
        ),
    ] = 100.0
    max_points: Annotated[
        int,
        Field(
            ge=2,
            le=10_000,
            description="Points of the profile. Of more samples, the least and greatest among neighbours are kept.",
        ),
    ] = 1000


class Heights(BaseModel):
    """Heights along the track, positive downwards."""

    positions_m: list[float]
    heights_mm: list[float]


class HeightDensity(BaseModel):
    """A one-sided power spectral density of heights, m^2/(1/m), at frequencies per metre of track."""

    frequencies_per_m: list[float]
    densities_m3: list[float]


class IrregularityPreview(BaseModel):
    """An irregularity over some length, sampled as the solver does."""

    spacing_m: float = Field(description="Distance between samples.")
    samples: int
    lowest_mm: float
    highest_mm: float
    rms_mm: float
    profile: Heights
    density: HeightDensity = Field(description="Of the samples, by Welch's method.")
    drawn_from: HeightDensity | None = Field(
        description="The density from which realisations are drawn, with the percentile, in the band. Null where the "
        "irregularity is not of a spectrum."
    )
