from typing import Literal

ProductSweepSlabItem = Literal["continuous", "discontinuous"]

PRODUCT_SWEEP_SLAB_ITEM_VALUES: set[ProductSweepSlabItem] = {
    "continuous",
    "discontinuous",
}


def check_product_sweep_slab_item(value: str) -> ProductSweepSlabItem:
    if value in PRODUCT_SWEEP_SLAB_ITEM_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {PRODUCT_SWEEP_SLAB_ITEM_VALUES!r}")
