from typing import Literal

PowerLawSpectrumSides = Literal[1, 2]

POWER_LAW_SPECTRUM_SIDES_VALUES: set[PowerLawSpectrumSides] = {
    1,
    2,
}


def check_power_law_spectrum_sides(value: int) -> PowerLawSpectrumSides:
    if value in POWER_LAW_SPECTRUM_SIDES_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {POWER_LAW_SPECTRUM_SIDES_VALUES!r}")
