"""Studies as clients send and see them."""

from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import AwareDatetime, BaseModel, BeforeValidator, Discriminator, Field, StringConstraints, Tag
from pydantic_core import PydanticKnownError

from app.boundary import Strict, without_default
from app.cases.irregularities import no_profiles
from app.cases.schemas import Model
from app.db.models import StudyState
from app.pagination import PageQuery
from app.studies.presets import PRESETS
from app.studies.sweep import ListSweep, ProductSweep, Sweep, ZipSweep, located
from solver.case import Case
from solver.railhead import Profiles

PRINTABLE = r"^[^\x00-\x1f\x7f]*$"  # PostgreSQL stores no NUL, and nobody wants the others in a name

Name = Annotated[str, StringConstraints(min_length=1, max_length=200, pattern=PRINTABLE)]
Label = Annotated[str, StringConstraints(min_length=1, max_length=63, pattern=PRINTABLE)]
MAX_LABELS = 64
LabelValue = Annotated[str, StringConstraints(max_length=255, pattern=PRINTABLE)]
Priority = Annotated[int, Field(ge=-100, le=100, description="Cases of a higher priority are computed first.")]


if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know
    PresetName: TypeAlias = str
else:
    PresetName = Literal[tuple(PRESETS)]


def _kind_of_sweep(value: object) -> str | None:
    if isinstance(value, str):
        return "preset"
    kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
    return kind if isinstance(kind, str) else None


def _names_checked(schema: dict[str, Any]) -> None:
    """Say it so that no other name passes: a property that matches no pattern may have any value."""
    schema.pop("default", None)
    ((pattern, values),) = schema.pop("patternProperties").items()
    schema["propertyNames"]["pattern"] = pattern
    schema["additionalProperties"] = values


class StudyRequest(Model):
    """A parametric study: a sweep of one model."""

    name: Name
    labels: dict[Label, LabelValue] = Field(
        default_factory=dict, max_length=MAX_LABELS, json_schema_extra=_names_checked
    )
    priority: Priority = 0
    sweep: Annotated[
        Annotated[PresetName, Tag("preset")]
        | Annotated[ProductSweep, Tag("product")]
        | Annotated[ZipSweep, Tag("zip")]
        | Annotated[ListSweep, Tag("list")],
        Discriminator(
            _kind_of_sweep,
            custom_error_type="sweep-kind",
            custom_error_message="A sweep is the name of a preset or has a kind: product, zip or list",
        ),
    ] = Field(
        description="Which cases there are. The name of a preset stands for its sweep, and for its track, vehicle and "
        "numerics as far as the study does not say otherwise."
    )
    keep_history: bool = Field(default=False, description="Whether to store the time histories of every case.")

    def count(self) -> int:
        """How many cases there are; those listed twice, twice."""
        return self._whole()[0].count()

    def expand(self, profiles: Profiles = no_profiles) -> list[Case]:
        """The study's cases in a fixed order.

        Parameters
        ----------
        profiles : callable
            Positions and heights of a stored profile by its identifier.

        Raises
        ------
        ContradictionError
            If values that are valid by themselves are not together.
        """
        sweep, model = self._whole()
        with located("/sweep"):
            parts = model.parts()
        return list(sweep.expand(parts, profiles))

    def _whole(self) -> tuple[Sweep, Model]:
        """Sweep and model, those of a preset included."""
        if not isinstance(self.sweep, str):
            return self.sweep, self
        own = self.model_dump(exclude_unset=True, exclude={"sweep"})
        whole = StudyRequest.model_validate(_merged(PRESETS[self.sweep].study, own))
        assert not isinstance(whole.sweep, str)  # noqa: S101 - for the type checker: presets hold no presets
        return whole.sweep, whole


def _left_out(schema: Callable[[dict[str, Any]], None] = without_default, **more: Any) -> Any:
    return Field(default=None, json_schema_extra=schema, **more)


class StudyPatch(Strict):
    """Changes to a study, as a JSON merge patch (RFC 7396): what is left out stays, a label of null is removed."""

    name: Name = _left_out()
    labels: dict[Label, LabelValue | None] = _left_out(
        _names_checked, max_length=2 * MAX_LABELS, description=f"At most {MAX_LABELS} may remain."
    )
    priority: Priority = _left_out()


def _merged(below: dict[str, Any], above: dict[str, Any]) -> dict[str, Any]:
    both = {key for key in below.keys() & above.keys() if isinstance(below[key], dict) and isinstance(above[key], dict)}
    return below | above | {key: _merged(below[key], above[key]) for key in both}


class CaseCounts(BaseModel):
    """How many cases of a study are in which state."""

    total: int
    queued: int
    running: int
    succeeded: int
    failed: int
    cancelled: int


class FinishEstimate(BaseModel):
    """When a study will be finished by the workers that are there, judging by what such cases took before."""

    expected: datetime
    earliest: datetime
    latest: datetime


class StudySummary(BaseModel):
    """A study and how far it is."""

    id: str
    name: str
    labels: dict[str, str]
    owner: str | None = Field(description="Name of the API key that created it; null if that took none.")
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

    finish: FinishEstimate | None = Field(description="Null when it has ended, or while no worker is there.")
    definition: dict[str, Any] = Field(description="The request that created the study.")


class StudyPage(BaseModel):
    """A page of studies."""

    items: list[StudySummary]
    next_cursor: str | None


def _no_number(text: str) -> str:
    """A number would be read as seconds since 1970, which the schema does not say."""
    if "-" not in text[1:]:
        raise PydanticKnownError("datetime_parsing", {"error": "a number is not one"})
    return text


class StudyQuery(PageQuery):
    """Which studies to list."""

    state: StudyState | None = None
    created_after: Annotated[AwareDatetime, BeforeValidator(_no_number)] | None = Field(
        default=None, description="Only studies created after this instant."
    )
    name: Annotated[str, StringConstraints(max_length=200, pattern=PRINTABLE)] | None = Field(
        default=None, description="Only studies whose name contains this, in upper or lower case."
    )
    sort: Literal["created_at", "-created_at", "name", "-name", "priority", "-priority"] = "-created_at"
