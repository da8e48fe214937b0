"""The quantities of which histories and peaks are given: units, conventions, and limits to compare them with."""

from dataclasses import dataclass
from typing import Literal

from solver.catalogue.entry import Source


@dataclass(frozen=True, kw_only=True)
class Limit:
    """A value that a quantity should not exceed, in the quantity's unit."""

    value: float
    applies: str
    source: Source


@dataclass(frozen=True, kw_only=True)
class Observable:
    """A quantity of which peaks are given.

    Attributes
    ----------
    name, title, unit : str
        Its name in results, for people, and its unit.
    convention : str
        Of what it is and which sign means what, where the title leaves that open.
    peak : {"magnitude", "maximum"}
        Whether its peak is the largest magnitude or the maximum.
    of : str
        The recorded quantity from which it is derived; empty if it is recorded itself.
    limits : tuple of Limit
        Values to compare it with.
    """

    name: str
    title: str
    unit: str
    convention: str = ""
    peak: Literal["magnitude", "maximum"] = "magnitude"
    of: str = ""
    limits: tuple[Limit, ...] = ()


def _limit(value: float, applies: str, text: str, mark: Literal["V", "C"]) -> Limit:
    return Limit(value=value, applies=applies, source=Source(text, mark))


_CHINA = "in common use in China for high-speed lines"
_FORCE = _limit(170e3, "wheel-rail force of one wheel", _CHINA, "C")
_UNLOADING = (
    _limit(0.65, "up to 160 km/h", "GB/T 5599", "V"),
    _limit(0.80, "above 160 km/h", "GB/T 5599", "V"),
)
_BODY = (
    _limit(2.5, "peak", "EN 14363", "V"),
    _limit(1.3, "peak", _CHINA, "C"),
)
_UNDER = "of the material under the first wheelset; positive downwards"
_MOVING = "of the point of the rail that moves with the first wheelset; positive downwards"
_DOWN = "positive downwards"
_ALL_PADS = "the largest of all pads under the train"
_ALL_JOINTS = "of the joint under the train where it is largest in magnitude"

OBSERVABLES: dict[str, Observable] = {
    each.name: each
    for each in (
        Observable(
            name="wheel_rail_force",
            title="Wheel-rail force",
            unit="N",
            convention="of one wheel; compression is positive",
            peak="maximum",
            limits=(_FORCE,),
        ),
        Observable(
            name="rail_displacement",
            title="Displacement of the rail",
            unit="m",
            convention=_UNDER,
            limits=(_limit(1.5e-3, "peak", _CHINA, "C"),),
        ),
        Observable(name="rail_acceleration", title="Acceleration of the rail", unit="m/s^2", convention=_UNDER),
        Observable(
            name="rail_acceleration_moving_frame",
            title="Acceleration of the rail in the moving frame",
            unit="m/s^2",
            convention=_MOVING,
        ),
        Observable(name="slab_displacement", title="Displacement of the slab", unit="m", convention=_UNDER),
        Observable(name="slab_acceleration", title="Acceleration of the slab", unit="m/s^2", convention=_UNDER),
        Observable(name="base_displacement", title="Displacement of the concrete base", unit="m", convention=_UNDER),
        Observable(
            name="base_acceleration", title="Acceleration of the concrete base", unit="m/s^2", convention=_UNDER
        ),
        Observable(
            name="slab_moment",
            title="Bending moment of the slab",
            unit="N m",
            convention="of half the slab; positive where the underside is stretched",
        ),
        Observable(
            name="roadbed_pressure",
            title="Reaction of the roadbed",
            unit="N/m",
            convention="of half the base per length of track, N/m; compression is positive",
        ),
        Observable(
            name="pad_force",
            title="Pad force",
            unit="N",
            convention=f"of one pad, {_ALL_PADS}; compression is positive",
            peak="maximum",
        ),
        Observable(
            name="pad_uplift",
            title="Pull on a pad",
            unit="N",
            convention=f"of one pad, {_ALL_PADS}; positive where the rail lifts off",
            peak="maximum",
        ),
        Observable(
            name="car_body_acceleration",
            title="Acceleration of the car body",
            unit="m/s^2",
            convention=_DOWN,
            limits=_BODY,
        ),
        Observable(name="bogie_acceleration", title="Acceleration of a bogie", unit="m/s^2", convention=_DOWN),
        Observable(name="wheelset_acceleration", title="Acceleration of a wheelset", unit="m/s^2", convention=_DOWN),
        Observable(name="joint_opening", title="Jump of displacement between slabs", unit="m", convention=_ALL_JOINTS),
        Observable(name="joint_slope_jump", title="Jump of slope between slabs", unit="rad", convention=_ALL_JOINTS),
        Observable(name="joint_shear", title="Shear force between slabs", unit="N", convention=_ALL_JOINTS),
        Observable(
            name="wheel_rail_force_20hz",
            title="Wheel-rail force below 20 Hz (EN 14363)",
            unit="N",
            convention="of one wheel; compression is positive",
            peak="maximum",
            of="wheel_rail_force",
            limits=(_FORCE,),
        ),
        Observable(
            name="wheel_unloading",
            title="Unloading of a wheel, as part of its static load (GB/T 5599)",
            unit="1",
            peak="maximum",
            of="wheel_rail_force",
            limits=_UNLOADING,
        ),
        Observable(
            name="contact_loss",
            title="Loss of contact: 1 while it lasts, its mean is the share of time",
            unit="1",
            peak="maximum",
            of="wheel_rail_force",
        ),
        Observable(
            name="car_body_acceleration_comfort",
            title="Acceleration of the car body from 0.4 to 10 Hz (EN 14363)",
            unit="m/s^2",
            convention=_DOWN,
            of="car_body_acceleration",
        ),
        Observable(
            name="wheel_rail_force_quantile",
            title="99.85 % quantile of the wheel-rail force (EN 14363)",
            unit="N",
            peak="maximum",
            of="wheel_rail_force",
        ),
        Observable(
            name="contact_loss_events",
            title="Number of losses of contact",
            unit="1",
            peak="maximum",
            of="wheel_rail_force",
        ),
        Observable(
            name="contact_loss_duration",
            title="Duration of a loss of contact",
            unit="s",
            peak="maximum",
            of="wheel_rail_force",
        ),
        Observable(
            name="wheel_rail_force_20hz_quantile",
            title="99.85 % quantile of the wheel-rail force below 20 Hz (EN 14363)",
            unit="N",
            peak="maximum",
            of="wheel_rail_force",
        ),
        Observable(
            name="sperling_index",
            title="Sperling's vertical ride index, of windows of 5 s (GB/T 5599)",
            unit="1",
            peak="maximum",
            of="car_body_acceleration",
            limits=(_limit(2.5, "grade 1", "GB/T 5599", "V"),),
        ),
    )
}
