from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

T = TypeVar("T", bound="SingleDip")


@_attrs_define
class SingleDip:
    """One cosine dip, as at a weld; a bump if its depth is negative.

    Attributes:
        kind (Literal['dip']):
        position_m (float): Position of the middle, m.
        length_m (float): Length from end to end, m.
        depth_mm (float): Depth in the middle, mm.
    """

    kind: Literal["dip"]
    position_m: float
    length_m: float
    depth_mm: float

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        position_m = self.position_m

        length_m = self.length_m

        depth_mm = self.depth_mm

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "position_m": position_m,
                "length_m": length_m,
                "depth_mm": depth_mm,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["dip"], d.pop("kind"))
        if kind != "dip":
            raise ValueError(f"kind must match const 'dip', got '{kind}'")

        position_m = d.pop("position_m")

        length_m = d.pop("length_m")

        depth_mm = d.pop("depth_mm")

        single_dip = cls(
            kind=kind,
            position_m=position_m,
            length_m=length_m,
            depth_mm=depth_mm,
        )

        return single_dip
