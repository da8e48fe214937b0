"""Against finite elements that stay with the track, with true double nodes at the joints."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from solver.arrays import Array
from solver.case import Case, Numerics
from solver.channels import ALL_JOINTS, ALL_PADS, WHEELSETS
from solver.reference.track_fixed import TrackFixedResponse, solve_track_fixed
from solver.simulate import Response
from solver.verification.finding import Bound, Comparison, Curve, Finding, Plot, Row
from solver.verification.problems import (
    RANDOM,
    SINE,
    history,
    jointed,
    magnitude,
    make_case,
    over_one_repeat,
    solved,
)

FORCE, RAIL, LAYERS, LOCAL = 0.005, 0.01, 0.02, 0.02  # tolerances
MEASURES: dict[str, Callable[[Array], Any]] = {"max": np.max, "min": np.min, "σ": np.std, "peak": magnitude}
QUANTITIES: tuple[tuple[str, str, str, float, tuple[str, ...]], ...] = (
    ("wheel_rail_force", WHEELSETS[0], "force", FORCE, ("max", "min", "σ")),
    ("rail_displacement", WHEELSETS[0], "rail_displacement", RAIL, ("max", "min")),
    ("rail_acceleration", WHEELSETS[0], "rail_acceleration", RAIL, ("peak",)),
    ("slab_acceleration", WHEELSETS[0], "slab_acceleration", LAYERS, ("peak",)),
    ("base_acceleration", WHEELSETS[0], "base_acceleration", LAYERS, ("peak",)),
    ("roadbed_pressure", WHEELSETS[0], "roadbed_pressure", LOCAL, ("max",)),
    ("pad_force", ALL_PADS, "pad_force", LOCAL, ("max",)),
    ("pad_uplift", ALL_PADS, "pad_uplift", LOCAL, ("max",)),
    ("joint_opening", ALL_JOINTS, "joint_jump", LOCAL, ("peak",)),
    ("slab_moment", ALL_JOINTS, "slab_moment", LOCAL, ("peak",)),
)


def quick() -> Finding:
    """One jointed case with half the elements."""
    numerics = Numerics(track_length=120.0, elements_per_pad=6, settle=0.3, window=0.134)
    return compare(make_case(**jointed(), irregularity=SINE, numerics=numerics))


def harmonic(speed_kmh: float, shear_stiffness: float, amplitude: float = 3e-4, pad_stiffness: float = 6e7) -> Finding:
    """A case over the sine of 1 m, in the time in which pads, joints and sine repeat."""
    return compare(
        make_case(
            **jointed(shear_stiffness, pad_stiffness=pad_stiffness),
            speed=speed_kmh / 3.6,
            irregularity=replace(SINE, amplitude=amplitude),
            numerics=over_one_repeat(speed_kmh, track_length=200.0),
        )
    )


def random(speed_kmh: float, shear_stiffness: float, percentile: float = 63.2, pad_stiffness: float = 6e7) -> Finding:
    """A case over a random irregularity."""
    return compare(
        make_case(
            **jointed(shear_stiffness, pad_stiffness=pad_stiffness),
            speed=speed_kmh / 3.6,
            irregularity=replace(RANDOM, percentile=percentile),
            # Accelerations of a few m/s2 hum as pads or wheels pass from element to element, in both models.
            numerics=over_one_repeat(speed_kmh, elements_per_pad=24, time_step=5e-5),
        )
    )


def continuous(speed_kmh: float) -> Finding:
    """A case without joints."""
    numerics = Numerics(settle=0.8, window=0.4)
    return compare(make_case(speed=speed_kmh / 3.6, irregularity=SINE, numerics=numerics))


def compare(case: Case) -> Finding:
    """All that both models give of a case."""
    (moving,), fixed = solved([case]), solve_track_fixed(case)
    rows: list[Row] = []
    for quantity, position, name, tolerance, measures in QUANTITIES:
        if position == ALL_JOINTS and case.slab == "continuous":
            continue
        ours, theirs = history(moving, quantity, position), _of(fixed, name)
        unit = next(channel.unit for channel in moving.channels if channel.quantity == quantity)
        rows += [
            Comparison(
                what=f"{quantity} {measure}",
                ours=float(MEASURES[measure](ours)),
                expected=float(MEASURES[measure](theirs)),
                tolerance=tolerance,
                unit=unit,
            )
            for measure in measures
        ]
    return Finding(rows=rows, plots=[_plot(case, moving, fixed)])


def _of(fixed: TrackFixedResponse, name: str) -> Array:
    values: Array = getattr(fixed, name)
    return values[0] if name == "force" else values


def _plot(case: Case, moving: Response, fixed: TrackFixedResponse) -> Plot:
    shown = moving.time < min(0.06, moving.time[-1])
    theirs = fixed.time < shown.sum() * moving.time_step
    return Plot(
        x_label="position of the first wheelset, m",
        y_label="slab acceleration under it, m/s²",
        curves=(
            Curve(label="fixed to the track", x=fixed.track_position[theirs], y=fixed.slab_acceleration[theirs]),
            Curve(
                label="moving elements",
                x=moving.track_position[shown],
                y=history(moving, "slab_acceleration")[shown],
                style="--",
            ),
        ),
    )


def free_and_hinged() -> Finding:
    """Joints without shear transfer are free ends; joints that shear rigidly are hinges, not a continuous slab."""
    numerics = over_one_repeat(350, track_length=200.0)
    free, soft, hinge, rigid = solved(
        [
            make_case(**jointed(stiffness, 0.0), irregularity=SINE, numerics=numerics)
            for stiffness in (0.0, 1e4, 1e11, 1e12)
        ]
    )
    (whole,) = solved([make_case(irregularity=SINE, numerics=numerics)])
    rows: list[Row] = []
    for quantity in ("rail_displacement", "slab_acceleration", "wheel_rail_force"):
        for name, near, limit in (("1e4 and 0", soft, free), ("1e11 and 1e12", hinge, rigid)):
            rows.append(
                Comparison(
                    what=f"{quantity}, joints of {name} N/m",
                    ours=magnitude(history(near, quantity)),
                    expected=magnitude(history(limit, quantity)),
                    tolerance=0.01,
                )
            )
    for name, ours, stiffness in (("free", free, 0.0), ("hinged", rigid, 1e12)):
        fixed = solve_track_fixed(make_case(**jointed(stiffness, 0.0), irregularity=SINE, numerics=numerics))
        for quantity, theirs, tolerance in (
            ("wheel_rail_force", fixed.force[0], FORCE),
            ("rail_displacement", fixed.rail_displacement, RAIL),
            ("slab_acceleration", fixed.slab_acceleration, LAYERS),
        ):
            rows.append(
                Comparison(
                    what=f"{quantity}, {name} joints, against double nodes",
                    ours=magnitude(history(ours, quantity)),
                    expected=magnitude(theirs),
                    tolerance=tolerance,
                )
            )
    hinged, unbroken = (magnitude(history(each, "slab_acceleration")) for each in (rigid, whole))
    rows.append(Bound(what="slab acceleration, hinged over continuous", ours=hinged / unbroken, low=1.05))
    return Finding(rows=rows)
