"""Time histories as clients see them, and what of them they ask for."""

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from app.cases.views import Word

Words = Annotated[list[Word], Field(max_length=100)]


class HistoryQuery(BaseModel):
    """Which part of a history, and how finely."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    quantity: Words = Field(default=[], description="Only channels of these quantities; may be repeated.")
    position: Words = Field(default=[], description="Only channels at these positions; may be repeated.")
    time_min_s: float | None = Field(default=None, ge=0, le=1e6, description="Start, s since the window began.")
    time_max_s: float | None = Field(default=None, ge=0, le=1e6, description="End, s since the window began.")
    max_points: int = Field(
        default=1000,
        ge=2,
        le=10_000,
        description="Samples per channel. Of more, those that are least or greatest among their neighbours are "
        "kept as they are, so that no peak is lost.",
    )


class SpectrumQuery(BaseModel):
    """Of which channel, and how finely."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    quantity: Word = Field(description="A quantity of the history.")
    position: Word = Field(description="Where, as in the history.")
    resolution_hz: float = Field(
        default=2.0,
        ge=0.25,
        le=100,
        description="Distance between frequencies: the smaller, the fewer segments to take the mean of. Not less than "
        "the length of the history allows.",
    )
    frequency_max_hz: float = Field(default=1000.0, ge=1, le=2500, description="Highest frequency, Hz.")


class HistoryChannel(BaseModel):
    """Samples of one quantity at one position, in ``unit``."""

    quantity: str
    position: str
    unit: str
    time_s: list[float] = Field(description="When, s since the window began.")
    values: list[float] = Field(description="The samples at these times.")


class HistoryView(BaseModel):
    """A time history, or a part of it."""

    case_id: int
    digest: str = Field(description="SHA-256 of the stored file.")
    samples: int = Field(description="Stored samples per channel in the range of time.")
    speed_kmh: float
    track_position_start_m: float = Field(description="Where the first wheelset is when the window begins, m.")
    channels: list[HistoryChannel]


class SpectrumView(BaseModel):
    """The one-sided power spectral density of a channel, by Welch's method: Hann windows, overlapping by half."""

    quantity: str
    position: str
    unit: str = Field(description="Of the channel.")
    density_unit: str
    resolution_hz: float
    segments: int = Field(description="Of how many the density is the mean.")
    frequency_hz: list[float]
    density: list[float]
    pad_passing_hz: float = Field(description="How often a wheel passes a pad.")
    p2_hz: float = Field(
        description="Where the unsprung wheel bounces on the track: the contact force over a small wave is largest, in "
        "linear theory, on a continuous track at rest."
    )
