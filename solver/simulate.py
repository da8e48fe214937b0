"""The one door of the solver: cases in, responses out."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from solver.arrays import Array
from solver.block import Block, lane_width
from solver.case import Case
from solver.channels import CHANNELS, JOINTS, Channel
from solver.errors import DivergedError, SolverError

CHUNK = 400  # steps between two reports of progress


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
    time: Array
    track_position: Array
    channels: tuple[Channel, ...]
    values: Array
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
    groups: dict[str, list[int]] = defaultdict(list)
    for index, case in enumerate(cases):
        groups[case.operator_key()].append(index)
    blocks = [block for group in groups.values() for block in _blocks(group)]
    outcomes: dict[int, Response | SolverError] = {}
    for number, indices in enumerate(blocks):

        def report(fraction: float, number: int = number) -> None:
            if on_progress is not None:
                on_progress((number + fraction) / len(blocks))

        chosen = [cases[index] for index in indices]
        outcomes.update(zip(indices, _attempt(chosen, report), strict=True))
    return [outcomes[index] for index in range(len(cases))]


def _blocks(group: list[int]) -> Iterator[list[int]]:
    """Parts of a group that are marched one after the other."""
    while group:
        lanes = lane_width(len(group))
        yield group[:lanes]
        group = group[lanes:]


def _attempt(cases: Sequence[Case], report: Progress) -> list[Response | SolverError]:
    """Solve the cases of a block, or say why it cannot be built."""
    try:
        block = Block(cases, lane_width(len(cases)))
    except SolverError as error:
        return [error] * len(cases)
    return _run(block, len(cases), report)


def _run(block: Block, count: int, report: Progress) -> list[Response | SolverError]:
    """March a block to its end and cut out the window of its first ``count`` lanes."""
    values = np.empty((count, len(CHANNELS), block.window_steps))
    report(0.0)
    while block.done < block.steps and not block.state.failed.all():
        first = block.done
        out = block.advance(CHUNK)
        begin = first - block.settle_steps
        kept = out[max(0, -begin) :, :count]
        values[:, :, max(0, begin) : max(0, begin) + len(kept)] = kept.transpose(1, 2, 0)
        report(block.done / block.steps)
    step = np.arange(1, block.window_steps + 1)
    recorded = JOINTS if block.case.slab == "continuous" else len(CHANNELS)
    position = block.track_position(block.settle_steps + step)
    return [
        DivergedError("the response grew without bounds; a shorter time step or another integrator may hold it")
        if block.state.failed[lane]
        else Response(
            case=block.cases[lane],
            time=step * block.case.time_step,
            track_position=position,
            channels=CHANNELS[:recorded],
            values=values[lane, :recorded],
            time_step=block.case.time_step,
        )
        for lane in range(count)
    ]
