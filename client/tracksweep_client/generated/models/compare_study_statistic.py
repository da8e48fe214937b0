from typing import Literal

CompareStudyStatistic = Literal["maximum", "mean", "minimum", "peak", "rms", "std"]

COMPARE_STUDY_STATISTIC_VALUES: set[CompareStudyStatistic] = {
    "maximum",
    "mean",
    "minimum",
    "peak",
    "rms",
    "std",
}


def check_compare_study_statistic(value: str) -> CompareStudyStatistic:
    if value in COMPARE_STUDY_STATISTIC_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {COMPARE_STUDY_STATISTIC_VALUES!r}")
