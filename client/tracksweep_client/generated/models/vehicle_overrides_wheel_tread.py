from typing import Literal

VehicleOverridesWheelTread = Literal["conical", "worn"]

VEHICLE_OVERRIDES_WHEEL_TREAD_VALUES: set[VehicleOverridesWheelTread] = {
    "conical",
    "worn",
}


def check_vehicle_overrides_wheel_tread(value: str) -> VehicleOverridesWheelTread:
    if value in VEHICLE_OVERRIDES_WHEEL_TREAD_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VEHICLE_OVERRIDES_WHEEL_TREAD_VALUES!r}")
