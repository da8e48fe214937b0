"""The one array type of the solver; docstrings give shapes, and dtypes where they are not double."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[Any]
CACHE_LINE = 64  # bytes, and the widest vector register


def aligned_zeros(shape: tuple[int, ...]) -> Array:
    """Zeros that begin at a cache line, so that no vector of lanes lies across two of them."""
    size = int(np.prod(shape))
    room = np.zeros(size + CACHE_LINE // 8)
    first = -room.ctypes.data % CACHE_LINE // 8
    return room[first : first + size].reshape(shape)
