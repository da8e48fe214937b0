from typing import Literal

WheelTreadMark = Literal["A", "C", "V"]

WHEEL_TREAD_MARK_VALUES: set[WheelTreadMark] = {
    "A",
    "C",
    "V",
}


def check_wheel_tread_mark(value: str) -> WheelTreadMark:
    if value in WHEEL_TREAD_MARK_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {WHEEL_TREAD_MARK_VALUES!r}")
