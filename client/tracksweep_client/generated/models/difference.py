from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="Difference")


@_attrs_define
class Difference:
    """One value less the baseline's.

    Attributes:
        at (Any): Value of the axis.
        value (float):
        absolute (float): Value less the baseline's, in the unit.
        relative (float | None): The same, per magnitude of the baseline's. Null if that is zero.
    """

    at: Any
    value: float
    absolute: float
    relative: float | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        at = self.at

        value = self.value

        absolute = self.absolute

        relative: float | None
        relative = self.relative

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "at": at,
                "value": value,
                "absolute": absolute,
                "relative": relative,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        at = d.pop("at")

        value = d.pop("value")

        absolute = d.pop("absolute")

        def _parse_relative(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        relative = _parse_relative(d.pop("relative"))

        difference = cls(
            at=at,
            value=value,
            absolute=absolute,
            relative=relative,
        )

        difference.additional_properties = d
        return difference

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
