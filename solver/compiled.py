"""Numba behind two typed decorators."""

import hashlib
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba
from numba import njit
from numba.extending import intrinsic

Function = TypeVar("Function", bound=Callable[..., Any])


def _cache_folder() -> Path:
    """Where compiled code is kept: one folder per state of the solver's sources.

    Numba looks at the file of a function to tell whether its compiled code is stale, not at the files of what the
    function calls. With one folder per state no code of another state can be met.
    """
    sources = hashlib.sha256(numba.__version__.encode())
    for path in sorted(Path(__file__).parent.glob("*.py")):
        sources.update(path.read_bytes())
    folder = Path.home() / ".cache" / "tracksweep" / sources.hexdigest()[:16]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        if not os.access(folder, os.W_OK):
            raise PermissionError(folder)
    except (OSError, RuntimeError):
        return Path(tempfile.mkdtemp(prefix="tracksweep-"))  # private and new: others may write where all may
    return folder


CACHE = _cache_folder()
numba.config.CACHE_DIR = str(CACHE)  # type: ignore[attr-defined]  # set at import of Numba


def compiled(function: Function) -> Function:
    """Compile a function to machine code on its first call and keep the code on disk.

    While it runs, other threads of Python may: they may hold locks of a database, and must not wait with them.
    """
    return cast(Function, njit(cache=True, nogil=True)(function))


def inlined(function: Function) -> Function:
    """The same for what is called for every node: its code becomes part of its callers'."""
    return cast(Function, njit(cache=True, forceinline=True)(function))


def emitted(function: Callable[..., Any]) -> Callable[..., Any]:
    """An operation whose machine code is emitted by hand: ``function`` returns its signature and its generator."""
    return cast(Callable[..., Any], intrinsic(function))
