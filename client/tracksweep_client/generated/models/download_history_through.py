from typing import Literal

DownloadHistoryThrough = Literal["any", "service"]

DOWNLOAD_HISTORY_THROUGH_VALUES: set[DownloadHistoryThrough] = {
    "any",
    "service",
}


def check_download_history_through(value: str) -> DownloadHistoryThrough:
    if value in DOWNLOAD_HISTORY_THROUGH_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {DOWNLOAD_HISTORY_THROUGH_VALUES!r}")
