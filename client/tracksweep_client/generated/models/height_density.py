from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="HeightDensity")


@_attrs_define
class HeightDensity:
    """A one-sided power spectral density of heights, m^2/(1/m), at frequencies per metre of track.

    Attributes:
        frequencies_per_m (list[float]):
        densities_m3 (list[float]):
    """

    frequencies_per_m: list[float]
    densities_m3: list[float]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        frequencies_per_m = self.frequencies_per_m

        densities_m3 = self.densities_m3

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "frequencies_per_m": frequencies_per_m,
                "densities_m3": densities_m3,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        frequencies_per_m = cast(list[float], d.pop("frequencies_per_m"))

        densities_m3 = cast(list[float], d.pop("densities_m3"))

        height_density = cls(
            frequencies_per_m=frequencies_per_m,
            densities_m3=densities_m3,
        )

        height_density.additional_properties = d
        return height_density

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
