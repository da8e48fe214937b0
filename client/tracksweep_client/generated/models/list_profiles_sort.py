from typing import Literal

ListProfilesSort = Literal["-created_at", "created_at"]

LIST_PROFILES_SORT_VALUES: set[ListProfilesSort] = {
    "-created_at",
    "created_at",
}


def check_list_profiles_sort(value: str) -> ListProfilesSort:
    if value in LIST_PROFILES_SORT_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {LIST_PROFILES_SORT_VALUES!r}")
