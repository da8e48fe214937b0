from typing import Literal

VerificationDetailOutcomeType0 = Literal["differs", "same"]

VERIFICATION_DETAIL_OUTCOME_TYPE_0_VALUES: set[VerificationDetailOutcomeType0] = {
    "differs",
    "same",
}


def check_verification_detail_outcome_type_0(value: str) -> VerificationDetailOutcomeType0:
    if value in VERIFICATION_DETAIL_OUTCOME_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {VERIFICATION_DETAIL_OUTCOME_TYPE_0_VALUES!r}")
