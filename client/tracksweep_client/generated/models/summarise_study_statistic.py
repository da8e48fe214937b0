from typing import Literal

SummariseStudyStatistic = Literal["maximum", "mean", "minimum", "peak", "rms", "std"]

SUMMARISE_STUDY_STATISTIC_VALUES: set[SummariseStudyStatistic] = {
    "maximum",
    "mean",
    "minimum",
    "peak",
    "rms",
    "std",
}


def check_summarise_study_statistic(value: str) -> SummariseStudyStatistic:
    if value in SUMMARISE_STUDY_STATISTIC_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {SUMMARISE_STUDY_STATISTIC_VALUES!r}")
