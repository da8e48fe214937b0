"""Numba behind two typed decorators."""

from collections.abc import Callable
from typing import Any, TypeVar, cast

from numba import njit
from numba.extending import intrinsic

Function = TypeVar("Function", bound=Callable[..., Any])


def compiled(function: Function) -> Function:
    """Compile a function to machine code on its first call and keep the code on disk."""
    return cast(Function, njit(cache=True)(function))


def emitted(function: Callable[..., Any]) -> Callable[..., Any]:
    """An operation whose machine code is emitted by hand: ``function`` returns its signature and its generator."""
    return cast(Callable[..., Any], intrinsic(function))
