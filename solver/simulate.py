"""The one door of the solver: cases in, responses out."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from solver.case import Case


class SolverError(Exception):
    """A case that cannot be solved. ``code`` is stable and names the reason."""

    code = "solver-error"


class DivergedError(SolverError):
    """The response of a case grew beyond all bounds or stopped being a number."""

    code = "diverged"


@dataclass(frozen=True, kw_only=True)
class Channel:
    """What one column of a response holds."""

    quantity: str
    position: str
    unit: str


@dataclass(frozen=True, kw_only=True)
class Response:
    """Histories of one case over its steady window.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Time since the window began, s.
    track_position : ndarray, shape (n,)
        Position of the first wheelset along the track, m.
    channels : tuple of Channel
    values : ndarray, shape (len(channels), n)
        In the channels' units, SI.
    time_step : float
        The step used, s.
    """

    case: Case
    time: NDArray[np.float64]
    track_position: NDArray[np.float64]
    channels: tuple[Channel, ...]
    values: NDArray[np.float64]
    time_step: float


Progress = Callable[[float], None]


def solve(cases: Sequence[Case], on_progress: Progress | None = None) -> list[Response | SolverError]:
    """Solve cases together.

    Parameters
    ----------
    cases : sequence of Case
        Any cases; those that share the track operator are marched side by side.
    on_progress : callable, optional
        Called with the fraction done, 0 to 1, several times a second. What it raises ends the solve.

    Returns
    -------
    list of Response or SolverError
        One per case, in their order: a case that fails does not take its neighbours with it.
    """
    raise NotImplementedError
