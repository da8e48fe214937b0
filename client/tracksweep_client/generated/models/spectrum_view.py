from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="SpectrumView")


@_attrs_define
class SpectrumView:
    """The one-sided power spectral density of a channel, by Welch's method: Hann windows, overlapping by half.

    Attributes:
        quantity (str):
        position (str):
        unit (str): Of the channel.
        density_unit (str):
        resolution_hz (float):
        segments (int): Of how many the density is the mean.
        frequency_hz (list[float]):
        density (list[float]):
        pad_passing_hz (float): How often a wheel passes a pad.
        p2_hz (float): Where the unsprung wheel bounces on the track: the contact force over a small wave is largest, in
            linear theory, on a continuous track at rest.
    """

    quantity: str
    position: str
    unit: str
    density_unit: str
    resolution_hz: float
    segments: int
    frequency_hz: list[float]
    density: list[float]
    pad_passing_hz: float
    p2_hz: float
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        quantity = self.quantity

        position = self.position

        unit = self.unit

        density_unit = self.density_unit

        resolution_hz = self.resolution_hz

        segments = self.segments

        frequency_hz = self.frequency_hz

        density = self.density

        pad_passing_hz = self.pad_passing_hz

        p2_hz = self.p2_hz

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "density_unit": density_unit,
                "resolution_hz": resolution_hz,
                "segments": segments,
                "frequency_hz": frequency_hz,
                "density": density,
                "pad_passing_hz": pad_passing_hz,
                "p2_hz": p2_hz,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        density_unit = d.pop("density_unit")

        resolution_hz = d.pop("resolution_hz")

        segments = d.pop("segments")

        frequency_hz = cast(list[float], d.pop("frequency_hz"))

        density = cast(list[float], d.pop("density"))

        pad_passing_hz = d.pop("pad_passing_hz")

        p2_hz = d.pop("p2_hz")

        spectrum_view = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            density_unit=density_unit,
            resolution_hz=resolution_hz,
            segments=segments,
            frequency_hz=frequency_hz,
            density=density,
            pad_passing_hz=pad_passing_hz,
            p2_hz=p2_hz,
        )

        spectrum_view.additional_properties = d
        return spectrum_view

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
