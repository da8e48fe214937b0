from typing import Literal

ZipSweepSlabItem = Literal["continuous", "discontinuous"]

ZIP_SWEEP_SLAB_ITEM_VALUES: set[ZipSweepSlabItem] = {
    "continuous",
    "discontinuous",
}


def check_zip_sweep_slab_item(value: str) -> ZipSweepSlabItem:
    if value in ZIP_SWEEP_SLAB_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {ZIP_SWEEP_SLAB_ITEM_VALUES!r}")
