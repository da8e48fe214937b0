from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="Throughput")


@_attrs_define
class Throughput:
    """How many cases were computed lately, successfully or not; of the latest 10 000 cases.

    Attributes:
        last_minute (int):
        last_hour (int):
        cpu_s_last_hour (float): Processor time of those of the last hour, s.
    """

    last_minute: int
    last_hour: int
    cpu_s_last_hour: float
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        last_minute = self.last_minute

        last_hour = self.last_hour

        cpu_s_last_hour = self.cpu_s_last_hour

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "last_minute": last_minute,
                "last_hour": last_hour,
                "cpu_s_last_hour": cpu_s_last_hour,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        last_minute = d.pop("last_minute")

        last_hour = d.pop("last_hour")

        cpu_s_last_hour = d.pop("cpu_s_last_hour")

        throughput = cls(
            last_minute=last_minute,
            last_hour=last_hour,
            cpu_s_last_hour=cpu_s_last_hour,
        )

        throughput.additional_properties = d
        return throughput

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
