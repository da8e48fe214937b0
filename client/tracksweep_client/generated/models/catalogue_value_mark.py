from typing import Literal

CatalogueValueMark = Literal["A", "C", "V"]

CATALOGUE_VALUE_MARK_VALUES: set[CatalogueValueMark] = {
    "A",
    "C",
    "V",
}


def check_catalogue_value_mark(value: str) -> CatalogueValueMark:
    if value in CATALOGUE_VALUE_MARK_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CATALOGUE_VALUE_MARK_VALUES!r}")
