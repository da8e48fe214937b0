"""What must not matter: where the mesh lies, where the run starts, and from which end wheels are counted."""

from dataclasses import replace
from typing import Any

from solver.arrays import Array
from solver.block import Block
from solver.case import Case, Numerics
from solver.channels import CHANNELS, JOINTS
from solver.simulate import Response
from solver.verification.finding import Comparison, Finding, Row
from solver.verification.problems import (
    CONICAL,
    RANDOM,
    SINE,
    history,
    jointed,
    magnitude,
    make_case,
    over_one_repeat,
    solved,
)

TOLERANCE = 0.002
# Pads that pass from element to element make the rail, and less so the slab, hum near half the sampling rate.
HUMMING = {"rail_acceleration": 0.015, "slab_acceleration": 0.01}
QUANTITIES = (
    "wheel_rail_force",
    "rail_displacement",
    "rail_acceleration",
    "slab_displacement",
    "slab_acceleration",
    "base_displacement",
    "base_acceleration",
)


def _rows(what: str, ours: Response, expected: Response) -> list[Row]:
    return [
        Comparison(
            what=f"{quantity} peak, {what}",
            ours=magnitude(history(ours, quantity)),
            expected=magnitude(history(expected, quantity)),
            tolerance=HUMMING.get(quantity, TOLERANCE),
            unit=channel.unit,
        )
        for quantity in QUANTITIES
        for channel in CHANNELS
        if (channel.quantity, channel.position) == (quantity, "wheelset_1")
    ]


def _jointed_cases(numerics: Numerics) -> dict[str, Case]:
    return {
        "sine": make_case(**jointed(), irregularity=SINE, numerics=numerics),
        "random": make_case(**jointed(), irregularity=RANDOM, numerics=numerics),
    }


def mesh(**numerics: Any) -> Finding:
    """The mesh shifted by parts of an element, at 350 km/h with joints."""
    base = over_one_repeat(350, **numerics)
    rows: list[Row] = []
    for offset in (0.2, 0.8):
        for name, case in _jointed_cases(base).items():
            shifted = replace(case, numerics=replace(base, mesh_offset=offset))
            rows += _rows(f"{name}, mesh at {offset:g} elements instead of 0.5", *solved([shifted, case]))
    return Finding(rows=rows)


def track(**numerics: Any) -> Finding:
    """The run starts a part of a pad spacing earlier, over the same track, and is observed at the same place."""
    base = over_one_repeat(350, **numerics)
    rows: list[Row] = []
    for name, case in _jointed_cases(base).items():
        for part in (0.3, 0.77):
            earlier = part * case.track.pad_spacing
            moved = replace(base, start=base.start - earlier, settle=base.settle + earlier / case.speed)
            rows += _rows(
                f"{name}, pads and joints shifted by {part:g} spacings",
                *solved([replace(case, numerics=moved), case]),
            )
    return Finding(rows=rows)


class _Backwards(Block):
    """The vehicle runs backwards: its first wheelset is the last on the track."""

    def axles(self) -> Array:
        """Positions of the wheelsets, m."""
        return super().axles()[::-1].copy()


def backwards() -> Finding:
    """A symmetric vehicle does not feel which way round it is."""
    numerics = replace(over_one_repeat(350), elements_per_pad=6, track_length=110.0, settle=0.4, window=0.1)
    case = make_case(**jointed(), vehicle=CONICAL, irregularity=RANDOM, numerics=numerics)
    forwards, other = Block([case]), _Backwards([case])
    ours, theirs = (block.advance(block.steps)[block.settle_steps :, 0] for block in (other, forwards))
    rows: list[Row] = [
        Comparison(
            what=f"force on the wheelset in place {place + 1}",
            ours=magnitude(ours[:, 3 - place]),
            expected=magnitude(theirs[:, place]),
            tolerance=TOLERANCE,
            unit="N",
        )
        for place in range(4)
    ]
    rows.append(
        Comparison(
            what="largest jump of a joint",
            ours=magnitude(ours[:, JOINTS]),
            expected=magnitude(theirs[:, JOINTS]),
            tolerance=TOLERANCE,
            unit="m",
        )
    )
    return Finding(rows=rows)
