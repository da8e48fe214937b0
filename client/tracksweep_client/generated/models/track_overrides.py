from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..models.track_overrides_base import TrackOverridesBase, check_track_overrides_base
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.joint_overrides import JointOverrides


T = TypeVar("T", bound="TrackOverrides")


@_attrs_define
class TrackOverrides:
    """Rail, slab and concrete base on a roadbed. Values are of one rail and half the slab and base.

    Attributes:
        base (TrackOverridesBase | Unset):  Default: 'crts2'.
        rail_elastic_modulus_pa (float | Unset): Young's modulus of the rail, Pa.
        rail_second_moment_m4 (float | Unset): Second moment of area of the rail, m^4.
        rail_mass_kg_per_m (float | Unset): Rail mass per length, kg/m.
        pad_stiffness_n_per_m (float | Unset): Stiffness of one rail pad with its fastening, N/m.
        pad_damping_ns_per_m (float | Unset): Damping of one rail pad with its fastening, N s/m.
        pad_spacing_m (float | Unset): Distance between pads, m.
        slab_elastic_modulus_pa (float | Unset): Young's modulus of the slab, Pa.
        slab_second_moment_m4 (float | Unset): Second moment of area of the half slab, m^4.
        slab_mass_kg_per_m (float | Unset): Mass of the half slab per length, kg/m.
        mortar_stiffness_n_per_m2 (float | Unset): Stiffness of the CA mortar per length, N/m^2.
        mortar_damping_ns_per_m2 (float | Unset): Damping of the CA mortar per length, N s/m^2.
        base_elastic_modulus_pa (float | Unset): Young's modulus of the concrete base, Pa.
        base_second_moment_m4 (float | Unset): Second moment of area of the half base, m^4.
        base_mass_kg_per_m (float | Unset): Mass of the half base per length, kg/m.
        roadbed_stiffness_n_per_m2 (float | Unset): Stiffness of the roadbed per length, N/m^2.
        roadbed_damping_ns_per_m2 (float | Unset): Damping of the roadbed per length, N s/m^2.
        joint (JointOverrides | Unset): The joints between slabs: no moment passes, shear only through a spring and a
            damper.

            Pads stand at whole multiples of their spacing along the track, joints at ``(position + i pads_per_slab)``
            spacings.
    """

    base: TrackOverridesBase | Unset = "crts2"
    rail_elastic_modulus_pa: float | Unset = UNSET
    rail_second_moment_m4: float | Unset = UNSET
    rail_mass_kg_per_m: float | Unset = UNSET
    pad_stiffness_n_per_m: float | Unset = UNSET
    pad_damping_ns_per_m: float | Unset = UNSET
    pad_spacing_m: float | Unset = UNSET
    slab_elastic_modulus_pa: float | Unset = UNSET
    slab_second_moment_m4: float | Unset = UNSET
    slab_mass_kg_per_m: float | Unset = UNSET
    mortar_stiffness_n_per_m2: float | Unset = UNSET
    mortar_damping_ns_per_m2: float | Unset = UNSET
    base_elastic_modulus_pa: float | Unset = UNSET
    base_second_moment_m4: float | Unset = UNSET
    base_mass_kg_per_m: float | Unset = UNSET
    roadbed_stiffness_n_per_m2: float | Unset = UNSET
    roadbed_damping_ns_per_m2: float | Unset = UNSET
    joint: JointOverrides | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        base: str | Unset = UNSET
        if not isinstance(self.base, Unset):
            base = self.base

        rail_elastic_modulus_pa = self.rail_elastic_modulus_pa

        rail_second_moment_m4 = self.rail_second_moment_m4

        rail_mass_kg_per_m = self.rail_mass_kg_per_m

        pad_stiffness_n_per_m = self.pad_stiffness_n_per_m

        pad_damping_ns_per_m = self.pad_damping_ns_per_m

        pad_spacing_m = self.pad_spacing_m

        slab_elastic_modulus_pa = self.slab_elastic_modulus_pa

        slab_second_moment_m4 = self.slab_second_moment_m4

        slab_mass_kg_per_m = self.slab_mass_kg_per_m

        mortar_stiffness_n_per_m2 = self.mortar_stiffness_n_per_m2

        mortar_damping_ns_per_m2 = self.mortar_damping_ns_per_m2

        base_elastic_modulus_pa = self.base_elastic_modulus_pa

        base_second_moment_m4 = self.base_second_moment_m4

        base_mass_kg_per_m = self.base_mass_kg_per_m

        roadbed_stiffness_n_per_m2 = self.roadbed_stiffness_n_per_m2

        roadbed_damping_ns_per_m2 = self.roadbed_damping_ns_per_m2

        joint: dict[str, Any] | Unset = UNSET
        if not isinstance(self.joint, Unset):
            joint = self.joint.to_dict()

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if base is not UNSET:
            field_dict["base"] = base
        if rail_elastic_modulus_pa is not UNSET:
            field_dict["rail_elastic_modulus_pa"] = rail_elastic_modulus_pa
        if rail_second_moment_m4 is not UNSET:
            field_dict["rail_second_moment_m4"] = rail_second_moment_m4
        if rail_mass_kg_per_m is not UNSET:
            field_dict["rail_mass_kg_per_m"] = rail_mass_kg_per_m
        if pad_stiffness_n_per_m is not UNSET:
            field_dict["pad_stiffness_n_per_m"] = pad_stiffness_n_per_m
        if pad_damping_ns_per_m is not UNSET:
            field_dict["pad_damping_ns_per_m"] = pad_damping_ns_per_m
        if pad_spacing_m is not UNSET:
            field_dict["pad_spacing_m"] = pad_spacing_m
        if slab_elastic_modulus_pa is not UNSET:
            field_dict["slab_elastic_modulus_pa"] = slab_elastic_modulus_pa
        if slab_second_moment_m4 is not UNSET:
            field_dict["slab_second_moment_m4"] = slab_second_moment_m4
        if slab_mass_kg_per_m is not UNSET:
            field_dict["slab_mass_kg_per_m"] = slab_mass_kg_per_m
        if mortar_stiffness_n_per_m2 is not UNSET:
            field_dict["mortar_stiffness_n_per_m2"] = mortar_stiffness_n_per_m2
        if mortar_damping_ns_per_m2 is not UNSET:
            field_dict["mortar_damping_ns_per_m2"] = mortar_damping_ns_per_m2
        if base_elastic_modulus_pa is not UNSET:
            field_dict["base_elastic_modulus_pa"] = base_elastic_modulus_pa
        if base_second_moment_m4 is not UNSET:
            field_dict["base_second_moment_m4"] = base_second_moment_m4
        if base_mass_kg_per_m is not UNSET:
            field_dict["base_mass_kg_per_m"] = base_mass_kg_per_m
        if roadbed_stiffness_n_per_m2 is not UNSET:
            field_dict["roadbed_stiffness_n_per_m2"] = roadbed_stiffness_n_per_m2
        if roadbed_damping_ns_per_m2 is not UNSET:
            field_dict["roadbed_damping_ns_per_m2"] = roadbed_damping_ns_per_m2
        if joint is not UNSET:
            field_dict["joint"] = joint

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.joint_overrides import JointOverrides  # noqa: PLC0415

        d = dict(src_dict)
        _base = d.pop("base", UNSET)
        base: TrackOverridesBase | Unset
        if isinstance(_base, Unset):
            base = UNSET
        else:
            base = check_track_overrides_base(_base)

        rail_elastic_modulus_pa = d.pop("rail_elastic_modulus_pa", UNSET)

        rail_second_moment_m4 = d.pop("rail_second_moment_m4", UNSET)

        rail_mass_kg_per_m = d.pop("rail_mass_kg_per_m", UNSET)

        pad_stiffness_n_per_m = d.pop("pad_stiffness_n_per_m", UNSET)

        pad_damping_ns_per_m = d.pop("pad_damping_ns_per_m", UNSET)

        pad_spacing_m = d.pop("pad_spacing_m", UNSET)

        slab_elastic_modulus_pa = d.pop("slab_elastic_modulus_pa", UNSET)

        slab_second_moment_m4 = d.pop("slab_second_moment_m4", UNSET)

        slab_mass_kg_per_m = d.pop("slab_mass_kg_per_m", UNSET)

        mortar_stiffness_n_per_m2 = d.pop("mortar_stiffness_n_per_m2", UNSET)

        mortar_damping_ns_per_m2 = d.pop("mortar_damping_ns_per_m2", UNSET)

        base_elastic_modulus_pa = d.pop("base_elastic_modulus_pa", UNSET)

        base_second_moment_m4 = d.pop("base_second_moment_m4", UNSET)

        base_mass_kg_per_m = d.pop("base_mass_kg_per_m", UNSET)

        roadbed_stiffness_n_per_m2 = d.pop("roadbed_stiffness_n_per_m2", UNSET)

        roadbed_damping_ns_per_m2 = d.pop("roadbed_damping_ns_per_m2", UNSET)

        _joint = d.pop("joint", UNSET)
        joint: JointOverrides | Unset
        if isinstance(_joint, Unset):
            joint = UNSET
        else:
            joint = JointOverrides.from_dict(_joint)

        track_overrides = cls(
            base=base,
            rail_elastic_modulus_pa=rail_elastic_modulus_pa,
            rail_second_moment_m4=rail_second_moment_m4,
            rail_mass_kg_per_m=rail_mass_kg_per_m,
            pad_stiffness_n_per_m=pad_stiffness_n_per_m,
            pad_damping_ns_per_m=pad_damping_ns_per_m,
            pad_spacing_m=pad_spacing_m,
            slab_elastic_modulus_pa=slab_elastic_modulus_pa,
            slab_second_moment_m4=slab_second_moment_m4,
            slab_mass_kg_per_m=slab_mass_kg_per_m,
            mortar_stiffness_n_per_m2=mortar_stiffness_n_per_m2,
            mortar_damping_ns_per_m2=mortar_damping_ns_per_m2,
            base_elastic_modulus_pa=base_elastic_modulus_pa,
            base_second_moment_m4=base_second_moment_m4,
            base_mass_kg_per_m=base_mass_kg_per_m,
            roadbed_stiffness_n_per_m2=roadbed_stiffness_n_per_m2,
            roadbed_damping_ns_per_m2=roadbed_damping_ns_per_m2,
            joint=joint,
        )

        return track_overrides
