"""Pydantic models made from the solver's dataclasses: a field declared there appears at the boundary by itself."""

from dataclasses import MISSING, fields, is_dataclass, replace
from dataclasses import Field as DataclassField
from functools import cache
from typing import Annotated, Any, ClassVar, TypeVar, get_type_hints

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, create_model
from pydantic_core import PydanticKnownError

from solver.quantity import Quantity, quantities


class Strict(BaseModel):
    """Base of what clients send: unknown fields are refused, and numbers are numbers."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)


def counted(most: int) -> BeforeValidator:
    """Refuse a list that is too long before its items are looked at, each of which could be an error of its own."""

    def check(value: object) -> object:
        if isinstance(value, list) and len(value) > most:
            lengths = {"field_type": "List", "max_length": most, "actual_length": len(value)}
            raise PydanticKnownError("too_long", lengths)
        return value

    return BeforeValidator(check)


T = TypeVar("T")
MAX_LISTED = 20_000  # a body has not the space for many more
Listed = Annotated[list[T], Field(min_length=1, max_length=MAX_LISTED), counted(MAX_LISTED)]


def bounded(cls: type, name: str, scale: float = 1.0, unit: str | None = None) -> Any:
    """Bounds, unit and meaning of a dataclass's quantity, for ``Annotated``.

    Parameters
    ----------
    cls : type
        The dataclass.
    name : str
        Name of the quantity inside.
    scale : float
        Units at the boundary per unit inside (3.6 for km/h).
    unit : str, optional
        The unit at the boundary, if another than inside.
    """
    q = next(q for inside, _, q in quantities(cls) if inside == name)
    return described(q, scale, unit)


def described(q: Quantity, scale: float = 1.0, unit: str | None = None) -> Any:
    """The same of a quantity."""
    bounds = {bound: value if scale == 1 else round(value * scale, 9) for bound, value in q.bounds().items()}
    description = ", ".join(filter(None, [q.meaning[0].upper() + q.meaning[1:], unit or q.unit])) + "."
    ge, gt, le, lt = map(bounds.get, ("ge", "gt", "le", "lt"))
    return Field(description=description, ge=ge, gt=gt, le=le, lt=lt)


class Overrides(Strict):
    """Values that replace those of a named set, or of the defaults."""

    _of: ClassVar[type]

    def inside(self) -> dict[str, Any]:
        """The values given, by the names they have inside."""
        names = _boundary_names(self._of)
        given = {name: getattr(self, boundary) for name, boundary in names.items() if boundary in self.model_fields_set}
        return {name: v.inside() if isinstance(v, Overrides) else v for name, v in given.items()}


def apply(values: Any, changes: dict[str, Any]) -> Any:
    """A dataclass with some values replaced, nested ones too."""
    nested = {k: apply(getattr(values, k), v) for k, v in changes.items() if is_dataclass(getattr(values, k))}
    return replace(values, **changes | nested)


def overrides(name: str, cls: type, **more: Any) -> type[Overrides]:
    """A model with every field of a dataclass, all optional, under their names at the boundary.

    Parameters
    ----------
    name : str
        Name of the model.
    cls : type
        The dataclass.
    **more
        Further fields, as ``pydantic.create_model`` takes them.
    """
    hints, names = get_type_hints(cls), _boundary_names(cls)
    definitions: dict[str, Any] = more | {names[f.name]: _optional(cls, f, hints[f.name]) for f in fields(cls)}
    model = create_model(name, __base__=Overrides, __doc__=cls.__doc__, **definitions)
    model._of = cls
    return model


def at_boundary(cls: type, values: dict[str, Any]) -> dict[str, Any]:
    """Values of a dataclass, as its ``asdict`` gives them, under their names at the boundary."""
    hints, names = _hints(cls), _boundary_names(cls)
    return {names[k]: at_boundary(hints[k], v) if is_dataclass(hints[k]) else v for k, v in values.items()}


_hints = cache(get_type_hints)


@cache
def _boundary_names(cls: type) -> dict[str, str]:
    return {f.name: f.name for f in fields(cls)} | {inside: outside for inside, outside, _ in quantities(cls)}


def _optional(cls: type, field: DataclassField[Any], hint: Any) -> tuple[Any, Any]:
    if is_dataclass(hint):
        assert isinstance(hint, type)  # noqa: S101 - for the type checker: a hint is never an instance
        hint = overrides(f"{hint.__name__}Overrides", hint)
    elif "quantity" in field.metadata:
        hint = Annotated[hint, bounded(cls, field.name)]
    if field.default is not MISSING:
        return hint, Field(default=field.default)
    return hint, Field(default=None, json_schema_extra=without_default)


def without_default(schema: dict[str, Any]) -> None:
    """Leave out of the schema a default that only means `not given`."""
    schema.pop("default", None)
