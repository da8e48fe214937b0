from typing import Literal

QuantityLimitMark = Literal["A", "C", "V"]

QUANTITY_LIMIT_MARK_VALUES: set[QuantityLimitMark] = {
    "A",
    "C",
    "V",
}


def check_quantity_limit_mark(value: str) -> QuantityLimitMark:
    if value in QUANTITY_LIMIT_MARK_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {QUANTITY_LIMIT_MARK_VALUES!r}")
