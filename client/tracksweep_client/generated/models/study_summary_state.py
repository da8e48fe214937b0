from typing import Literal

StudySummaryState = Literal["cancelled", "cancelling", "failed", "partially_failed", "queued", "running", "succeeded"]

STUDY_SUMMARY_STATE_VALUES: set[StudySummaryState] = {
    "cancelled",
    "cancelling",
    "failed",
    "partially_failed",
    "queued",
    "running",
    "succeeded",
}


def check_study_summary_state(value: str) -> StudySummaryState:
    if value in STUDY_SUMMARY_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {STUDY_SUMMARY_STATE_VALUES!r}")
