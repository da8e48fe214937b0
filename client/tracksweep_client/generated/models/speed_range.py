from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

T = TypeVar("T", bound="SpeedRange")


@_attrs_define
class SpeedRange:
    """Evenly spaced speeds, km/h: ``start``, ``start + step`` and so on, not above ``stop``.

    Attributes:
        kind (Literal['range']):
        start (float): Speed of the train, km/h.
        stop (float): Speed of the train, km/h.
        step (float): Distance between speeds, km/h.
    """

    kind: Literal["range"]
    start: float
    stop: float
    step: float

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        start = self.start

        stop = self.stop

        step = self.step

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "start": start,
                "stop": stop,
                "step": step,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["range"], d.pop("kind"))
        if kind != "range":
            raise ValueError(f"kind must match const 'range', got '{kind}'")

        start = d.pop("start")

        stop = d.pop("stop")

        step = d.pop("step")

        speed_range = cls(
            kind=kind,
            start=start,
            stop=stop,
            step=step,
        )

        return speed_range
