from typing import Literal

TableSpectrumPer = Literal["1/m", "rad/m"]

TABLE_SPECTRUM_PER_VALUES: set[TableSpectrumPer] = {
    "1/m",
    "rad/m",
}


def check_table_spectrum_per(value: str) -> TableSpectrumPer:
    if value in TABLE_SPECTRUM_PER_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {TABLE_SPECTRUM_PER_VALUES!r}")
