from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="RunningCase")


@_attrs_define
class RunningCase:
    """A case that a worker computes.

    Attributes:
        id (int):
        speed_kmh (float):
        slab (str):
        irregularity (str):
        progress (float): Fraction done, 0 to 1.
        attempt (int):
        started_at (datetime.datetime | None):
    """

    id: int
    speed_kmh: float
    slab: str
    irregularity: str
    progress: float
    attempt: int
    started_at: datetime.datetime | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        id = self.id

        speed_kmh = self.speed_kmh

        slab = self.slab

        irregularity = self.irregularity

        progress = self.progress

        attempt = self.attempt

        started_at: None | str
        if isinstance(self.started_at, datetime.datetime):
            started_at = self.started_at.isoformat()
        else:
            started_at = self.started_at

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "id": id,
                "speed_kmh": speed_kmh,
                "slab": slab,
                "irregularity": irregularity,
                "progress": progress,
                "attempt": attempt,
                "started_at": started_at,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        id = d.pop("id")

        speed_kmh = d.pop("speed_kmh")

        slab = d.pop("slab")

        irregularity = d.pop("irregularity")

        progress = d.pop("progress")

        attempt = d.pop("attempt")

        def _parse_started_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                started_at_type_0 = datetime.datetime.fromisoformat(data)

                return started_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        started_at = _parse_started_at(d.pop("started_at"))

        running_case = cls(
            id=id,
            speed_kmh=speed_kmh,
            slab=slab,
            irregularity=irregularity,
            progress=progress,
            attempt=attempt,
            started_at=started_at,
        )

        running_case.additional_properties = d
        return running_case

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
