from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..types import UNSET, Unset

T = TypeVar("T", bound="ParameterInfo")


@_attrs_define
class ParameterInfo:
    """A number of the model and its bounds; null where there is none.

    Attributes:
        path (str): As in `vary`; with slashes for dots, its place in a study.
        unit (str):
        meaning (str):
        integer (bool):
        minimum (float | None):
        exclusive_minimum (float | None):
        maximum (float | None):
        exclusive_maximum (float | None):
        default (float | int | None | Unset): Null where track or vehicle have a value of their own.
    """

    path: str
    unit: str
    meaning: str
    integer: bool
    minimum: float | None
    exclusive_minimum: float | None
    maximum: float | None
    exclusive_maximum: float | None
    default: float | int | None | Unset = UNSET
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        path = self.path

        unit = self.unit

        meaning = self.meaning

        integer = self.integer

        minimum: float | None
        minimum = self.minimum

        exclusive_minimum: float | None
        exclusive_minimum = self.exclusive_minimum

        maximum: float | None
        maximum = self.maximum

        exclusive_maximum: float | None
        exclusive_maximum = self.exclusive_maximum

        default: float | int | None | Unset
        if isinstance(self.default, Unset):
            default = UNSET
        else:
            default = self.default

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "path": path,
                "unit": unit,
                "meaning": meaning,
                "integer": integer,
                "minimum": minimum,
                "exclusive_minimum": exclusive_minimum,
                "maximum": maximum,
                "exclusive_maximum": exclusive_maximum,
            }
        )
        if default is not UNSET:
            field_dict["default"] = default

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        path = d.pop("path")

        unit = d.pop("unit")

        meaning = d.pop("meaning")

        integer = d.pop("integer")

        def _parse_minimum(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        minimum = _parse_minimum(d.pop("minimum"))

        def _parse_exclusive_minimum(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        exclusive_minimum = _parse_exclusive_minimum(d.pop("exclusive_minimum"))

        def _parse_maximum(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        maximum = _parse_maximum(d.pop("maximum"))

        def _parse_exclusive_maximum(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        exclusive_maximum = _parse_exclusive_maximum(d.pop("exclusive_maximum"))

        def _parse_default(data: object) -> float | int | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(float | int | None | Unset, data)

        default = _parse_default(d.pop("default", UNSET))

        parameter_info = cls(
            path=path,
            unit=unit,
            meaning=meaning,
            integer=integer,
            minimum=minimum,
            exclusive_minimum=exclusive_minimum,
            maximum=maximum,
            exclusive_maximum=exclusive_maximum,
            default=default,
        )

        parameter_info.additional_properties = d
        return parameter_info

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
