from typing import Literal

CaseSummaryState = Literal["cancelled", "failed", "queued", "running", "succeeded"]

CASE_SUMMARY_STATE_VALUES: set[CaseSummaryState] = {
    "cancelled",
    "failed",
    "queued",
    "running",
    "succeeded",
}


def check_case_summary_state(value: str) -> CaseSummaryState:
    if value in CASE_SUMMARY_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CASE_SUMMARY_STATE_VALUES!r}")
