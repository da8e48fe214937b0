"""Interleaved rounds: what slows the machine for a while slows all contenders alike."""

import time
from collections.abc import Callable, Mapping

import numpy as np


def interleave(actions: Mapping[str, Callable[[], int]], rounds: int) -> dict[str, list[float]]:
    """Seconds per unit of work of every action, round by round.

    Parameters
    ----------
    actions : mapping of str to callable
        Each does some work and returns how many units it was.
    rounds : int
    """
    seconds: dict[str, list[float]] = {name: [] for name in actions}
    for _ in range(rounds):
        for name, action in actions.items():
            start = time.perf_counter()
            units = action()
            seconds[name].append((time.perf_counter() - start) / units)
    return seconds


def medians(seconds: Mapping[str, list[float]]) -> dict[str, float]:
    """The median of every action."""
    return {name: float(np.median(values)) for name, values in seconds.items()}
