"""Cases as clients see them."""

from datetime import datetime
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

from app.db.models import CaseState
from app.pagination import PageQuery

Word = Annotated[str, StringConstraints(max_length=100, pattern=r"^[\x21-\x7e]*$")]
CASE_ORDERS = ("position", "speed_kmh", "slab", "percentile", "state", "cpu_s", "finished_at")
if TYPE_CHECKING:
    CaseSort: TypeAlias = str
else:
    CaseSort = Literal[tuple(sign + column for column in CASE_ORDERS for sign in ("", "-"))]


class Conditions(BaseModel):
    """What distinguishes a case. Null where it does not apply."""

    speed_kmh: float
    slab: str
    irregularity: str = Field(description="Kind of irregularity.")
    spectrum: str | None
    percentile: float | None
    wavelength_min_m: float | None
    wavelength_max_m: float | None
    seed: int | None
    realisation: int | None
    wavelength_m: float | None
    amplitude_mm: float | None


class CaseError(BaseModel):
    """Why a case failed."""

    code: str = Field(description="Stable name of the reason; `poison` if every attempt ended without an outcome.")
    detail: str


class CaseSummary(Conditions):
    """A case and how far it is."""

    model_config = ConfigDict(from_attributes=True)

    id: int
    digest: str = Field(description="SHA-256 of the inputs.")
    solver_version: str
    state: CaseState
    progress: float = Field(description="Fraction done, 0 to 1.")
    attempt: int = Field(description="Number of the attempt that runs or ran last; 0 before the first.")
    worker: str | None
    error: CaseError | None
    cpu_s: float | None = Field(
        description="Processor time of the successful attempt, s; of cases computed together, a share."
    )
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


class StoredHistory(BaseModel):
    """The stored time history of a case."""

    model_config = ConfigDict(from_attributes=True)

    digest: str = Field(description="SHA-256 of the file.")
    size_bytes: int


class CaseDetail(CaseSummary):
    """A case with everything that went into it."""

    inputs: dict[str, Any] = Field(
        description="The case as `tracksweep solve` takes it, every value spelled out; of a measured profile, the "
        "`profile_id`, where `tracksweep solve` takes a file."
    )
    processing: dict[str, Any] | None = Field(
        description="How its peaks were derived: sampling, window, filters, indices, conventions. Null for a case that "
        "has not succeeded or was computed before this was stored."
    )
    history: StoredHistory | None


class CasePage(BaseModel):
    """A page of cases."""

    items: list[CaseSummary]
    next_cursor: str | None


class CaseQuery(PageQuery):
    """Which cases of a study to list."""

    state: CaseState | None = None
    slab: Word | None = None
    irregularity: Word | None = None
    percentile: float | None = None
    speed_kmh_min: float | None = None
    speed_kmh_max: float | None = None
    sort: CaseSort = Field(
        default="position", description="A column, or the place in the sweep; with a minus sign, from large to small."
    )
