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
