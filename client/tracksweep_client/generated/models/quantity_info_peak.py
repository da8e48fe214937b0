from typing import Literal

QuantityInfoPeak = Literal["magnitude", "maximum"]

QUANTITY_INFO_PEAK_VALUES: set[QuantityInfoPeak] = {
    "magnitude",
    "maximum",
}


def check_quantity_info_peak(value: str) -> QuantityInfoPeak:
    if value in QUANTITY_INFO_PEAK_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {QUANTITY_INFO_PEAK_VALUES!r}")
