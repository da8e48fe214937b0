from typing import Literal

ListCasesState = Literal["cancelled", "failed", "queued", "running", "succeeded"]

LIST_CASES_STATE_VALUES: set[ListCasesState] = {
    "cancelled",
    "failed",
    "queued",
    "running",
    "succeeded",
}


def check_list_cases_state(value: str) -> ListCasesState:
    if value in LIST_CASES_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {LIST_CASES_STATE_VALUES!r}")
