from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.history_channel import HistoryChannel


T = TypeVar("T", bound="HistoryView")


@_attrs_define
class HistoryView:
    """A time history, or a part of it.

    Attributes:
        case_id (int):
        digest (str): SHA-256 of the stored file.
        samples (int): Stored samples per channel in the range of time.
        speed_kmh (float):
        track_position_start_m (float): Where the first wheelset is when the window begins, m.
        channels (list[HistoryChannel]):
    """

    case_id: int
    digest: str
    samples: int
    speed_kmh: float
    track_position_start_m: float
    channels: list[HistoryChannel]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        case_id = self.case_id

        digest = self.digest

        samples = self.samples

        speed_kmh = self.speed_kmh

        track_position_start_m = self.track_position_start_m

        channels = []
        for channels_item_data in self.channels:
            channels_item = channels_item_data.to_dict()
            channels.append(channels_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "case_id": case_id,
                "digest": digest,
                "samples": samples,
                "speed_kmh": speed_kmh,
                "track_position_start_m": track_position_start_m,
                "channels": channels,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.history_channel import HistoryChannel  # noqa: PLC0415

        d = dict(src_dict)
        case_id = d.pop("case_id")

        digest = d.pop("digest")

        samples = d.pop("samples")

        speed_kmh = d.pop("speed_kmh")

        track_position_start_m = d.pop("track_position_start_m")

        channels = []
        _channels = d.pop("channels")
        for channels_item_data in _channels:
            channels_item = HistoryChannel.from_dict(channels_item_data)

            channels.append(channels_item)

        history_view = cls(
            case_id=case_id,
            digest=digest,
            samples=samples,
            speed_kmh=speed_kmh,
            track_position_start_m=track_position_start_m,
            channels=channels,
        )

        history_view.additional_properties = d
        return history_view

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
