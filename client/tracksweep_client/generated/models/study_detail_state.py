from typing import Literal

StudyDetailState = Literal["cancelled", "cancelling", "failed", "partially_failed", "queued", "running", "succeeded"]

STUDY_DETAIL_STATE_VALUES: set[StudyDetailState] = {
    "cancelled",
    "cancelling",
    "failed",
    "partially_failed",
    "queued",
    "running",
    "succeeded",
}


def check_study_detail_state(value: str) -> StudyDetailState:
    if value in STUDY_DETAIL_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {STUDY_DETAIL_STATE_VALUES!r}")
