from typing import Literal

ListCasesSort = Literal[
    "-cpu_s",
    "-finished_at",
    "-percentile",
    "-position",
    "-slab",
    "-speed_kmh",
    "-state",
    "cpu_s",
    "finished_at",
    "percentile",
    "position",
    "slab",
    "speed_kmh",
    "state",
]

LIST_CASES_SORT_VALUES: set[ListCasesSort] = {
    "-cpu_s",
    "-finished_at",
    "-percentile",
    "-position",
    "-slab",
    "-speed_kmh",
    "-state",
    "cpu_s",
    "finished_at",
    "percentile",
    "position",
    "slab",
    "speed_kmh",
    "state",
}


def check_list_cases_sort(value: str) -> ListCasesSort:
    if value in LIST_CASES_SORT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {LIST_CASES_SORT_VALUES!r}")
