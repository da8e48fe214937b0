from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="Vary")


@_attrs_define
class Vary:
    """Lists of values of parameters; each replaces what the study says of it.

    Attributes:
        track_rail_elastic_modulus_pa (list[float] | Unset):
        track_rail_second_moment_m4 (list[float] | Unset):
        track_rail_mass_kg_per_m (list[float] | Unset):
        track_pad_stiffness_n_per_m (list[float] | Unset):
        track_pad_damping_ns_per_m (list[float] | Unset):
        track_pad_spacing_m (list[float] | Unset):
        track_slab_elastic_modulus_pa (list[float] | Unset):
        track_slab_second_moment_m4 (list[float] | Unset):
        track_slab_mass_kg_per_m (list[float] | Unset):
        track_mortar_stiffness_n_per_m2 (list[float] | Unset):
        track_mortar_damping_ns_per_m2 (list[float] | Unset):
        track_base_elastic_modulus_pa (list[float] | Unset):
        track_base_second_moment_m4 (list[float] | Unset):
        track_base_mass_kg_per_m (list[float] | Unset):
        track_roadbed_stiffness_n_per_m2 (list[float] | Unset):
        track_roadbed_damping_ns_per_m2 (list[float] | Unset):
        track_joint_shear_stiffness_n_per_m (list[float] | Unset):
        track_joint_shear_damping_ns_per_m (list[float] | Unset):
        track_joint_pads_per_slab (list[int] | Unset):
        track_joint_position (list[float] | Unset):
        vehicle_car_body_mass_kg (list[float] | Unset):
        vehicle_car_body_pitch_inertia_kg_m2 (list[float] | Unset):
        vehicle_bogie_mass_kg (list[float] | Unset):
        vehicle_bogie_pitch_inertia_kg_m2 (list[float] | Unset):
        vehicle_wheelset_mass_kg (list[float] | Unset):
        vehicle_primary_stiffness_n_per_m (list[float] | Unset):
        vehicle_primary_damping_ns_per_m (list[float] | Unset):
        vehicle_secondary_stiffness_n_per_m (list[float] | Unset):
        vehicle_secondary_damping_ns_per_m (list[float] | Unset):
        vehicle_half_bogie_distance_m (list[float] | Unset):
        vehicle_half_wheelbase_m (list[float] | Unset):
        vehicle_wheel_radius_m (list[float] | Unset):
        numerics_track_length_m (list[float] | Unset):
        numerics_elements_per_pad (list[int] | Unset):
        numerics_mesh_offset (list[float] | Unset):
        numerics_time_step_s (list[float] | Unset):
        numerics_start_m (list[float] | Unset):
        numerics_settle_s (list[float] | Unset):
        numerics_window_s (list[float] | Unset):
        numerics_ease_in_s (list[float] | Unset):
        numerics_spectral_radius (list[float] | Unset):
        numerics_absorbing_length_m (list[float] | Unset):
        numerics_absorbing_damping_ns_per_m2 (list[float] | Unset):
        numerics_joint_blending (list[float] | Unset):
    """

    track_rail_elastic_modulus_pa: list[float] | Unset = UNSET
    track_rail_second_moment_m4: list[float] | Unset = UNSET
    track_rail_mass_kg_per_m: list[float] | Unset = UNSET
    track_pad_stiffness_n_per_m: list[float] | Unset = UNSET
    track_pad_damping_ns_per_m: list[float] | Unset = UNSET
    track_pad_spacing_m: list[float] | Unset = UNSET
    track_slab_elastic_modulus_pa: list[float] | Unset = UNSET
    track_slab_second_moment_m4: list[float] | Unset = UNSET
    track_slab_mass_kg_per_m: list[float] | Unset = UNSET
    track_mortar_stiffness_n_per_m2: list[float] | Unset = UNSET
    track_mortar_damping_ns_per_m2: list[float] | Unset = UNSET
    track_base_elastic_modulus_pa: list[float] | Unset = UNSET
    track_base_second_moment_m4: list[float] | Unset = UNSET
    track_base_mass_kg_per_m: list[float] | Unset = UNSET
    track_roadbed_stiffness_n_per_m2: list[float] | Unset = UNSET
    track_roadbed_damping_ns_per_m2: list[float] | Unset = UNSET
    track_joint_shear_stiffness_n_per_m: list[float] | Unset = UNSET
    track_joint_shear_damping_ns_per_m: list[float] | Unset = UNSET
    track_joint_pads_per_slab: list[int] | Unset = UNSET
    track_joint_position: list[float] | Unset = UNSET
    vehicle_car_body_mass_kg: list[float] | Unset = UNSET
    vehicle_car_body_pitch_inertia_kg_m2: list[float] | Unset = UNSET
    vehicle_bogie_mass_kg: list[float] | Unset = UNSET
    vehicle_bogie_pitch_inertia_kg_m2: list[float] | Unset = UNSET
    vehicle_wheelset_mass_kg: list[float] | Unset = UNSET
    vehicle_primary_stiffness_n_per_m: list[float] | Unset = UNSET
    vehicle_primary_damping_ns_per_m: list[float] | Unset = UNSET
    vehicle_secondary_stiffness_n_per_m: list[float] | Unset = UNSET
    vehicle_secondary_damping_ns_per_m: list[float] | Unset = UNSET
    vehicle_half_bogie_distance_m: list[float] | Unset = UNSET
    vehicle_half_wheelbase_m: list[float] | Unset = UNSET
    vehicle_wheel_radius_m: list[float] | Unset = UNSET
    numerics_track_length_m: list[float] | Unset = UNSET
    numerics_elements_per_pad: list[int] | Unset = UNSET
    numerics_mesh_offset: list[float] | Unset = UNSET
    numerics_time_step_s: list[float] | Unset = UNSET
    numerics_start_m: list[float] | Unset = UNSET
    numerics_settle_s: list[float] | Unset = UNSET
    numerics_window_s: list[float] | Unset = UNSET
    numerics_ease_in_s: list[float] | Unset = UNSET
    numerics_spectral_radius: list[float] | Unset = UNSET
    numerics_absorbing_length_m: list[float] | Unset = UNSET
    numerics_absorbing_damping_ns_per_m2: list[float] | Unset = UNSET
    numerics_joint_blending: list[float] | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        track_rail_elastic_modulus_pa: list[float] | Unset = UNSET
        if not isinstance(self.track_rail_elastic_modulus_pa, Unset):
            track_rail_elastic_modulus_pa = self.track_rail_elastic_modulus_pa

        track_rail_second_moment_m4: list[float] | Unset = UNSET
        if not isinstance(self.track_rail_second_moment_m4, Unset):
            track_rail_second_moment_m4 = self.track_rail_second_moment_m4

        track_rail_mass_kg_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_rail_mass_kg_per_m, Unset):
            track_rail_mass_kg_per_m = self.track_rail_mass_kg_per_m

        track_pad_stiffness_n_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_pad_stiffness_n_per_m, Unset):
            track_pad_stiffness_n_per_m = self.track_pad_stiffness_n_per_m

        track_pad_damping_ns_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_pad_damping_ns_per_m, Unset):
            track_pad_damping_ns_per_m = self.track_pad_damping_ns_per_m

        track_pad_spacing_m: list[float] | Unset = UNSET
        if not isinstance(self.track_pad_spacing_m, Unset):
            track_pad_spacing_m = self.track_pad_spacing_m

        track_slab_elastic_modulus_pa: list[float] | Unset = UNSET
        if not isinstance(self.track_slab_elastic_modulus_pa, Unset):
            track_slab_elastic_modulus_pa = self.track_slab_elastic_modulus_pa

        track_slab_second_moment_m4: list[float] | Unset = UNSET
        if not isinstance(self.track_slab_second_moment_m4, Unset):
            track_slab_second_moment_m4 = self.track_slab_second_moment_m4

        track_slab_mass_kg_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_slab_mass_kg_per_m, Unset):
            track_slab_mass_kg_per_m = self.track_slab_mass_kg_per_m

        track_mortar_stiffness_n_per_m2: list[float] | Unset = UNSET
        if not isinstance(self.track_mortar_stiffness_n_per_m2, Unset):
            track_mortar_stiffness_n_per_m2 = self.track_mortar_stiffness_n_per_m2

        track_mortar_damping_ns_per_m2: list[float] | Unset = UNSET
        if not isinstance(self.track_mortar_damping_ns_per_m2, Unset):
            track_mortar_damping_ns_per_m2 = self.track_mortar_damping_ns_per_m2

        track_base_elastic_modulus_pa: list[float] | Unset = UNSET
        if not isinstance(self.track_base_elastic_modulus_pa, Unset):
            track_base_elastic_modulus_pa = self.track_base_elastic_modulus_pa

        track_base_second_moment_m4: list[float] | Unset = UNSET
        if not isinstance(self.track_base_second_moment_m4, Unset):
            track_base_second_moment_m4 = self.track_base_second_moment_m4

        track_base_mass_kg_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_base_mass_kg_per_m, Unset):
            track_base_mass_kg_per_m = self.track_base_mass_kg_per_m

        track_roadbed_stiffness_n_per_m2: list[float] | Unset = UNSET
        if not isinstance(self.track_roadbed_stiffness_n_per_m2, Unset):
            track_roadbed_stiffness_n_per_m2 = self.track_roadbed_stiffness_n_per_m2

        track_roadbed_damping_ns_per_m2: list[float] | Unset = UNSET
        if not isinstance(self.track_roadbed_damping_ns_per_m2, Unset):
            track_roadbed_damping_ns_per_m2 = self.track_roadbed_damping_ns_per_m2

        track_joint_shear_stiffness_n_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_joint_shear_stiffness_n_per_m, Unset):
            track_joint_shear_stiffness_n_per_m = self.track_joint_shear_stiffness_n_per_m

        track_joint_shear_damping_ns_per_m: list[float] | Unset = UNSET
        if not isinstance(self.track_joint_shear_damping_ns_per_m, Unset):
            track_joint_shear_damping_ns_per_m = self.track_joint_shear_damping_ns_per_m

        track_joint_pads_per_slab: list[int] | Unset = UNSET
        if not isinstance(self.track_joint_pads_per_slab, Unset):
            track_joint_pads_per_slab = self.track_joint_pads_per_slab

        track_joint_position: list[float] | Unset = UNSET
        if not isinstance(self.track_joint_position, Unset):
            track_joint_position = self.track_joint_position

        vehicle_car_body_mass_kg: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_car_body_mass_kg, Unset):
            vehicle_car_body_mass_kg = self.vehicle_car_body_mass_kg

        vehicle_car_body_pitch_inertia_kg_m2: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_car_body_pitch_inertia_kg_m2, Unset):
            vehicle_car_body_pitch_inertia_kg_m2 = self.vehicle_car_body_pitch_inertia_kg_m2

        vehicle_bogie_mass_kg: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_bogie_mass_kg, Unset):
            vehicle_bogie_mass_kg = self.vehicle_bogie_mass_kg

        vehicle_bogie_pitch_inertia_kg_m2: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_bogie_pitch_inertia_kg_m2, Unset):
            vehicle_bogie_pitch_inertia_kg_m2 = self.vehicle_bogie_pitch_inertia_kg_m2

        vehicle_wheelset_mass_kg: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_wheelset_mass_kg, Unset):
            vehicle_wheelset_mass_kg = self.vehicle_wheelset_mass_kg

        vehicle_primary_stiffness_n_per_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_primary_stiffness_n_per_m, Unset):
            vehicle_primary_stiffness_n_per_m = self.vehicle_primary_stiffness_n_per_m

        vehicle_primary_damping_ns_per_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_primary_damping_ns_per_m, Unset):
            vehicle_primary_damping_ns_per_m = self.vehicle_primary_damping_ns_per_m

        vehicle_secondary_stiffness_n_per_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_secondary_stiffness_n_per_m, Unset):
            vehicle_secondary_stiffness_n_per_m = self.vehicle_secondary_stiffness_n_per_m

        vehicle_secondary_damping_ns_per_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_secondary_damping_ns_per_m, Unset):
            vehicle_secondary_damping_ns_per_m = self.vehicle_secondary_damping_ns_per_m

        vehicle_half_bogie_distance_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_half_bogie_distance_m, Unset):
            vehicle_half_bogie_distance_m = self.vehicle_half_bogie_distance_m

        vehicle_half_wheelbase_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_half_wheelbase_m, Unset):
            vehicle_half_wheelbase_m = self.vehicle_half_wheelbase_m

        vehicle_wheel_radius_m: list[float] | Unset = UNSET
        if not isinstance(self.vehicle_wheel_radius_m, Unset):
            vehicle_wheel_radius_m = self.vehicle_wheel_radius_m

        numerics_track_length_m: list[float] | Unset = UNSET
        if not isinstance(self.numerics_track_length_m, Unset):
            numerics_track_length_m = self.numerics_track_length_m

        numerics_elements_per_pad: list[int] | Unset = UNSET
        if not isinstance(self.numerics_elements_per_pad, Unset):
            numerics_elements_per_pad = self.numerics_elements_per_pad

        numerics_mesh_offset: list[float] | Unset = UNSET
        if not isinstance(self.numerics_mesh_offset, Unset):
            numerics_mesh_offset = self.numerics_mesh_offset

        numerics_time_step_s: list[float] | Unset = UNSET
        if not isinstance(self.numerics_time_step_s, Unset):
            numerics_time_step_s = self.numerics_time_step_s

        numerics_start_m: list[float] | Unset = UNSET
        if not isinstance(self.numerics_start_m, Unset):
            numerics_start_m = self.numerics_start_m

        numerics_settle_s: list[float] | Unset = UNSET
        if not isinstance(self.numerics_settle_s, Unset):
            numerics_settle_s = self.numerics_settle_s

        numerics_window_s: list[float] | Unset = UNSET
        if not isinstance(self.numerics_window_s, Unset):
            numerics_window_s = self.numerics_window_s

        numerics_ease_in_s: list[float] | Unset = UNSET
        if not isinstance(self.numerics_ease_in_s, Unset):
            numerics_ease_in_s = self.numerics_ease_in_s

        numerics_spectral_radius: list[float] | Unset = UNSET
        if not isinstance(self.numerics_spectral_radius, Unset):
            numerics_spectral_radius = self.numerics_spectral_radius

        numerics_absorbing_length_m: list[float] | Unset = UNSET
        if not isinstance(self.numerics_absorbing_length_m, Unset):
            numerics_absorbing_length_m = self.numerics_absorbing_length_m

        numerics_absorbing_damping_ns_per_m2: list[float] | Unset = UNSET
        if not isinstance(self.numerics_absorbing_damping_ns_per_m2, Unset):
            numerics_absorbing_damping_ns_per_m2 = self.numerics_absorbing_damping_ns_per_m2

        numerics_joint_blending: list[float] | Unset = UNSET
        if not isinstance(self.numerics_joint_blending, Unset):
            numerics_joint_blending = self.numerics_joint_blending

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if track_rail_elastic_modulus_pa is not UNSET:
            field_dict["track.rail_elastic_modulus_pa"] = track_rail_elastic_modulus_pa
        if track_rail_second_moment_m4 is not UNSET:
            field_dict["track.rail_second_moment_m4"] = track_rail_second_moment_m4
        if track_rail_mass_kg_per_m is not UNSET:
            field_dict["track.rail_mass_kg_per_m"] = track_rail_mass_kg_per_m
        if track_pad_stiffness_n_per_m is not UNSET:
            field_dict["track.pad_stiffness_n_per_m"] = track_pad_stiffness_n_per_m
        if track_pad_damping_ns_per_m is not UNSET:
            field_dict["track.pad_damping_ns_per_m"] = track_pad_damping_ns_per_m
        if track_pad_spacing_m is not UNSET:
            field_dict["track.pad_spacing_m"] = track_pad_spacing_m
        if track_slab_elastic_modulus_pa is not UNSET:
            field_dict["track.slab_elastic_modulus_pa"] = track_slab_elastic_modulus_pa
        if track_slab_second_moment_m4 is not UNSET:
            field_dict["track.slab_second_moment_m4"] = track_slab_second_moment_m4
        if track_slab_mass_kg_per_m is not UNSET:
            field_dict["track.slab_mass_kg_per_m"] = track_slab_mass_kg_per_m
        if track_mortar_stiffness_n_per_m2 is not UNSET:
            field_dict["track.mortar_stiffness_n_per_m2"] = track_mortar_stiffness_n_per_m2
        if track_mortar_damping_ns_per_m2 is not UNSET:
            field_dict["track.mortar_damping_ns_per_m2"] = track_mortar_damping_ns_per_m2
        if track_base_elastic_modulus_pa is not UNSET:
            field_dict["track.base_elastic_modulus_pa"] = track_base_elastic_modulus_pa
        if track_base_second_moment_m4 is not UNSET:
            field_dict["track.base_second_moment_m4"] = track_base_second_moment_m4
        if track_base_mass_kg_per_m is not UNSET:
            field_dict["track.base_mass_kg_per_m"] = track_base_mass_kg_per_m
        if track_roadbed_stiffness_n_per_m2 is not UNSET:
            field_dict["track.roadbed_stiffness_n_per_m2"] = track_roadbed_stiffness_n_per_m2
        if track_roadbed_damping_ns_per_m2 is not UNSET:
            field_dict["track.roadbed_damping_ns_per_m2"] = track_roadbed_damping_ns_per_m2
        if track_joint_shear_stiffness_n_per_m is not UNSET:
            field_dict["track.joint.shear_stiffness_n_per_m"] = track_joint_shear_stiffness_n_per_m
        if track_joint_shear_damping_ns_per_m is not UNSET:
            field_dict["track.joint.shear_damping_ns_per_m"] = track_joint_shear_damping_ns_per_m
        if track_joint_pads_per_slab is not UNSET:
            field_dict["track.joint.pads_per_slab"] = track_joint_pads_per_slab
        if track_joint_position is not UNSET:
            field_dict["track.joint.position"] = track_joint_position
        if vehicle_car_body_mass_kg is not UNSET:
            field_dict["vehicle.car_body_mass_kg"] = vehicle_car_body_mass_kg
        if vehicle_car_body_pitch_inertia_kg_m2 is not UNSET:
            field_dict["vehicle.car_body_pitch_inertia_kg_m2"] = vehicle_car_body_pitch_inertia_kg_m2
        if vehicle_bogie_mass_kg is not UNSET:
            field_dict["vehicle.bogie_mass_kg"] = vehicle_bogie_mass_kg
        if vehicle_bogie_pitch_inertia_kg_m2 is not UNSET:
            field_dict["vehicle.bogie_pitch_inertia_kg_m2"] = vehicle_bogie_pitch_inertia_kg_m2
        if vehicle_wheelset_mass_kg is not UNSET:
            field_dict["vehicle.wheelset_mass_kg"] = vehicle_wheelset_mass_kg
        if vehicle_primary_stiffness_n_per_m is not UNSET:
            field_dict["vehicle.primary_stiffness_n_per_m"] = vehicle_primary_stiffness_n_per_m
        if vehicle_primary_damping_ns_per_m is not UNSET:
            field_dict["vehicle.primary_damping_ns_per_m"] = vehicle_primary_damping_ns_per_m
        if vehicle_secondary_stiffness_n_per_m is not UNSET:
            field_dict["vehicle.secondary_stiffness_n_per_m"] = vehicle_secondary_stiffness_n_per_m
        if vehicle_secondary_damping_ns_per_m is not UNSET:
            field_dict["vehicle.secondary_damping_ns_per_m"] = vehicle_secondary_damping_ns_per_m
        if vehicle_half_bogie_distance_m is not UNSET:
            field_dict["vehicle.half_bogie_distance_m"] = vehicle_half_bogie_distance_m
        if vehicle_half_wheelbase_m is not UNSET:
            field_dict["vehicle.half_wheelbase_m"] = vehicle_half_wheelbase_m
        if vehicle_wheel_radius_m is not UNSET:
            field_dict["vehicle.wheel_radius_m"] = vehicle_wheel_radius_m
        if numerics_track_length_m is not UNSET:
            field_dict["numerics.track_length_m"] = numerics_track_length_m
        if numerics_elements_per_pad is not UNSET:
            field_dict["numerics.elements_per_pad"] = numerics_elements_per_pad
        if numerics_mesh_offset is not UNSET:
            field_dict["numerics.mesh_offset"] = numerics_mesh_offset
        if numerics_time_step_s is not UNSET:
            field_dict["numerics.time_step_s"] = numerics_time_step_s
        if numerics_start_m is not UNSET:
            field_dict["numerics.start_m"] = numerics_start_m
        if numerics_settle_s is not UNSET:
            field_dict["numerics.settle_s"] = numerics_settle_s
        if numerics_window_s is not UNSET:
            field_dict["numerics.window_s"] = numerics_window_s
        if numerics_ease_in_s is not UNSET:
            field_dict["numerics.ease_in_s"] = numerics_ease_in_s
        if numerics_spectral_radius is not UNSET:
            field_dict["numerics.spectral_radius"] = numerics_spectral_radius
        if numerics_absorbing_length_m is not UNSET:
            field_dict["numerics.absorbing_length_m"] = numerics_absorbing_length_m
        if numerics_absorbing_damping_ns_per_m2 is not UNSET:
            field_dict["numerics.absorbing_damping_ns_per_m2"] = numerics_absorbing_damping_ns_per_m2
        if numerics_joint_blending is not UNSET:
            field_dict["numerics.joint_blending"] = numerics_joint_blending

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        track_rail_elastic_modulus_pa = cast(list[float], d.pop("track.rail_elastic_modulus_pa", UNSET))

        track_rail_second_moment_m4 = cast(list[float], d.pop("track.rail_second_moment_m4", UNSET))

        track_rail_mass_kg_per_m = cast(list[float], d.pop("track.rail_mass_kg_per_m", UNSET))

        track_pad_stiffness_n_per_m = cast(list[float], d.pop("track.pad_stiffness_n_per_m", UNSET))

        track_pad_damping_ns_per_m = cast(list[float], d.pop("track.pad_damping_ns_per_m", UNSET))

        track_pad_spacing_m = cast(list[float], d.pop("track.pad_spacing_m", UNSET))

        track_slab_elastic_modulus_pa = cast(list[float], d.pop("track.slab_elastic_modulus_pa", UNSET))

        track_slab_second_moment_m4 = cast(list[float], d.pop("track.slab_second_moment_m4", UNSET))

        track_slab_mass_kg_per_m = cast(list[float], d.pop("track.slab_mass_kg_per_m", UNSET))

        track_mortar_stiffness_n_per_m2 = cast(list[float], d.pop("track.mortar_stiffness_n_per_m2", UNSET))

        track_mortar_damping_ns_per_m2 = cast(list[float], d.pop("track.mortar_damping_ns_per_m2", UNSET))

        track_base_elastic_modulus_pa = cast(list[float], d.pop("track.base_elastic_modulus_pa", UNSET))

        track_base_second_moment_m4 = cast(list[float], d.pop("track.base_second_moment_m4", UNSET))

        track_base_mass_kg_per_m = cast(list[float], d.pop("track.base_mass_kg_per_m", UNSET))

        track_roadbed_stiffness_n_per_m2 = cast(list[float], d.pop("track.roadbed_stiffness_n_per_m2", UNSET))

        track_roadbed_damping_ns_per_m2 = cast(list[float], d.pop("track.roadbed_damping_ns_per_m2", UNSET))

        track_joint_shear_stiffness_n_per_m = cast(list[float], d.pop("track.joint.shear_stiffness_n_per_m", UNSET))

        track_joint_shear_damping_ns_per_m = cast(list[float], d.pop("track.joint.shear_damping_ns_per_m", UNSET))

        track_joint_pads_per_slab = cast(list[int], d.pop("track.joint.pads_per_slab", UNSET))

        track_joint_position = cast(list[float], d.pop("track.joint.position", UNSET))

        vehicle_car_body_mass_kg = cast(list[float], d.pop("vehicle.car_body_mass_kg", UNSET))

        vehicle_car_body_pitch_inertia_kg_m2 = cast(list[float], d.pop("vehicle.car_body_pitch_inertia_kg_m2", UNSET))

        vehicle_bogie_mass_kg = cast(list[float], d.pop("vehicle.bogie_mass_kg", UNSET))

        vehicle_bogie_pitch_inertia_kg_m2 = cast(list[float], d.pop("vehicle.bogie_pitch_inertia_kg_m2", UNSET))

        vehicle_wheelset_mass_kg = cast(list[float], d.pop("vehicle.wheelset_mass_kg", UNSET))

        vehicle_primary_stiffness_n_per_m = cast(list[float], d.pop("vehicle.primary_stiffness_n_per_m", UNSET))

        vehicle_primary_damping_ns_per_m = cast(list[float], d.pop("vehicle.primary_damping_ns_per_m", UNSET))

        vehicle_secondary_stiffness_n_per_m = cast(list[float], d.pop("vehicle.secondary_stiffness_n_per_m", UNSET))

        vehicle_secondary_damping_ns_per_m = cast(list[float], d.pop("vehicle.secondary_damping_ns_per_m", UNSET))

        vehicle_half_bogie_distance_m = cast(list[float], d.pop("vehicle.half_bogie_distance_m", UNSET))

        vehicle_half_wheelbase_m = cast(list[float], d.pop("vehicle.half_wheelbase_m", UNSET))

        vehicle_wheel_radius_m = cast(list[float], d.pop("vehicle.wheel_radius_m", UNSET))

        numerics_track_length_m = cast(list[float], d.pop("numerics.track_length_m", UNSET))

        numerics_elements_per_pad = cast(list[int], d.pop("numerics.elements_per_pad", UNSET))

        numerics_mesh_offset = cast(list[float], d.pop("numerics.mesh_offset", UNSET))

        numerics_time_step_s = cast(list[float], d.pop("numerics.time_step_s", UNSET))

        numerics_start_m = cast(list[float], d.pop("numerics.start_m", UNSET))

        numerics_settle_s = cast(list[float], d.pop("numerics.settle_s", UNSET))

        numerics_window_s = cast(list[float], d.pop("numerics.window_s", UNSET))

        numerics_ease_in_s = cast(list[float], d.pop("numerics.ease_in_s", UNSET))

        numerics_spectral_radius = cast(list[float], d.pop("numerics.spectral_radius", UNSET))

        numerics_absorbing_length_m = cast(list[float], d.pop("numerics.absorbing_length_m", UNSET))

        numerics_absorbing_damping_ns_per_m2 = cast(list[float], d.pop("numerics.absorbing_damping_ns_per_m2", UNSET))

        numerics_joint_blending = cast(list[float], d.pop("numerics.joint_blending", UNSET))

        vary = cls(
            track_rail_elastic_modulus_pa=track_rail_elastic_modulus_pa,
            track_rail_second_moment_m4=track_rail_second_moment_m4,
            track_rail_mass_kg_per_m=track_rail_mass_kg_per_m,
            track_pad_stiffness_n_per_m=track_pad_stiffness_n_per_m,
            track_pad_damping_ns_per_m=track_pad_damping_ns_per_m,
            track_pad_spacing_m=track_pad_spacing_m,
            track_slab_elastic_modulus_pa=track_slab_elastic_modulus_pa,
            track_slab_second_moment_m4=track_slab_second_moment_m4,
            track_slab_mass_kg_per_m=track_slab_mass_kg_per_m,
            track_mortar_stiffness_n_per_m2=track_mortar_stiffness_n_per_m2,
            track_mortar_damping_ns_per_m2=track_mortar_damping_ns_per_m2,
            track_base_elastic_modulus_pa=track_base_elastic_modulus_pa,
            track_base_second_moment_m4=track_base_second_moment_m4,
            track_base_mass_kg_per_m=track_base_mass_kg_per_m,
            track_roadbed_stiffness_n_per_m2=track_roadbed_stiffness_n_per_m2,
            track_roadbed_damping_ns_per_m2=track_roadbed_damping_ns_per_m2,
            track_joint_shear_stiffness_n_per_m=track_joint_shear_stiffness_n_per_m,
            track_joint_shear_damping_ns_per_m=track_joint_shear_damping_ns_per_m,
            track_joint_pads_per_slab=track_joint_pads_per_slab,
            track_joint_position=track_joint_position,
            vehicle_car_body_mass_kg=vehicle_car_body_mass_kg,
            vehicle_car_body_pitch_inertia_kg_m2=vehicle_car_body_pitch_inertia_kg_m2,
            vehicle_bogie_mass_kg=vehicle_bogie_mass_kg,
            vehicle_bogie_pitch_inertia_kg_m2=vehicle_bogie_pitch_inertia_kg_m2,
            vehicle_wheelset_mass_kg=vehicle_wheelset_mass_kg,
            vehicle_primary_stiffness_n_per_m=vehicle_primary_stiffness_n_per_m,
            vehicle_primary_damping_ns_per_m=vehicle_primary_damping_ns_per_m,
            vehicle_secondary_stiffness_n_per_m=vehicle_secondary_stiffness_n_per_m,
            vehicle_secondary_damping_ns_per_m=vehicle_secondary_damping_ns_per_m,
            vehicle_half_bogie_distance_m=vehicle_half_bogie_distance_m,
            vehicle_half_wheelbase_m=vehicle_half_wheelbase_m,
            vehicle_wheel_radius_m=vehicle_wheel_radius_m,
            numerics_track_length_m=numerics_track_length_m,
            numerics_elements_per_pad=numerics_elements_per_pad,
            numerics_mesh_offset=numerics_mesh_offset,
            numerics_time_step_s=numerics_time_step_s,
            numerics_start_m=numerics_start_m,
            numerics_settle_s=numerics_settle_s,
            numerics_window_s=numerics_window_s,
            numerics_ease_in_s=numerics_ease_in_s,
            numerics_spectral_radius=numerics_spectral_radius,
            numerics_absorbing_length_m=numerics_absorbing_length_m,
            numerics_absorbing_damping_ns_per_m2=numerics_absorbing_damping_ns_per_m2,
            numerics_joint_blending=numerics_joint_blending,
        )

        return vary
