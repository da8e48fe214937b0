"""Comparisons and statistics as clients see them, and what they ask for."""

from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import BaseModel, ConfigDict, Field, StringConstraints

from app.cases.views import Word
from app.db.models import STATISTICS

if TYPE_CHECKING:
    Statistic: TypeAlias = str
else:
    Statistic = Literal[STATISTICS[:6]]

Conditions = Annotated[
    dict[str, Any],
    Field(
        description="Of all that varies in the study, what these cases have in common; by its name in the study, as "
        "in `track.pad_stiffness_n_per_m`."
    ),
]


class AnalysisQuery(BaseModel):
    """Which numbers of a study."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    quantity: Word | None = None
    position: Word | None = None
    statistic: Statistic = Field(default="peak", description="Which number of each case.")


class ComparisonQuery(AnalysisQuery):
    """Which numbers of a study, along which axis."""

    axis: Word = Field(
        description="What varies in the study and is to be compared: `slab`, `percentile`, `wavelength_band_m`, "
        "`speed_kmh`, `track.pad_stiffness_n_per_m`, …"
    )
    baseline: Annotated[str, StringConstraints(max_length=200)] | None = Field(
        default=None,
        description="The value of the axis that the others are compared with, a number or a band as JSON has it; the "
        "first of the study if not given.",
    )


class Difference(BaseModel):
    """One value less the baseline's."""

    at: Any = Field(description="Value of the axis.")
    value: float
    absolute: float = Field(description="Value less the baseline's, in the unit.")
    relative: float | None = Field(description="The same, per magnitude of the baseline's. Null if that is zero.")


class Pairing(BaseModel):
    """Cases that differ along the axis only."""

    quantity: str
    position: str
    unit: str
    conditions: Conditions
    baseline_value: float
    differences: list[Difference]


class MeanDifference(BaseModel):
    """Differences averaged over all groups that have both values."""

    quantity: str
    position: str
    unit: str
    at: Any = Field(description="Value of the axis.")
    groups: int
    absolute: float
    absolute_std: float | None = Field(description="Standard deviation over the groups. Null for less than two.")
    relative: float | None = Field(description="Mean of the groups' relative differences. Null if one has none.")


class Comparison(BaseModel):
    """Differences along one axis of a study, between cases that are otherwise equal."""

    study_id: str
    axis: str
    statistic: str
    baseline: Any
    averages: list[MeanDifference]
    groups: list[Pairing]
    groups_without_baseline: int = Field(description="Left out: their case at the baseline has not succeeded.")


class Quantiles(BaseModel):
    """Values that a part of the realisations stays below, interpolated linearly."""

    p5: float
    p25: float
    p50: float
    p75: float
    p95: float


class ConfidenceInterval(BaseModel):
    """An interval with a confidence."""

    lower: float
    upper: float


class Summary(BaseModel):
    """Statistics over the realisations of one condition."""

    quantity: str
    position: str
    unit: str
    conditions: Conditions
    count: int
    mean: float
    std: float | None = Field(description="Of the sample, over count - 1. Null for less than two.")
    minimum: float
    maximum: float
    quantiles: Quantiles
    mean_95: ConfidenceInterval | None = Field(
        description="Interval that holds the mean of all possible realisations with a confidence of 95 %, by "
        "Student's t. Null for less than two."
    )


class Statistics(BaseModel):
    """Statistics over the realisations of a study."""

    study_id: str
    statistic: str
    conditions: list[Summary]
