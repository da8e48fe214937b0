"""Sweeps: many cases in few words, counted before they are expanded."""

import math
from abc import abstractmethod
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from itertools import product
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from app.boundary import Listed, Strict
from app.cases.irregularities import HarmonicWave, SingleDip, SmoothRail, SpectrumSample, StoredProfile, SumOf
from app.cases.schemas import Speed, make_case
from app.studies.sweep.axes import Axis, IrregularityAxes, SpeedAxis, SpeedRange, length, values
from app.studies.sweep.vary import Changes, Vary, varied
from solver.case import Case, Irregularity, Slab
from solver.quantity import InvalidParameterError
from solver.railhead import Profiles

__all__ = ["ContradictionError", "ListSweep", "ProductSweep", "SpeedRange", "Sweep", "ZipSweep"]

Loc = tuple[str, ...]


class ContradictionError(ValueError):
    """Values that are valid by themselves but not together.

    Parameters
    ----------
    pointer : str
        JSON Pointer, into the study, of the one to blame.
    detail : str
        What is wrong.
    """

    def __init__(self, pointer: str, detail: str) -> None:
        super().__init__(pointer, detail)
        self.pointer = pointer
        self.detail = detail


@contextmanager
def located(place: str, varied_paths: Collection[str] = ()) -> Iterator[None]:
    """Turn errors of the solver into errors of the study: what is not of the model is at a place in the sweep."""
    try:
        yield
    except InvalidParameterError as error:
        raise ContradictionError(_pointer(error.parameter, place, varied_paths), str(error)) from None
    except ArithmeticError:  # a bound that is to be exceeded is zero, and numbers can come very near to that
        raise ContradictionError(place, "The values are too many orders of magnitude apart to reckon with.") from None


def _pointer(parameter: str, place: str, varied_paths: Collection[str]) -> str:
    if parameter in varied_paths:
        return f"{place}/vary/{parameter}"
    root = parameter.partition(".")[0]
    path = parameter.replace(".", "/")
    if root in ("track", "vehicle", "numerics"):
        return f"/{path}"
    # Inside, the speed is in m/s and has another name.
    return f"{place}/{path}" if root in ("slab", "irregularity") else f"{place}/speed_kmh"


class _Axes(Strict):
    """Base of sweeps along axes."""

    speed_kmh: SpeedAxis
    slab: Listed[Slab] = ["continuous"]  # noqa: RUF012 - Pydantic copies it
    irregularity: IrregularityAxes
    vary: Vary = Field(default_factory=Vary)

    def axes(self) -> dict[Loc, Axis]:
        """Every axis by its place in the sweep; the last varies fastest."""
        axes: dict[Loc, Axis] = {("vary", path): listed for path, listed in self.vary.given().items()}
        axes |= {("speed_kmh",): self.speed_kmh, ("slab",): self.slab}
        return axes | {("irregularity", name): listed for name, listed in self.irregularity.axes().items()}

    @abstractmethod
    def rows(self) -> Iterable[tuple[Any, ...]]:
        """Values on all axes, for one condition after another."""

    def expand(self, parts: dict[str, Any], profiles: Profiles) -> Iterator[Case]:
        """Every case, in a fixed order.

        Parameters
        ----------
        parts : dict
            Track, vehicle and numerics.
        profiles : callable
            Positions and heights of a stored profile by its identifier.

        Raises
        ------
        ContradictionError
            If values that are valid by themselves are not together.
        """
        paths, names = list(self.vary.given()), list(self.irregularity.axes())

        @cache
        def irregularities(*chosen: Any) -> list[Irregularity]:
            return list(self.irregularity.chosen(dict(zip(names, chosen, strict=True)), profiles))

        @cache
        def model(*chosen: Any) -> dict[str, Any]:
            return varied(parts, dict(zip(paths, chosen, strict=True)))

        first = len(paths)
        with located("/sweep", paths):
            for row in self.rows():
                speed_kmh, slab = row[first : first + 2]
                for irregularity in irregularities(*row[first + 2 :]):
                    yield make_case(speed_kmh, slab, irregularity, model(*row[:first]))


class ProductSweep(_Axes):
    """Every value of each axis with every value of the others. An axis holds no value twice."""

    kind: Literal["product"]

    @model_validator(mode="after")
    def _distinct(self) -> "ProductSweep":
        errors = {}
        for loc, axis in self.axes().items():
            if not isinstance(axis, SpeedRange) and (twice := _first_twice(axis)) is not None:
                errors[loc] = PydanticCustomError("duplicate", "A value is listed twice: {value}", {"value": twice})
        _raise_if_any(errors, "product")
        return self

    def count(self) -> int:
        """How many cases there are."""
        return math.prod(map(length, self.axes().values())) * self.irregularity.repeats

    def rows(self) -> Iterable[tuple[Any, ...]]:
        """Every combination."""
        return product(*map(values, self.axes().values()))


class ZipSweep(_Axes):
    """First values with first values, second with second and so on. A single value stands for a whole axis; all
    other axes have one length. Of a spectrum, every condition is taken with every realisation.
    """

    kind: Literal["zip"]

    @model_validator(mode="after")
    def _of_one_length(self) -> "ZipSweep":
        lengths = {loc: n for loc, axis in self.axes().items() if (n := length(axis)) > 1}
        if len(set(lengths.values())) > 1:
            ((usual, _),) = Counter(lengths.values()).most_common(1)
            like = next(".".join(loc) for loc, n in lengths.items() if n == usual)
            errors = {
                loc: PydanticCustomError(
                    "length-differs",
                    "The axis has {count} values, where {like} has {usual}; zipped axes have one length, or one value",
                    {"count": n, "like": like, "usual": usual},
                )
                for loc, n in lengths.items()
                if n != usual
            }
            _raise_if_any(errors, "zip")
        return self

    def count(self) -> int:
        """How many cases there are."""
        return max(map(length, self.axes().values())) * self.irregularity.repeats

    def rows(self) -> Iterable[tuple[Any, ...]]:
        """Row after row."""
        longest = max(map(length, self.axes().values()))
        whole = (values(axis) if length(axis) > 1 else list(values(axis)) * longest for axis in self.axes().values())
        return zip(*whole, strict=True)


def _first_twice(listed: Iterable[Any]) -> str | None:
    seen: set[Any] = set()
    for value in listed:
        if value in seen:
            return str(value)
        seen.add(value)
    return None


def _raise_if_any(errors: Mapping[Loc, PydanticCustomError], title: str) -> None:
    if errors:
        details = [InitErrorDetails(type=error, loc=loc, input=None) for loc, error in errors.items()]
        raise ValidationError.from_exception_data(title, details)


class ListedCase(Strict):
    """One case of a list: single values."""

    speed_kmh: Speed
    slab: Slab = "continuous"
    irregularity: Annotated[
        SmoothRail | HarmonicWave | SpectrumSample | StoredProfile | SingleDip | SumOf, Field(discriminator="kind")
    ]
    vary: Changes = Field(default_factory=Changes)


class ListSweep(Strict):
    """Cases one by one."""

    kind: Literal["list"]
    cases: Listed[ListedCase]

    def count(self) -> int:
        """How many cases there are."""
        return len(self.cases)

    def expand(self, parts: dict[str, Any], profiles: Profiles) -> Iterator[Case]:
        """Every case in its order; see :meth:`ProductSweep.expand`."""
        for n, case in enumerate(self.cases):
            changes = case.vary.given()
            with located(f"/sweep/cases/{n}", changes):
                irregularity = case.irregularity.irregularity(profiles)
                yield make_case(case.speed_kmh, case.slab, irregularity, varied(parts, changes))


Sweep = ProductSweep | ZipSweep | ListSweep
