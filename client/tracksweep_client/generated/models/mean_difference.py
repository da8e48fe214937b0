from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="MeanDifference")


@_attrs_define
class MeanDifference:
    """Differences averaged over all groups that have both values.

    Attributes:
        quantity (str):
        position (str):
        unit (str):
        at (Any): Value of the axis.
        groups (int):
        absolute (float):
        absolute_std (float | None): Standard deviation over the groups. Null for less than two.
        relative (float | None): Mean of the groups' relative differences. Null if one has none.
    """

    quantity: str
    position: str
    unit: str
    at: Any
    groups: int
    absolute: float
    absolute_std: float | None
    relative: float | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        quantity = self.quantity

        position = self.position

        unit = self.unit

        at = self.at

        groups = self.groups

        absolute = self.absolute

        absolute_std: float | None
        absolute_std = self.absolute_std

        relative: float | None
        relative = self.relative

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "at": at,
                "groups": groups,
                "absolute": absolute,
                "absolute_std": absolute_std,
                "relative": relative,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        at = d.pop("at")

        groups = d.pop("groups")

        absolute = d.pop("absolute")

        def _parse_absolute_std(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        absolute_std = _parse_absolute_std(d.pop("absolute_std"))

        def _parse_relative(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        relative = _parse_relative(d.pop("relative"))

        mean_difference = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            at=at,
            groups=groups,
            absolute=absolute,
            absolute_std=absolute_std,
            relative=relative,
        )

        mean_difference.additional_properties = d
        return mean_difference

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
