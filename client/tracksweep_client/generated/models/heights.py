from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="Heights")


@_attrs_define
class Heights:
    """Heights along the track, positive downwards.

    Attributes:
        positions_m (list[float]):
        heights_mm (list[float]):
    """

    positions_m: list[float]
    heights_mm: list[float]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        positions_m = self.positions_m

        heights_mm = self.heights_mm

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "positions_m": positions_m,
                "heights_mm": heights_mm,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        positions_m = cast(list[float], d.pop("positions_m"))

        heights_mm = cast(list[float], d.pop("heights_mm"))

        heights = cls(
            positions_m=positions_m,
            heights_mm=heights_mm,
        )

        heights.additional_properties = d
        return heights

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
