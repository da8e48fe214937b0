"""Physical fields of frozen dataclasses: unit, bounds and meaning declared once, checked on construction."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, fields
from typing import Any

# What a unit is called inside a name at the boundary: pad_stiffness [N/m] is pad_stiffness_n_per_m.
UNIT_SUFFIX = {
    "m": "m",
    "m^4": "m4",
    "s": "s",
    "m/s": "m_per_s",
    "kg": "kg",
    "kg/m": "kg_per_m",
    "kg m^2": "kg_m2",
    "Pa": "pa",
    "N/m": "n_per_m",
    "N s/m": "ns_per_m",
    "N/m^2": "n_per_m2",
    "N s/m^2": "ns_per_m2",
    "%": "",
    "": "",
}


class InvalidParameterError(ValueError):
    """A parameter outside its bounds.

    Parameters
    ----------
    parameter : str
        Dotted path of the parameter, as at the boundary (``numerics.track_length_m``).
    problem : str
        What is wrong, with the bound.
    """

    def __init__(self, parameter: str, problem: str) -> None:
        super().__init__(parameter, problem)
        self.parameter = parameter
        self.problem = problem

    def __str__(self) -> str:
        return f"{self.parameter} {self.problem}"


@dataclass(frozen=True)
class Quantity:
    """Unit, bounds and meaning of one numeric field."""

    unit: str
    meaning: str
    ge: float | None = None
    gt: float | None = None
    le: float | None = None
    lt: float | None = None

    def bounds(self) -> dict[str, float]:
        """The bounds that are set, by the names Pydantic gives them too."""
        all_bounds = {"ge": self.ge, "gt": self.gt, "le": self.le, "lt": self.lt}
        return {name: bound for name, bound in all_bounds.items() if bound is not None}

    def problem(self, value: float) -> str | None:
        """What is wrong with a value, or None."""
        if not math.isfinite(value):
            return f"must be a finite number, is {value}"
        checks = {
            "ge": (self.ge is None or value >= self.ge, "at least"),
            "gt": (self.gt is None or value > self.gt, "greater than"),
            "le": (self.le is None or value <= self.le, "at most"),
            "lt": (self.lt is None or value < self.lt, "less than"),
        }
        for name, (holds, words) in checks.items():
            if not holds:
                return f"must be {words} {getattr(self, name):g}{f' {self.unit}' * bool(self.unit)}, is {value:g}"
        return None


def quantity(unit: str, meaning: str, **bounds: float) -> Any:
    """A dataclass field with unit, meaning and bounds; ``default=`` gives it a default."""
    metadata = {"quantity": Quantity(unit, meaning, **{k: v for k, v in bounds.items() if k != "default"})}
    if "default" in bounds:
        return field(default=bounds["default"], metadata=metadata)
    return field(metadata=metadata)


def quantities(cls: type) -> Iterator[tuple[str, str, Quantity]]:
    """Name inside, name at the boundary and quantity of every physical field of a dataclass."""
    for f in fields(cls):
        if (q := f.metadata.get("quantity")) is not None:
            suffix = UNIT_SUFFIX[q.unit]
            yield f.name, f"{f.name}_{suffix}" if suffix else f.name, q


def floats(
    parameter: str, values: Iterable[float], low: float, high: float, least: int, most: int
) -> tuple[float, ...]:
    """A tuple of ``least`` to ``most`` floats, none below ``low`` or above ``high``.

    Raises
    ------
    InvalidParameterError
        If they are anything else.
    """
    given = tuple(values)
    if not least <= len(given) <= most:
        count = f"{least}" if least == most else f"{least} to {most}"
        raise InvalidParameterError(parameter, f"must be {count} numbers, are {len(given)}")
    bounds = Quantity("", "", ge=low, le=high)
    for n, value in enumerate(given):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise InvalidParameterError(f"{parameter}.{n}", f"must be a number, is {value!r}")
        if not low <= value <= high:  # false for what is not a number
            raise InvalidParameterError(f"{parameter}.{n}", bounds.problem(value) or "")
    return tuple(map(float, given))


class Checked:
    """Base of the physical dataclasses: numbers get their declared type and must meet their bounds.

    Construction raises :class:`InvalidParameterError` where they do not.
    """

    __slots__ = ()
    _path = ""

    def __post_init__(self) -> None:
        cls: type = type(self)
        types = {f.name: f.type for f in fields(cls)}
        for name, boundary_name, q in quantities(cls):
            value = getattr(self, name)
            path = f"{self._path}{boundary_name}"
            if isinstance(value, bool) or not isinstance(value, (int, float)):
                raise InvalidParameterError(path, f"must be a number, is {value!r}")
            if (problem := q.problem(value)) is not None:
                raise InvalidParameterError(path, problem)
            if types[name] is float:  # 1 and 1.0 must give one digest
                object.__setattr__(self, name, float(value))
