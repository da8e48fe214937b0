"""Cars and wheel treads."""

from dataclasses import dataclass
from typing import Any

from solver.case import Vehicle
from solver.catalogue.entry import Entry, Source, by_name, of_every_value

BASIS = {
    "car_body_mass": "whole car body",
    "car_body_pitch_inertia": "whole car body",
    "bogie_mass": "one bogie frame",
    "bogie_pitch_inertia": "one bogie frame",
    "wheelset_mass": "one wheelset",
    "primary_stiffness": "one axle, both sides",
    "primary_damping": "one axle, both sides",
    "secondary_stiffness": "one bogie, both sides",
    "secondary_damping": "one bogie, both sides",
    "wheel_radius": "one wheel",
    "wheel_tread": "one wheel",
}
WORN = Source("assumed worn, as wheels in service are", "A")


def _car(name: str, title: str, source: Source, **values: Any) -> Entry[Vehicle]:
    vehicle = Vehicle(**values)
    return Entry(
        name=name,
        title=title,
        values=vehicle,
        provenance=of_every_value(vehicle, source, {"wheel_tread": WORN}),
        basis=of_every_value(vehicle, "car", BASIS),
    )


VEHICLES: dict[str, Entry[Vehicle]] = by_name(
    _car(
        "crh3",
        "CRH3 motor car",
        Source("in common use for the CRH3 in the vehicle-track literature", "C"),
        car_body_mass=40_000,
        car_body_pitch_inertia=5.47e5,
        bogie_mass=3200,
        bogie_pitch_inertia=6800,
        wheelset_mass=2400,
        primary_stiffness=2.08e6,
        primary_damping=1.0e5,
        secondary_stiffness=8.0e5,
        secondary_damping=1.2e5,
        half_bogie_distance=8.6875,
        half_wheelbase=1.25,
        wheel_radius=0.43,
    ),
    _car(
        "sv2014",
        "High-speed motor car (Shock and Vibration 2014)",
        Source("Shock and Vibration 2014, article 304219", "V"),
        car_body_mass=48_000,
        car_body_pitch_inertia=2.7e6,
        bogie_mass=3200,
        bogie_pitch_inertia=7200,
        wheelset_mass=2400,
        primary_stiffness=2.08e6,
        primary_damping=6.0e4,
        secondary_stiffness=8.0e5,
        secondary_damping=9.0e4,
        half_bogie_distance=8.6875,
        half_wheelbase=1.25,
        wheel_radius=0.46,
    ),
    _car(
        "sv2019",
        "High-speed car (Shock and Vibration 2019)",
        Source("Shock and Vibration 2019, article 2015465", "V"),
        car_body_mass=34_500,
        car_body_pitch_inertia=1.5604e6,
        bogie_mass=3500,
        bogie_pitch_inertia=1722,
        wheelset_mass=2200,
        primary_stiffness=1.173e6,
        primary_damping=1.96e4,
        secondary_stiffness=6.1e5,
        secondary_damping=9.8e3,
        half_bogie_distance=8.75,
        half_wheelbase=1.25,
        wheel_radius=0.43,
    ),
    _car(
        "velaro",
        "Siemens Velaro E (ICE 3, AVE S-103)",
        Source("TTB-2D, vehicle ICE3/AVE S103", "V"),
        car_body_mass=47_800,
        car_body_pitch_inertia=1.957888e6,
        bogie_mass=3500,
        bogie_pitch_inertia=1715,
        wheelset_mass=1800,
        primary_stiffness=2.4e6,
        primary_damping=2.0e4,
        secondary_stiffness=7.0e5,
        secondary_damping=4.0e4,
        half_bogie_distance=8.6875,
        half_wheelbase=1.25,
        wheel_radius=0.46,
    ),
)


@dataclass(frozen=True, kw_only=True)
class Tread:
    """The Hertz constant of a wheel on a rail, ``G = factor R^exponent`` in m/N^(2/3) with the radius R in m."""

    factor: float
    exponent: float


def _tread(name: str, title: str, factor: float, exponent: float) -> Entry[Tread]:
    tread = Tread(factor=factor, exponent=exponent)
    source = Source("in common use in the vehicle-track literature since Zhai's model of contact", "C")
    return Entry(
        name=name,
        title=title,
        values=tread,
        provenance=of_every_value(tread, source, {}),
        basis=of_every_value(tread, "one wheel", {}),
    )


TREADS: dict[str, Entry[Tread]] = by_name(
    _tread("worn", "Worn profile", 3.86e-8, -0.115),
    _tread("conical", "Conical profile", 4.57e-8, -0.149),
)
