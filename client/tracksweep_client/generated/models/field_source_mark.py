from typing import Literal

FieldSourceMark = Literal["A", "C", "V"]

FIELD_SOURCE_MARK_VALUES: set[FieldSourceMark] = {
    "A",
    "C",
    "V",
}


def check_field_source_mark(value: str) -> FieldSourceMark:
    if value in FIELD_SOURCE_MARK_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {FIELD_SOURCE_MARK_VALUES!r}")
