from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.field_source_mark import FieldSourceMark, check_field_source_mark

T = TypeVar("T", bound="FieldSource")


@_attrs_define
class FieldSource:
    """Where a field of a spectrum was found.

    Attributes:
        source (str):
        mark (FieldSourceMark): How sure that is: V, read in the named source; C, in common use in the literature, its
            primary source not seen; A, assumed here.
        name (str):
    """

    source: str
    mark: FieldSourceMark
    name: str
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        source = self.source

        mark: str = self.mark

        name = self.name

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "source": source,
                "mark": mark,
                "name": name,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        source = d.pop("source")

        mark = check_field_source_mark(d.pop("mark"))

        name = d.pop("name")

        field_source = cls(
            source=source,
            mark=mark,
            name=name,
        )

        field_source.additional_properties = d
        return field_source

    @property
    def additional_keys(self) -> list[str]:
        return list(self.additional_properties.keys())

    def __getitem__(self, key: str) -> Any:
        return self.additional_properties[key]

    def __setitem__(self, key: str, value: Any) -> None:
        self.additional_properties[key] = value

    def __delitem__(self, key: str) -> None:
        del self.additional_properties[key]

    def __contains__(self, key: str) -> bool:
        return key in self.additional_properties
