from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define

from ..models.vehicle_overrides_base import (
    VehicleOverridesBase,
    check_vehicle_overrides_base,
)
from ..models.vehicle_overrides_wheel_tread import (
    VehicleOverridesWheelTread,
    check_vehicle_overrides_wheel_tread,
)
from ..types import UNSET, Unset

T = TypeVar("T", bound="VehicleOverrides")


@_attrs_define
class VehicleOverrides:
    """A four-axle car with two suspension stages. Values are of the whole car; the model takes half of each.

    Attributes:
        base (VehicleOverridesBase | Unset):  Default: 'crh3'.
        car_body_mass_kg (float | Unset): Mass of the car body, kg.
        car_body_pitch_inertia_kg_m2 (float | Unset): Pitch inertia of the car body, kg m^2.
        bogie_mass_kg (float | Unset): Mass of one bogie frame, kg.
        bogie_pitch_inertia_kg_m2 (float | Unset): Pitch inertia of one bogie frame, kg m^2.
        wheelset_mass_kg (float | Unset): Mass of one wheelset, kg.
        primary_stiffness_n_per_m (float | Unset): Primary suspension, vertical, per axle, N/m.
        primary_damping_ns_per_m (float | Unset): Primary suspension, vertical, per axle, N s/m.
        secondary_stiffness_n_per_m (float | Unset): Secondary suspension, vertical, per bogie, N/m.
        secondary_damping_ns_per_m (float | Unset): Secondary suspension, vertical, per bogie, N s/m.
        half_bogie_distance_m (float | Unset): Half the distance between bogie centres, m.
        half_wheelbase_m (float | Unset): Half the distance between the axles of a bogie, m.
        wheel_radius_m (float | Unset): Wheel radius, m.
        wheel_tread (VehicleOverridesWheelTread | Unset):  Default: 'worn'.
    """

    base: VehicleOverridesBase | Unset = "crh3"
    car_body_mass_kg: float | Unset = UNSET
    car_body_pitch_inertia_kg_m2: float | Unset = UNSET
    bogie_mass_kg: float | Unset = UNSET
    bogie_pitch_inertia_kg_m2: float | Unset = UNSET
    wheelset_mass_kg: float | Unset = UNSET
    primary_stiffness_n_per_m: float | Unset = UNSET
    primary_damping_ns_per_m: float | Unset = UNSET
    secondary_stiffness_n_per_m: float | Unset = UNSET
    secondary_damping_ns_per_m: float | Unset = UNSET
    half_bogie_distance_m: float | Unset = UNSET
    half_wheelbase_m: float | Unset = UNSET
    wheel_radius_m: float | Unset = UNSET
    wheel_tread: VehicleOverridesWheelTread | Unset = "worn"

    def to_dict(self) -> dict[str, Any]:
        base: str | Unset = UNSET
        if not isinstance(self.base, Unset):
            base = self.base

        car_body_mass_kg = self.car_body_mass_kg

        car_body_pitch_inertia_kg_m2 = self.car_body_pitch_inertia_kg_m2

        bogie_mass_kg = self.bogie_mass_kg

        bogie_pitch_inertia_kg_m2 = self.bogie_pitch_inertia_kg_m2

        wheelset_mass_kg = self.wheelset_mass_kg

        primary_stiffness_n_per_m = self.primary_stiffness_n_per_m

        primary_damping_ns_per_m = self.primary_damping_ns_per_m

        secondary_stiffness_n_per_m = self.secondary_stiffness_n_per_m

        secondary_damping_ns_per_m = self.secondary_damping_ns_per_m

        half_bogie_distance_m = self.half_bogie_distance_m

        half_wheelbase_m = self.half_wheelbase_m

        wheel_radius_m = self.wheel_radius_m

        wheel_tread: str | Unset = UNSET
        if not isinstance(self.wheel_tread, Unset):
            wheel_tread = self.wheel_tread

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if base is not UNSET:
            field_dict["base"] = base
        if car_body_mass_kg is not UNSET:
            field_dict["car_body_mass_kg"] = car_body_mass_kg
        if car_body_pitch_inertia_kg_m2 is not UNSET:
            field_dict["car_body_pitch_inertia_kg_m2"] = car_body_pitch_inertia_kg_m2
        if bogie_mass_kg is not UNSET:
            field_dict["bogie_mass_kg"] = bogie_mass_kg
        if bogie_pitch_inertia_kg_m2 is not UNSET:
            field_dict["bogie_pitch_inertia_kg_m2"] = bogie_pitch_inertia_kg_m2
        if wheelset_mass_kg is not UNSET:
            field_dict["wheelset_mass_kg"] = wheelset_mass_kg
        if primary_stiffness_n_per_m is not UNSET:
            field_dict["primary_stiffness_n_per_m"] = primary_stiffness_n_per_m
        if primary_damping_ns_per_m is not UNSET:
            field_dict["primary_damping_ns_per_m"] = primary_damping_ns_per_m
        if secondary_stiffness_n_per_m is not UNSET:
            field_dict["secondary_stiffness_n_per_m"] = secondary_stiffness_n_per_m
        if secondary_damping_ns_per_m is not UNSET:
            field_dict["secondary_damping_ns_per_m"] = secondary_damping_ns_per_m
        if half_bogie_distance_m is not UNSET:
            field_dict["half_bogie_distance_m"] = half_bogie_distance_m
        if half_wheelbase_m is not UNSET:
            field_dict["half_wheelbase_m"] = half_wheelbase_m
        if wheel_radius_m is not UNSET:
            field_dict["wheel_radius_m"] = wheel_radius_m
        if wheel_tread is not UNSET:
            field_dict["wheel_tread"] = wheel_tread

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        _base = d.pop("base", UNSET)
        base: VehicleOverridesBase | Unset
        if isinstance(_base, Unset):
            base = UNSET
        else:
            base = check_vehicle_overrides_base(_base)

        car_body_mass_kg = d.pop("car_body_mass_kg", UNSET)

        car_body_pitch_inertia_kg_m2 = d.pop("car_body_pitch_inertia_kg_m2", UNSET)

        bogie_mass_kg = d.pop("bogie_mass_kg", UNSET)

        bogie_pitch_inertia_kg_m2 = d.pop("bogie_pitch_inertia_kg_m2", UNSET)

        wheelset_mass_kg = d.pop("wheelset_mass_kg", UNSET)

        primary_stiffness_n_per_m = d.pop("primary_stiffness_n_per_m", UNSET)

        primary_damping_ns_per_m = d.pop("primary_damping_ns_per_m", UNSET)

        secondary_stiffness_n_per_m = d.pop("secondary_stiffness_n_per_m", UNSET)

        secondary_damping_ns_per_m = d.pop("secondary_damping_ns_per_m", UNSET)

        half_bogie_distance_m = d.pop("half_bogie_distance_m", UNSET)

        half_wheelbase_m = d.pop("half_wheelbase_m", UNSET)

        wheel_radius_m = d.pop("wheel_radius_m", UNSET)

        _wheel_tread = d.pop("wheel_tread", UNSET)
        wheel_tread: VehicleOverridesWheelTread | Unset
        if isinstance(_wheel_tread, Unset):
            wheel_tread = UNSET
        else:
            wheel_tread = check_vehicle_overrides_wheel_tread(_wheel_tread)

        vehicle_overrides = cls(
            base=base,
            car_body_mass_kg=car_body_mass_kg,
            car_body_pitch_inertia_kg_m2=car_body_pitch_inertia_kg_m2,
            bogie_mass_kg=bogie_mass_kg,
            bogie_pitch_inertia_kg_m2=bogie_pitch_inertia_kg_m2,
            wheelset_mass_kg=wheelset_mass_kg,
            primary_stiffness_n_per_m=primary_stiffness_n_per_m,
            primary_damping_ns_per_m=primary_damping_ns_per_m,
            secondary_stiffness_n_per_m=secondary_stiffness_n_per_m,
            secondary_damping_ns_per_m=secondary_damping_ns_per_m,
            half_bogie_distance_m=half_bogie_distance_m,
            half_wheelbase_m=half_wheelbase_m,
            wheel_radius_m=wheel_radius_m,
            wheel_tread=wheel_tread,
        )

        return vehicle_overrides
