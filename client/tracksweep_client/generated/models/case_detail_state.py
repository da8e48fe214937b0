from typing import Literal

CaseDetailState = Literal["cancelled", "failed", "queued", "running", "succeeded"]

CASE_DETAIL_STATE_VALUES: set[CaseDetailState] = {
    "cancelled",
    "failed",
    "queued",
    "running",
    "succeeded",
}


def check_case_detail_state(value: str) -> CaseDetailState:
    if value in CASE_DETAIL_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CASE_DETAIL_STATE_VALUES!r}")
