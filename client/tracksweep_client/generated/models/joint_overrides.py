from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="JointOverrides")


@_attrs_define
class JointOverrides:
    """The joints between slabs: no moment passes, shear only through a spring and a damper.

    Pads stand at whole multiples of their spacing along the track, joints at ``(position + i pads_per_slab)`` spacings.

        Attributes:
            shear_stiffness_n_per_m (float | Unset): Stiffness against a jump between slabs, N/m. Default: 100000000.0.
            shear_damping_ns_per_m (float | Unset): Damping of a jump between slabs, N s/m. Default: 80000.0.
            pads_per_slab (int | Unset): Pads on every slab. Default: 10.
            position (float | Unset): Place of a joint between two pads, as part of their spacing. Default: 0.5.
    """

    shear_stiffness_n_per_m: float | Unset = 100000000.0
    shear_damping_ns_per_m: float | Unset = 80000.0
    pads_per_slab: int | Unset = 10
    position: float | Unset = 0.5

    def to_dict(self) -> dict[str, Any]:
        shear_stiffness_n_per_m = self.shear_stiffness_n_per_m

        shear_damping_ns_per_m = self.shear_damping_ns_per_m

        pads_per_slab = self.pads_per_slab

        position = self.position

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if shear_stiffness_n_per_m is not UNSET:
            field_dict["shear_stiffness_n_per_m"] = shear_stiffness_n_per_m
        if shear_damping_ns_per_m is not UNSET:
            field_dict["shear_damping_ns_per_m"] = shear_damping_ns_per_m
        if pads_per_slab is not UNSET:
            field_dict["pads_per_slab"] = pads_per_slab
        if position is not UNSET:
            field_dict["position"] = position

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        shear_stiffness_n_per_m = d.pop("shear_stiffness_n_per_m", UNSET)

        shear_damping_ns_per_m = d.pop("shear_damping_ns_per_m", UNSET)

        pads_per_slab = d.pop("pads_per_slab", UNSET)

        position = d.pop("position", UNSET)

        joint_overrides = cls(
            shear_stiffness_n_per_m=shear_stiffness_n_per_m,
            shear_damping_ns_per_m=shear_damping_ns_per_m,
            pads_per_slab=pads_per_slab,
            position=position,
        )

        return joint_overrides
