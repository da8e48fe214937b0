from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="ProfileInfo")


@_attrs_define
class ProfileInfo:
    """A stored profile.

    Attributes:
        id (str): Digest of the samples: the same samples have the same identifier.
        points (int):
        start_m (float): Position of the first sample.
        end_m (float): Position of the last sample.
        wavelength_min_m (float): Shortest wavelength that may be used of it: twice its widest gap.
        wavelength_max_m (float): Longest wavelength that may be used of it.
        lowest_mm (float): Smallest height; heights are positive downwards.
        highest_mm (float): Largest height.
        created_at (datetime.datetime):
    """

    id: str
    points: int
    start_m: float
    end_m: float
    wavelength_min_m: float
    wavelength_max_m: float
    lowest_mm: float
    highest_mm: float
    created_at: datetime.datetime
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        id = self.id

        points = self.points

        start_m = self.start_m

        end_m = self.end_m

        wavelength_min_m = self.wavelength_min_m

        wavelength_max_m = self.wavelength_max_m

        lowest_mm = self.lowest_mm

        highest_mm = self.highest_mm

        created_at = self.created_at.isoformat()

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "id": id,
                "points": points,
                "start_m": start_m,
                "end_m": end_m,
                "wavelength_min_m": wavelength_min_m,
                "wavelength_max_m": wavelength_max_m,
                "lowest_mm": lowest_mm,
                "highest_mm": highest_mm,
                "created_at": created_at,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        id = d.pop("id")

        points = d.pop("points")

        start_m = d.pop("start_m")

        end_m = d.pop("end_m")

        wavelength_min_m = d.pop("wavelength_min_m")

        wavelength_max_m = d.pop("wavelength_max_m")

        lowest_mm = d.pop("lowest_mm")

        highest_mm = d.pop("highest_mm")

        created_at = datetime.datetime.fromisoformat(d.pop("created_at"))

        profile_info = cls(
            id=id,
            points=points,
            start_m=start_m,
            end_m=end_m,
            wavelength_min_m=wavelength_min_m,
            wavelength_max_m=wavelength_max_m,
            lowest_mm=lowest_mm,
            highest_mm=highest_mm,
            created_at=created_at,
        )

        profile_info.additional_properties = d
        return profile_info

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
