"""Studies as clients send and see them."""

from datetime import datetime
from typing import Annotated, Any, Literal

from pydantic import AwareDatetime, BaseModel, Field, StringConstraints

from app.boundary import Strict, without_default
from app.cases.schemas import Model
from app.db.models import StudyState
from app.pagination import PageQuery
from app.studies.sweep import ProductSweep
from solver.case import Case

PRINTABLE = r"^[^\x00-\x1f\x7f]*$"  # PostgreSQL stores no NUL, and nobody wants the others in a name

Name = Annotated[str, StringConstraints(min_length=1, max_length=200, pattern=PRINTABLE)]
Label = Annotated[str, StringConstraints(min_length=1, max_length=63, pattern=PRINTABLE)]
MAX_LABELS = 64
LabelValue = Annotated[str, StringConstraints(max_length=255, pattern=PRINTABLE)]
Priority = Annotated[int, Field(ge=-100, le=100, description="Cases of a higher priority are computed first.")]


class StudyRequest(Model):
    """A parametric study: a sweep of one model."""

    name: Name
    labels: dict[Label, LabelValue] = Field(default_factory=dict, max_length=MAX_LABELS)
    priority: Priority = 0
    sweep: ProductSweep
    keep_history: bool = Field(default=False, description="Whether to store the time histories of every case.")

    def expand(self) -> list[Case]:
        """The study's cases, each once, in a fixed order.

        Raises
        ------
        InvalidParameterError
            If values that are valid by themselves are not together.
        """
        return list(self.sweep.expand(self.parts()))


def _left_out(**more: Any) -> Any:
    return Field(default=None, json_schema_extra=without_default, **more)


class StudyPatch(Strict):
    """Changes to a study, as a JSON merge patch (RFC 7396): what is left out stays, a label of null is removed."""

    name: Name = _left_out()
    labels: dict[Label, LabelValue | None] = _left_out(
        max_length=2 * MAX_LABELS, description=f"At most {MAX_LABELS} may remain."
    )
    priority: Priority = _left_out()


def pointer_to_parameter(parameter: str) -> str:
    """JSON Pointer, into a :class:`StudyRequest`, of a parameter as the solver names it."""
    root = parameter.partition(".")[0]
    if root in Model.model_fields:
        return "/" + parameter.replace(".", "/")
    if root in ProductSweep.model_fields:
        return "/sweep/" + parameter.replace(".", "/")
    return "/sweep/speed_kmh"  # inside it is in m/s, and has another name


class CaseCounts(BaseModel):
    """How many cases of a study are in which state."""

    total: int
    queued: int
    running: int
    succeeded: int
    failed: int
    cancelled: int


class FinishEstimate(BaseModel):
    """When a study will be finished, if the cases to come take as long as those that went before."""

    expected: datetime
    earliest: datetime
    latest: datetime


class StudySummary(BaseModel):
    """A study and how far it is."""

    id: str
    name: str
    labels: dict[str, str]
    priority: int
    keep_history: bool
    state: StudyState
    progress: float = Field(description="Fraction done, 0 to 1.")
    cases: CaseCounts
    cases_reused: int = Field(description="Cases that were already computed when the study was created.")
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None


class StudyDetail(StudySummary):
    """A study, how far it is and what was asked for."""

    finish: FinishEstimate | None = Field(description="Null when finished, or before any case has been computed.")
    definition: dict[str, Any] = Field(description="The request that created the study.")


class StudyPage(BaseModel):
    """A page of studies."""

    items: list[StudySummary]
    next_cursor: str | None


class StudyQuery(PageQuery):
    """Which studies to list."""

    state: StudyState | None = None
    created_after: AwareDatetime | None = Field(default=None, description="Only studies created after this instant.")
    name: Annotated[str, StringConstraints(max_length=200, pattern=PRINTABLE)] | None = Field(
        default=None, description="Only studies whose name contains this, in upper or lower case."
    )
    sort: Literal["created_at", "-created_at", "name", "-name", "priority", "-priority"] = "-created_at"
