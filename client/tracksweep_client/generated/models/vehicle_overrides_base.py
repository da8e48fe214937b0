from typing import Literal

VehicleOverridesBase = Literal["crh3", "sv2014", "sv2019", "velaro"]

VEHICLE_OVERRIDES_BASE_VALUES: set[VehicleOverridesBase] = {
    "crh3",
    "sv2014",
    "sv2019",
    "velaro",
}


def check_vehicle_overrides_base(value: str) -> VehicleOverridesBase:
    if value in VEHICLE_OVERRIDES_BASE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VEHICLE_OVERRIDES_BASE_VALUES!r}")
