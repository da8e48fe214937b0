from typing import Literal

ListedCaseSlab = Literal["continuous", "discontinuous"]

LISTED_CASE_SLAB_VALUES: set[ListedCaseSlab] = {
    "continuous",
    "discontinuous",
}


def check_listed_case_slab(value: str) -> ListedCaseSlab:
    if value in LISTED_CASE_SLAB_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {LISTED_CASE_SLAB_VALUES!r}")
