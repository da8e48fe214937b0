"""The one array type of the solver; docstrings give shapes, and dtypes where they are not double."""

from typing import Any, TypeAlias

from numpy.typing import NDArray

Array: TypeAlias = NDArray[Any]
