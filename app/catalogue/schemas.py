"""The catalogue as clients see it."""

from typing import Any, Literal

from pydantic import BaseModel, Field

from app.access.schemas import CallerLimits
from solver.catalogue import Mark

MARK = Field(
    description="How sure that is: V, read in the named source; C, in common use in the literature, its primary source "
    "not seen; A, assumed here."
)


class Sourced(BaseModel):
    """Where something was found."""

    source: str
    mark: Mark = MARK


class QuantityLimit(Sourced):
    """A value that a quantity should not exceed."""

    value: float = Field(description="In the unit of the quantity.")
    applies: str = Field(description="To what, or when.")


class QuantityInfo(BaseModel):
    """A quantity of which peaks are given."""

    name: str
    title: str
    unit: str
    convention: str = Field(description="Of what it is and which sign means what; empty where the title says it.")
    peak: Literal["magnitude", "maximum"] = Field(description="What its `peak` is the largest of.")
    derived_from: str | None = Field(description="The recorded quantity behind it; null if it is in histories itself.")
    positions: list[str]
    limits: list[QuantityLimit]


class QuantityList(BaseModel):
    """All quantities."""

    items: list[QuantityInfo]


class CatalogueValue(Sourced):
    """A value of a track or a car."""

    name: str = Field(description="As in the study's `track` or `vehicle`; with a dot within `joint`.")
    value: float | str
    unit: str
    meaning: str
    basis: str = Field(description="Of what the value is: one rail, one axle, a whole car.")


class NamedSet(BaseModel):
    """A named track or car."""

    name: str
    title: str
    values: list[CatalogueValue]


class TrackList(BaseModel):
    """All tracks; the first is the default."""

    items: list[NamedSet]


class WheelTread(Sourced):
    """A wheel tread: the Hertz constant is `factor * R^exponent`, m/N^(2/3), of the wheel's radius R in m."""

    name: str
    title: str
    factor: float
    exponent: float


class VehicleList(BaseModel):
    """All cars, of which the first is the default, and wheel treads."""

    items: list[NamedSet]
    wheel_treads: list[WheelTread]


class FieldSource(Sourced):
    """Where a field of a spectrum was found."""

    name: str


class Interval(BaseModel):
    """From one value to another."""

    min: float
    max: float


class SpectrumInfo(BaseModel):
    """A named spectrum."""

    name: str
    title: str
    unit: str = Field(description="Of its density.")
    definition: dict[str, Any] = Field(description="The same as a spectrum of one's own, to be changed.")
    wavelength_range_m: Interval | None = Field(description="For which it was drawn up.")
    speed_range_kmh: Interval | None = Field(description="For which it was drawn up.")
    sources: list[FieldSource]


class SpectrumList(BaseModel):
    """All spectra; the first is the default."""

    items: list[SpectrumInfo]


class PresetInfo(BaseModel):
    """A ready-made study: its name may stand in place of a sweep."""

    name: str
    title: str
    description: str
    cases: int
    study: dict[str, Any] = Field(description="What `create_study` takes.")


class PresetList(BaseModel):
    """All presets."""

    items: list[PresetInfo]


class ParameterInfo(BaseModel):
    """A number of the model and its bounds; null where there is none."""

    path: str = Field(description="As in `vary`; with slashes for dots, its place in a study.")
    unit: str
    meaning: str
    integer: bool
    default: int | float | None = Field(description="Null where track or vehicle have a value of their own.")
    minimum: float | None
    exclusive_minimum: float | None
    maximum: float | None
    exclusive_maximum: float | None


class Limits(BaseModel):
    """How much can be asked for."""

    caller: CallerLimits
    max_cases_per_study: int
    max_page_size: int
    max_body_bytes: int
    max_profile_bytes: int
    max_profile_points: int
    max_labels: int
    max_irregularity_terms: int
    max_spectrum_points: int
    parameters: list[ParameterInfo]
