"""Peaks as clients see them, and how they are chosen."""

from typing import TYPE_CHECKING, Annotated, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

from app.cases.views import Conditions, Word
from app.pagination import PageQuery
from app.studies.sweep.vary import PARAMETERS


class PeakValues(BaseModel):
    """Peak and statistics of one quantity at one position over the steady window of a case, in ``unit``."""

    quantity: str
    position: str
    unit: str
    peak: float = Field(description="Largest magnitude; for wheel-rail and pad forces the maximum.")
    maximum: float
    minimum: float
    mean: float
    std: float
    rms: float
    time_s: float = Field(description="When the peak occurs, s since the window began.")
    track_position_m: float = Field(description="Where the first wheelset is at that time, m.")


class CasePeak(PeakValues):
    """A peak of one case."""

    model_config = ConfigDict(from_attributes=True)


class CasePeakList(BaseModel):
    """The peaks of one case."""

    items: list[CasePeak]


class OfCase(Conditions):
    """Of which case something is, and what distinguishes that."""

    case_id: int
    solver_version: str


class PeakRow(PeakValues, OfCase):
    """Peak and statistics of one quantity at one position over the steady window of one case, in ``unit``."""

    parameters: dict[str, int | float | None] = Field(
        description="Parameters of the case by their paths, which end in their units: those asked for or, if none is "
        "and a study is named, those that it varies. Null where a case is older than the parameter."
    )


class PeakPage(BaseModel):
    """A page of peaks."""

    items: list[PeakRow]
    next_cursor: str | None


COLUMNS = tuple(name for name in PeakRow.model_fields if name != "parameters")
if TYPE_CHECKING:
    Sort: TypeAlias = str
    ParameterPath: TypeAlias = str
else:
    ParameterPath = Literal[tuple(PARAMETERS)]
    Sort = Literal[tuple(sign + column for column in COLUMNS for sign in ("", "-"))]


class PeakFilters(BaseModel):
    """Which peaks, and in which order."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    study_id: Annotated[str, StringConstraints(pattern="^[0-9a-f]{32}$")] | None = None
    quantity: Word | None = None
    position: Word | None = None
    slab: Word | None = None
    irregularity: Word | None = None
    spectrum: Word | None = None
    speed_kmh_min: float | None = None
    speed_kmh_max: float | None = None
    percentile: float | None = None
    wavelength_min_m: float | None = Field(default=None, description="Shortest wavelength of the band.")
    wavelength_max_m: float | None = Field(default=None, description="Longest wavelength of the band.")
    wavelength_m: float | None = Field(default=None, description="Wavelength of a harmonic irregularity.")
    value_min: float | None = Field(default=None, description="Only peaks of at least this, in the quantity's unit.")
    value_max: float | None = Field(default=None, description="Only peaks of at most this, in the quantity's unit.")
    parameter: Annotated[list[ParameterPath], Field(max_length=len(PARAMETERS))] = Field(
        default=[],
        description="Parameters of track, vehicle and numerics to tell of each peak's case, by their paths in a study; "
        "may be repeated. If none is given and a study is, those that the study varies.",
    )
    sort: Sort = Field(default="case_id", description="A column; with a minus sign, from large to small.")


class PeakQuery(PeakFilters, PageQuery):
    """Which peaks to list."""
