"""Compiling ahead of the first case."""

import fcntl
from collections.abc import Iterator
from contextlib import contextmanager

from solver.block import Block
from solver.case import Case, Numerics, Smooth
from solver.catalogue import TRACKS, VEHICLES
from solver.compiled import CACHE
from solver.simd import MAX_LANES


def warm() -> None:
    """Compile what every case needs, or load it if it is kept already.

    Processes that start together share the work: each begins with what no other is at.
    """
    case = Case(
        speed=100.0,
        slab="discontinuous",
        irregularity=Smooth(),
        track=next(iter(TRACKS.values())).values,
        vehicle=next(iter(VEHICLES.values())).values,
        numerics=Numerics(track_length=90.0, elements_per_pad=6, settle=0.3, window=0.1),
    )
    left = [1, MAX_LANES]
    while left:
        width = next((width for width in left if _is_free(width)), left[0])
        with _alone(width):
            Block([case], width).advance(1)
        left.remove(width)


@contextmanager
def _alone(width: int, *, wait: bool = True) -> Iterator[None]:
    with (CACHE / f"{width}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield


def _is_free(width: int) -> bool:
    try:
        with _alone(width, wait=False):
            return True
    except BlockingIOError:
        return False
