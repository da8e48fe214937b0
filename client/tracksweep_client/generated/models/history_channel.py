from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="HistoryChannel")


@_attrs_define
class HistoryChannel:
    """Samples of one quantity at one position, in ``unit``.

    Attributes:
        quantity (str):
        position (str):
        unit (str):
        time_s (list[float]): When, s since the window began.
        values (list[float]): The samples at these times.
    """

    quantity: str
    position: str
    unit: str
    time_s: list[float]
    values: list[float]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        quantity = self.quantity

        position = self.position

        unit = self.unit

        time_s = self.time_s

        values = self.values

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "time_s": time_s,
                "values": values,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        time_s = cast(list[float], d.pop("time_s"))

        values = cast(list[float], d.pop("values"))

        history_channel = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            time_s=time_s,
            values=values,
        )

        history_channel.additional_properties = d
        return history_channel

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
