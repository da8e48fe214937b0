"""Parameters of track, vehicle and numerics that a sweep may vary, each by its dotted path at the boundary."""

from collections.abc import Iterator, Mapping
from dataclasses import MISSING, dataclass, fields, is_dataclass
from difflib import get_close_matches
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, TypeAlias, get_type_hints

from pydantic import ConfigDict, Field, ValidationError, create_model, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from app.boundary import Listed, Strict, apply, described, without_default
from solver.case import Numerics, Track, Vehicle
from solver.quantity import Quantity, quantities


@dataclass(frozen=True, kw_only=True)
class Parameter:
    """A number of the model.

    Attributes
    ----------
    path : str
        Its name at the boundary, as in ``track.joint.shear_stiffness_n_per_m``.
    inside : tuple of str
        Its name inside, part by part.
    type : type
        int or float.
    quantity : Quantity
        Unit, bounds and meaning.
    default : int or float, optional
        Its value where neither study nor catalogue give one.
    """

    path: str
    inside: tuple[str, ...]
    type: type
    quantity: Quantity
    default: float | None


def _parameters(cls: type, *inside: str) -> Iterator[Parameter]:
    hints, known = get_type_hints(cls), {name: (outside, q) for name, outside, q in quantities(cls)}
    for field in fields(cls):
        hint, here = hints[field.name], (*inside, field.name)
        if is_dataclass(hint) and isinstance(hint, type):
            yield from _parameters(hint, *here)
        elif field.name in known:
            outside, quantity = known[field.name]
            default = None if field.default is MISSING else field.default
            path = ".".join([*inside, outside])
            yield Parameter(path=path, inside=here, type=hint, quantity=quantity, default=default)


PARAMETERS = {
    parameter.path: parameter
    for name, cls in {"track": Track, "vehicle": Vehicle, "numerics": Numerics}.items()
    for parameter in _parameters(cls, name)
}


NAMED = 10  # unknown parameters that are told of at once


class _ByPath(Strict):
    """Base of what is given by dotted paths."""

    model_config = ConfigDict(serialize_by_alias=True)
    _near: ClassVar[bool]  # whether to look for the nearest of an unknown name, which takes a while

    @model_validator(mode="before")
    @classmethod
    def _known(cls, given: Any) -> Any:
        unknown = [path for path in given if path not in PARAMETERS] if isinstance(given, dict) else []
        if unknown:
            some = {path: _unknown(path, near=cls._near) for path in unknown[:NAMED]}
            errors = [InitErrorDetails(type=error, loc=(path,), input=given[path]) for path, error in some.items()]
            raise ValidationError.from_exception_data(cls.__name__, errors)
        return given

    def given(self) -> dict[str, Any]:
        """What was given, in the order of the model."""
        return {
            str(field.alias): getattr(self, name)
            for name, field in type(self).model_fields.items()
            if name in self.model_fields_set
        }


def _unknown(path: str, *, near: bool) -> PydanticCustomError:
    found = get_close_matches(path, PARAMETERS, n=3, cutoff=0.5) if near else []
    hint = f"the nearest are {', '.join(found)}" if found else "get_limits lists what there is"
    return PydanticCustomError("unknown-parameter", "There is no such parameter; {hint}.", {"hint": hint})


def _by_path(name: str, doc: str, *, listed: bool) -> Any:
    definitions: dict[str, Any] = {}
    for parameter in PARAMETERS.values():
        number = Annotated[parameter.type, described(parameter.quantity)]  # type: ignore[name-defined]  # made here
        hint = Listed[number] if listed else number
        default = Field(default=None, alias=parameter.path, json_schema_extra=without_default)
        definitions[parameter.path.replace(".", "__")] = (hint, default)
    model = create_model(name, __base__=_ByPath, __doc__=doc, **definitions)
    model._near = listed  # single values come in lists of thousands of cases
    return model


if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know
    Vary: TypeAlias = _ByPath
    Changes: TypeAlias = _ByPath
else:
    Vary = _by_path("Vary", "Lists of values of parameters; each replaces what the study says of it.", listed=True)
    Changes = _by_path("Changes", "Values of parameters; each replaces what the study says of it.", listed=False)


def varied(parts: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Track, vehicle and numerics with some values replaced, all at once.

    Raises
    ------
    InvalidParameterError
        If values contradict each other.
    """
    tree: dict[str, Any] = {}
    for path, value in changes.items():
        *parents, name = PARAMETERS[path].inside
        node = tree
        for parent in parents:
            node = node.setdefault(parent, {})
        node[name] = value
    return {**parts, **{part: apply(parts[part], changed) for part, changed in tree.items()}}
