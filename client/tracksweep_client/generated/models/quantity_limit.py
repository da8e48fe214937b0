from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.quantity_limit_mark import QuantityLimitMark, check_quantity_limit_mark

T = TypeVar("T", bound="QuantityLimit")


@_attrs_define
class QuantityLimit:
    """A value that a quantity should not exceed.

    Attributes:
        source (str):
        mark (QuantityLimitMark): How sure that is: V, read in the named source; C, in common use in the literature, its
            primary source not seen; A, assumed here.
        value (float): In the unit of the quantity.
        applies (str): To what, or when.
    """

    source: str
    mark: QuantityLimitMark
    value: float
    applies: str
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        source = self.source

        mark: str = self.mark

        value = self.value

        applies = self.applies

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "source": source,
                "mark": mark,
                "value": value,
                "applies": applies,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        source = d.pop("source")

        mark = check_quantity_limit_mark(d.pop("mark"))

        value = d.pop("value")

        applies = d.pop("applies")

        quantity_limit = cls(
            source=source,
            mark=mark,
            value=value,
            applies=applies,
        )

        quantity_limit.additional_properties = d
        return quantity_limit

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
