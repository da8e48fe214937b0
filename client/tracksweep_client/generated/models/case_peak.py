from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="CasePeak")


@_attrs_define
class CasePeak:
    """A peak of one case.

    Attributes:
        quantity (str):
        position (str):
        unit (str):
        peak (float): Largest magnitude; for wheel-rail and pad forces the maximum.
        maximum (float):
        minimum (float):
        mean (float):
        std (float):
        rms (float):
        time_s (float): When the peak occurs, s since the window began.
        track_position_m (float): Where the first wheelset is at that time, m.
    """

    quantity: str
    position: str
    unit: str
    peak: float
    maximum: float
    minimum: float
    mean: float
    std: float
    rms: float
    time_s: float
    track_position_m: float
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        quantity = self.quantity

        position = self.position

        unit = self.unit

        peak = self.peak

        maximum = self.maximum

        minimum = self.minimum

        mean = self.mean

        std = self.std

        rms = self.rms

        time_s = self.time_s

        track_position_m = self.track_position_m

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "peak": peak,
                "maximum": maximum,
                "minimum": minimum,
                "mean": mean,
                "std": std,
                "rms": rms,
                "time_s": time_s,
                "track_position_m": track_position_m,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        peak = d.pop("peak")

        maximum = d.pop("maximum")

        minimum = d.pop("minimum")

        mean = d.pop("mean")

        std = d.pop("std")

        rms = d.pop("rms")

        time_s = d.pop("time_s")

        track_position_m = d.pop("track_position_m")

        case_peak = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            peak=peak,
            maximum=maximum,
            minimum=minimum,
            mean=mean,
            std=std,
            rms=rms,
            time_s=time_s,
            track_position_m=track_position_m,
        )

        case_peak.additional_properties = d
        return case_peak

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
