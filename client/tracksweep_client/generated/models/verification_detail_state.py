from typing import Literal

VerificationDetailState = Literal["failed", "queued", "running", "succeeded"]

VERIFICATION_DETAIL_STATE_VALUES: set[VerificationDetailState] = {
    "failed",
    "queued",
    "running",
    "succeeded",
}


def check_verification_detail_state(value: str) -> VerificationDetailState:
    if value in VERIFICATION_DETAIL_STATE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VERIFICATION_DETAIL_STATE_VALUES!r}")
