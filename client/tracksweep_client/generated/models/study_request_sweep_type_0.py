from typing import Literal

StudyRequestSweepType0 = Literal[
    "article-percentiles",
    "article-speed-continuous",
    "article-speed-discontinuous",
    "article-wavelength-bands",
    "joint-stiffness",
    "pad-stiffness",
    "speed-sweep",
]

STUDY_REQUEST_SWEEP_TYPE_0_VALUES: set[StudyRequestSweepType0] = {
    "article-percentiles",
    "article-speed-continuous",
    "article-speed-discontinuous",
    "article-wavelength-bands",
    "joint-stiffness",
    "pad-stiffness",
    "speed-sweep",
}


def check_study_request_sweep_type_0(value: str) -> StudyRequestSweepType0:
    if value in STUDY_REQUEST_SWEEP_TYPE_0_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {STUDY_REQUEST_SWEEP_TYPE_0_VALUES!r}")
