from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

T = TypeVar("T", bound="Changes")


@_attrs_define
class Changes:
    """Values of parameters; each replaces what the study says of it.

    Attributes:
        track_rail_elastic_modulus_pa (float | Unset): Young's modulus of the rail, Pa.
        track_rail_second_moment_m4 (float | Unset): Second moment of area of the rail, m^4.
        track_rail_mass_kg_per_m (float | Unset): Rail mass per length, kg/m.
        track_pad_stiffness_n_per_m (float | Unset): Stiffness of one rail pad with its fastening, N/m.
        track_pad_damping_ns_per_m (float | Unset): Damping of one rail pad with its fastening, N s/m.
        track_pad_spacing_m (float | Unset): Distance between pads, m.
        track_slab_elastic_modulus_pa (float | Unset): Young's modulus of the slab, Pa.
        track_slab_second_moment_m4 (float | Unset): Second moment of area of the half slab, m^4.
        track_slab_mass_kg_per_m (float | Unset): Mass of the half slab per length, kg/m.
        track_mortar_stiffness_n_per_m2 (float | Unset): Stiffness of the CA mortar per length, N/m^2.
        track_mortar_damping_ns_per_m2 (float | Unset): Damping of the CA mortar per length, N s/m^2.
        track_base_elastic_modulus_pa (float | Unset): Young's modulus of the concrete base, Pa.
        track_base_second_moment_m4 (float | Unset): Second moment of area of the half base, m^4.
        track_base_mass_kg_per_m (float | Unset): Mass of the half base per length, kg/m.
        track_roadbed_stiffness_n_per_m2 (float | Unset): Stiffness of the roadbed per length, N/m^2.
        track_roadbed_damping_ns_per_m2 (float | Unset): Damping of the roadbed per length, N s/m^2.
        track_joint_shear_stiffness_n_per_m (float | Unset): Stiffness against a jump between slabs, N/m.
        track_joint_shear_damping_ns_per_m (float | Unset): Damping of a jump between slabs, N s/m.
        track_joint_pads_per_slab (int | Unset): Pads on every slab.
        track_joint_position (float | Unset): Place of a joint between two pads, as part of their spacing.
        vehicle_car_body_mass_kg (float | Unset): Mass of the car body, kg.
        vehicle_car_body_pitch_inertia_kg_m2 (float | Unset): Pitch inertia of the car body, kg m^2.
        vehicle_bogie_mass_kg (float | Unset): Mass of one bogie frame, kg.
        vehicle_bogie_pitch_inertia_kg_m2 (float | Unset): Pitch inertia of one bogie frame, kg m^2.
        vehicle_wheelset_mass_kg (float | Unset): Mass of one wheelset, kg.
        vehicle_primary_stiffness_n_per_m (float | Unset): Primary suspension, vertical, per axle, N/m.
        vehicle_primary_damping_ns_per_m (float | Unset): Primary suspension, vertical, per axle, N s/m.
        vehicle_secondary_stiffness_n_per_m (float | Unset): Secondary suspension, vertical, per bogie, N/m.
        vehicle_secondary_damping_ns_per_m (float | Unset): Secondary suspension, vertical, per bogie, N s/m.
        vehicle_half_bogie_distance_m (float | Unset): Half the distance between bogie centres, m.
        vehicle_half_wheelbase_m (float | Unset): Half the distance between the axles of a bogie, m.
        vehicle_wheel_radius_m (float | Unset): Wheel radius, m.
        numerics_track_length_m (float | Unset): Length of track that moves with the vehicle, m.
        numerics_elements_per_pad (int | Unset): Elements of each beam between two pads.
        numerics_mesh_offset (float | Unset): Part of an element by which the mesh lies behind the first wheel.
        numerics_time_step_s (float | Unset): Largest time step; the step used divides the time from pad to pad, s.
        numerics_start_m (float | Unset): Position of the first wheel on the track at the start, m.
        numerics_settle_s (float | Unset): Time computed and discarded before the window, s.
        numerics_window_s (float | Unset): Steady window from which peaks are read, s.
        numerics_ease_in_s (float | Unset): Time over which the irregularity grows to its full height, s.
        numerics_spectral_radius (float | Unset): Spectral radius of the integrator at infinite frequency.
        numerics_absorbing_length_m (float | Unset): Length of each absorbing end, m.
        numerics_absorbing_damping_ns_per_m2 (float | Unset): Damping of the whole track added at the very ends, N
            s/m^2.
        numerics_joint_blending (float | Unset): Pad spacings over which the shape functions of a joint fade.
    """

    track_rail_elastic_modulus_pa: float | Unset = UNSET
    track_rail_second_moment_m4: float | Unset = UNSET
    track_rail_mass_kg_per_m: float | Unset = UNSET
    track_pad_stiffness_n_per_m: float | Unset = UNSET
    track_pad_damping_ns_per_m: float | Unset = UNSET
    track_pad_spacing_m: float | Unset = UNSET
    track_slab_elastic_modulus_pa: float | Unset = UNSET
    track_slab_second_moment_m4: float | Unset = UNSET
    track_slab_mass_kg_per_m: float | Unset = UNSET
    track_mortar_stiffness_n_per_m2: float | Unset = UNSET
    track_mortar_damping_ns_per_m2: float | Unset = UNSET
    track_base_elastic_modulus_pa: float | Unset = UNSET
    track_base_second_moment_m4: float | Unset = UNSET
    track_base_mass_kg_per_m: float | Unset = UNSET
    track_roadbed_stiffness_n_per_m2: float | Unset = UNSET
    track_roadbed_damping_ns_per_m2: float | Unset = UNSET
    track_joint_shear_stiffness_n_per_m: float | Unset = UNSET
    track_joint_shear_damping_ns_per_m: float | Unset = UNSET
    track_joint_pads_per_slab: int | Unset = UNSET
    track_joint_position: float | Unset = UNSET
    vehicle_car_body_mass_kg: float | Unset = UNSET
    vehicle_car_body_pitch_inertia_kg_m2: float | Unset = UNSET
    vehicle_bogie_mass_kg: float | Unset = UNSET
    vehicle_bogie_pitch_inertia_kg_m2: float | Unset = UNSET
    vehicle_wheelset_mass_kg: float | Unset = UNSET
    vehicle_primary_stiffness_n_per_m: float | Unset = UNSET
    vehicle_primary_damping_ns_per_m: float | Unset = UNSET
    vehicle_secondary_stiffness_n_per_m: float | Unset = UNSET
    vehicle_secondary_damping_ns_per_m: float | Unset = UNSET
    vehicle_half_bogie_distance_m: float | Unset = UNSET
    vehicle_half_wheelbase_m: float | Unset = UNSET
    vehicle_wheel_radius_m: float | Unset = UNSET
    numerics_track_length_m: float | Unset = UNSET
    numerics_elements_per_pad: int | Unset = UNSET
    numerics_mesh_offset: float | Unset = UNSET
    numerics_time_step_s: float | Unset = UNSET
    numerics_start_m: float | Unset = UNSET
    numerics_settle_s: float | Unset = UNSET
    numerics_window_s: float | Unset = UNSET
    numerics_ease_in_s: float | Unset = UNSET
    numerics_spectral_radius: float | Unset = UNSET
    numerics_absorbing_length_m: float | Unset = UNSET
    numerics_absorbing_damping_ns_per_m2: float | Unset = UNSET
    numerics_joint_blending: float | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        track_rail_elastic_modulus_pa = self.track_rail_elastic_modulus_pa

        track_rail_second_moment_m4 = self.track_rail_second_moment_m4

        track_rail_mass_kg_per_m = self.track_rail_mass_kg_per_m

        track_pad_stiffness_n_per_m = self.track_pad_stiffness_n_per_m

        track_pad_damping_ns_per_m = self.track_pad_damping_ns_per_m

        track_pad_spacing_m = self.track_pad_spacing_m

        track_slab_elastic_modulus_pa = self.track_slab_elastic_modulus_pa

        track_slab_second_moment_m4 = self.track_slab_second_moment_m4

        track_slab_mass_kg_per_m = self.track_slab_mass_kg_per_m

        track_mortar_stiffness_n_per_m2 = self.track_mortar_stiffness_n_per_m2

        track_mortar_damping_ns_per_m2 = self.track_mortar_damping_ns_per_m2

        track_base_elastic_modulus_pa = self.track_base_elastic_modulus_pa

        track_base_second_moment_m4 = self.track_base_second_moment_m4

        track_base_mass_kg_per_m = self.track_base_mass_kg_per_m

        track_roadbed_stiffness_n_per_m2 = self.track_roadbed_stiffness_n_per_m2

        track_roadbed_damping_ns_per_m2 = self.track_roadbed_damping_ns_per_m2

        track_joint_shear_stiffness_n_per_m = self.track_joint_shear_stiffness_n_per_m

        track_joint_shear_damping_ns_per_m = self.track_joint_shear_damping_ns_per_m

        track_joint_pads_per_slab = self.track_joint_pads_per_slab

        track_joint_position = self.track_joint_position

        vehicle_car_body_mass_kg = self.vehicle_car_body_mass_kg

        vehicle_car_body_pitch_inertia_kg_m2 = self.vehicle_car_body_pitch_inertia_kg_m2

        vehicle_bogie_mass_kg = self.vehicle_bogie_mass_kg

        vehicle_bogie_pitch_inertia_kg_m2 = self.vehicle_bogie_pitch_inertia_kg_m2

        vehicle_wheelset_mass_kg = self.vehicle_wheelset_mass_kg

        vehicle_primary_stiffness_n_per_m = self.vehicle_primary_stiffness_n_per_m

        vehicle_primary_damping_ns_per_m = self.vehicle_primary_damping_ns_per_m

        vehicle_secondary_stiffness_n_per_m = self.vehicle_secondary_stiffness_n_per_m

        vehicle_secondary_damping_ns_per_m = self.vehicle_secondary_damping_ns_per_m

        vehicle_half_bogie_distance_m = self.vehicle_half_bogie_distance_m

        vehicle_half_wheelbase_m = self.vehicle_half_wheelbase_m

        vehicle_wheel_radius_m = self.vehicle_wheel_radius_m

        numerics_track_length_m = self.numerics_track_length_m

        numerics_elements_per_pad = self.numerics_elements_per_pad

        numerics_mesh_offset = self.numerics_mesh_offset

        numerics_time_step_s = self.numerics_time_step_s

        numerics_start_m = self.numerics_start_m

        numerics_settle_s = self.numerics_settle_s

        numerics_window_s = self.numerics_window_s

        numerics_ease_in_s = self.numerics_ease_in_s

        numerics_spectral_radius = self.numerics_spectral_radius

        numerics_absorbing_length_m = self.numerics_absorbing_length_m

        numerics_absorbing_damping_ns_per_m2 = self.numerics_absorbing_damping_ns_per_m2

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
        track_rail_elastic_modulus_pa = d.pop("track.rail_elastic_modulus_pa", UNSET)

        track_rail_second_moment_m4 = d.pop("track.rail_second_moment_m4", UNSET)

        track_rail_mass_kg_per_m = d.pop("track.rail_mass_kg_per_m", UNSET)

        track_pad_stiffness_n_per_m = d.pop("track.pad_stiffness_n_per_m", UNSET)

        track_pad_damping_ns_per_m = d.pop("track.pad_damping_ns_per_m", UNSET)

        track_pad_spacing_m = d.pop("track.pad_spacing_m", UNSET)

        track_slab_elastic_modulus_pa = d.pop("track.slab_elastic_modulus_pa", UNSET)

        track_slab_second_moment_m4 = d.pop("track.slab_second_moment_m4", UNSET)

        track_slab_mass_kg_per_m = d.pop("track.slab_mass_kg_per_m", UNSET)

        track_mortar_stiffness_n_per_m2 = d.pop("track.mortar_stiffness_n_per_m2", UNSET)

        track_mortar_damping_ns_per_m2 = d.pop("track.mortar_damping_ns_per_m2", UNSET)

        track_base_elastic_modulus_pa = d.pop("track.base_elastic_modulus_pa", UNSET)

        track_base_second_moment_m4 = d.pop("track.base_second_moment_m4", UNSET)

        track_base_mass_kg_per_m = d.pop("track.base_mass_kg_per_m", UNSET)

        track_roadbed_stiffness_n_per_m2 = d.pop("track.roadbed_stiffness_n_per_m2", UNSET)

        track_roadbed_damping_ns_per_m2 = d.pop("track.roadbed_damping_ns_per_m2", UNSET)

        track_joint_shear_stiffness_n_per_m = d.pop("track.joint.shear_stiffness_n_per_m", UNSET)

        track_joint_shear_damping_ns_per_m = d.pop("track.joint.shear_damping_ns_per_m", UNSET)

        track_joint_pads_per_slab = d.pop("track.joint.pads_per_slab", UNSET)

        track_joint_position = d.pop("track.joint.position", UNSET)

        vehicle_car_body_mass_kg = d.pop("vehicle.car_body_mass_kg", UNSET)

        vehicle_car_body_pitch_inertia_kg_m2 = d.pop("vehicle.car_body_pitch_inertia_kg_m2", UNSET)

        vehicle_bogie_mass_kg = d.pop("vehicle.bogie_mass_kg", UNSET)

        vehicle_bogie_pitch_inertia_kg_m2 = d.pop("vehicle.bogie_pitch_inertia_kg_m2", UNSET)

        vehicle_wheelset_mass_kg = d.pop("vehicle.wheelset_mass_kg", UNSET)

        vehicle_primary_stiffness_n_per_m = d.pop("vehicle.primary_stiffness_n_per_m", UNSET)

        vehicle_primary_damping_ns_per_m = d.pop("vehicle.primary_damping_ns_per_m", UNSET)

        vehicle_secondary_stiffness_n_per_m = d.pop("vehicle.secondary_stiffness_n_per_m", UNSET)

        vehicle_secondary_damping_ns_per_m = d.pop("vehicle.secondary_damping_ns_per_m", UNSET)

        vehicle_half_bogie_distance_m = d.pop("vehicle.half_bogie_distance_m", UNSET)

        vehicle_half_wheelbase_m = d.pop("vehicle.half_wheelbase_m", UNSET)

        vehicle_wheel_radius_m = d.pop("vehicle.wheel_radius_m", UNSET)

        numerics_track_length_m = d.pop("numerics.track_length_m", UNSET)

        numerics_elements_per_pad = d.pop("numerics.elements_per_pad", UNSET)

        numerics_mesh_offset = d.pop("numerics.mesh_offset", UNSET)

        numerics_time_step_s = d.pop("numerics.time_step_s", UNSET)

        numerics_start_m = d.pop("numerics.start_m", UNSET)

        numerics_settle_s = d.pop("numerics.settle_s", UNSET)

        numerics_window_s = d.pop("numerics.window_s", UNSET)

        numerics_ease_in_s = d.pop("numerics.ease_in_s", UNSET)

        numerics_spectral_radius = d.pop("numerics.spectral_radius", UNSET)

        numerics_absorbing_length_m = d.pop("numerics.absorbing_length_m", UNSET)

        numerics_absorbing_damping_ns_per_m2 = d.pop("numerics.absorbing_damping_ns_per_m2", UNSET)

        numerics_joint_blending = d.pop("numerics.joint_blending", UNSET)

        changes = cls(
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

        return changes
