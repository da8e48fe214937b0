from typing import Literal

TableSpectrumSides = Literal[1, 2]

TABLE_SPECTRUM_SIDES_VALUES: set[TableSpectrumSides] = {
    1,
    2,
}


def check_table_spectrum_sides(value: int) -> TableSpectrumSides:
    if value in TABLE_SPECTRUM_SIDES_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {TABLE_SPECTRUM_SIDES_VALUES!r}")
