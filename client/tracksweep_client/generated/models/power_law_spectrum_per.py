from typing import Literal

PowerLawSpectrumPer = Literal["1/m", "rad/m"]

POWER_LAW_SPECTRUM_PER_VALUES: set[PowerLawSpectrumPer] = {
    "1/m",
    "rad/m",
}


def check_power_law_spectrum_per(value: str) -> PowerLawSpectrumPer:
    if value in POWER_LAW_SPECTRUM_PER_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {POWER_LAW_SPECTRUM_PER_VALUES!r}")
