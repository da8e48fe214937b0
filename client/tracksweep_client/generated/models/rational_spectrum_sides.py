from typing import Literal

RationalSpectrumSides = Literal[1, 2]

RATIONAL_SPECTRUM_SIDES_VALUES: set[RationalSpectrumSides] = {
    1,
    2,
}


def check_rational_spectrum_sides(value: int) -> RationalSpectrumSides:
    if value in RATIONAL_SPECTRUM_SIDES_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {RATIONAL_SPECTRUM_SIDES_VALUES!r}")
