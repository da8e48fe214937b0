from typing import Literal

TrackOverridesBase = Literal["crts2", "crts2-soft"]

TRACK_OVERRIDES_BASE_VALUES: set[TrackOverridesBase] = {
    "crts2",
    "crts2-soft",
}


def check_track_overrides_base(value: str) -> TrackOverridesBase:
    if value in TRACK_OVERRIDES_BASE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {TRACK_OVERRIDES_BASE_VALUES!r}")
