from typing import Literal

RationalSpectrumPer = Literal["1/m", "rad/m"]

RATIONAL_SPECTRUM_PER_VALUES: set[RationalSpectrumPer] = {
    "1/m",
    "rad/m",
}


def check_rational_spectrum_per(value: str) -> RationalSpectrumPer:
    if value in RATIONAL_SPECTRUM_PER_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {RATIONAL_SPECTRUM_PER_VALUES!r}")
