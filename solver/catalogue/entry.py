"""A named set of values of which each says where it comes from."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, is_dataclass
from typing import Any, Generic, Literal, NamedTuple, TypeVar

# V: read in the named source. C: in common use in this literature, its primary source not seen. A: assumed here, for no
# published value was found.
Mark = Literal["V", "C", "A"]
T = TypeVar("T")


class Source(NamedTuple):
    """Where a value was found, and how sure we are of it."""

    text: str
    mark: Mark


@dataclass(frozen=True, kw_only=True)
class Entry(Generic[T]):
    """A named set of values with its provenance.

    Attributes
    ----------
    name, title : str
        Its name in a study, and for people.
    values : dataclass
        The values.
    provenance : mapping of str to Source
        Source of every value, by dotted name (``joint.shear_stiffness``).
    basis : mapping of str to str
        Of what every value is: one rail, a whole car, an axle …
    """

    name: str
    title: str
    values: T
    provenance: Mapping[str, Source]
    basis: Mapping[str, str]


def value_names(values: Any, prefix: str = "") -> list[str]:
    """Dotted names of all values of a dataclass, those of nested ones too."""
    names: list[str] = []
    for field in fields(values):
        value = getattr(values, field.name)
        names += value_names(value, f"{field.name}.") if is_dataclass(value) else [prefix + field.name]
    return names


def of_every_value(values: Any, default: T, exceptions: Mapping[str, T]) -> dict[str, T]:
    """One thing for every value of a dataclass, except for some.

    Parameters
    ----------
    exceptions : mapping
        By dotted name, or by its beginning (``joint`` for all of the joint).
    """
    return {name: exceptions.get(name, exceptions.get(name.partition(".")[0], default)) for name in value_names(values)}


def by_name(*entries: Entry[T]) -> dict[str, Entry[T]]:
    """A catalogue."""
    return {entry.name: entry for entry in entries}
