"""What is solved: vehicle, track, irregularity and numerics of one case, in SI units, frozen and checked."""

import hashlib
import json
import math
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Literal, get_args

from solver.quantity import Checked, InvalidParameterError, quantity
from solver.railhead import (
    IRREGULARITY_KINDS,
    Dip,
    Harmonic,
    Irregularity,
    Measured,
    Profiles,
    Smooth,
    Spectral,
    Sum,
    irregularity_from_dict,
    irregularity_to_dict,
)

__all__ = [
    "IRREGULARITY_KINDS",
    "Case",
    "Dip",
    "Harmonic",
    "Irregularity",
    "Joint",
    "Measured",
    "Numerics",
    "Slab",
    "Smooth",
    "Spectral",
    "Sum",
    "Track",
    "Vehicle",
    "WheelTread",
]

CLEARANCE = 6.0  # m of track between the outer wheels and the absorbing ends
CLOSED_PADS = 30  # pads next to each end where joints are closed or only begin to open
MAX_PHASES = 2000  # steps from pad to pad: each has its own factors in memory
MIN_STEPS = 10  # steps per pad spacing and per shortest wavelength
MIN_ELEMENTS = 6  # elements per shortest bending wave of the rail, and for a joint's shape functions to fade

Slab = Literal["continuous", "discontinuous"]
WheelTread = Literal["worn", "conical"]


def _check_choice(parameter: str, value: object, choices: tuple[object, ...]) -> None:
    if value not in choices:
        raise InvalidParameterError(parameter, f"must be one of {', '.join(map(str, choices))}, is {value!r}")


@dataclass(frozen=True, kw_only=True)
class Vehicle(Checked):
    """A four-axle car with two suspension stages. Values are of the whole car; the model takes half of each."""

    _path = "vehicle."

    car_body_mass: float = quantity("kg", "mass of the car body", gt=0, le=1e6)
    car_body_pitch_inertia: float = quantity("kg m^2", "pitch inertia of the car body", gt=0, le=1e9)
    bogie_mass: float = quantity("kg", "mass of one bogie frame", gt=0, le=1e5)
    bogie_pitch_inertia: float = quantity("kg m^2", "pitch inertia of one bogie frame", gt=0, le=1e7)
    wheelset_mass: float = quantity("kg", "mass of one wheelset", gt=0, le=1e5)
    primary_stiffness: float = quantity("N/m", "primary suspension, vertical, per axle", gt=0, le=1e10)
    primary_damping: float = quantity("N s/m", "primary suspension, vertical, per axle", ge=0, le=1e8)
    secondary_stiffness: float = quantity("N/m", "secondary suspension, vertical, per bogie", gt=0, le=1e10)
    secondary_damping: float = quantity("N s/m", "secondary suspension, vertical, per bogie", ge=0, le=1e8)
    half_bogie_distance: float = quantity("m", "half the distance between bogie centres", gt=0, le=15)
    half_wheelbase: float = quantity("m", "half the distance between the axles of a bogie", gt=0, le=3)
    wheel_radius: float = quantity("m", "wheel radius", gt=0.1, le=1)
    wheel_tread: WheelTread = "worn"

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_choice("vehicle.wheel_tread", self.wheel_tread, get_args(WheelTread))
        if self.half_wheelbase >= self.half_bogie_distance:
            raise InvalidParameterError(
                "vehicle.half_wheelbase_m", f"must be less than half_bogie_distance_m = {self.half_bogie_distance:g} m"
            )


@dataclass(frozen=True, kw_only=True)
class Joint(Checked):
    """The joints between slabs: no moment passes, shear only through a spring and a damper.

    Pads stand at whole multiples of their spacing along the track, joints at ``(position + i pads_per_slab)`` spacings.
    """

    _path = "track.joint."

    shear_stiffness: float = quantity("N/m", "stiffness against a jump between slabs", ge=0, le=1e13, default=1.0e8)
    shear_damping: float = quantity("N s/m", "damping of a jump between slabs", ge=0, le=1e9, default=8.0e4)
    pads_per_slab: int = quantity("", "pads on every slab", ge=3, le=100, default=10)
    position: float = quantity(
        "", "place of a joint between two pads, as part of their spacing", gt=0, lt=1, default=0.5
    )


@dataclass(frozen=True, kw_only=True)
class Track(Checked):
    """Rail, slab and concrete base on a roadbed. Values are of one rail and half the slab and base."""

    _path = "track."

    rail_elastic_modulus: float = quantity("Pa", "Young's modulus of the rail", gt=0, le=1e13)
    rail_second_moment: float = quantity("m^4", "second moment of area of the rail", gt=0, le=1)
    rail_mass: float = quantity("kg/m", "rail mass per length", gt=0, le=1e4)
    pad_stiffness: float = quantity("N/m", "stiffness of one rail pad with its fastening", gt=0, le=1e12)
    pad_damping: float = quantity("N s/m", "damping of one rail pad with its fastening", ge=0, le=1e9)
    pad_spacing: float = quantity("m", "distance between pads", ge=0.01, le=2)
    slab_elastic_modulus: float = quantity("Pa", "Young's modulus of the slab", gt=0, le=1e13)
    slab_second_moment: float = quantity("m^4", "second moment of area of the half slab", gt=0, le=10)
    slab_mass: float = quantity("kg/m", "mass of the half slab per length", gt=0, le=1e5)
    mortar_stiffness: float = quantity("N/m^2", "stiffness of the CA mortar per length", gt=0, le=1e18)
    mortar_damping: float = quantity("N s/m^2", "damping of the CA mortar per length", ge=0, le=1e10)
    base_elastic_modulus: float = quantity("Pa", "Young's modulus of the concrete base", gt=0, le=1e13)
    base_second_moment: float = quantity("m^4", "second moment of area of the half base", gt=0, le=10)
    base_mass: float = quantity("kg/m", "mass of the half base per length", gt=0, le=1e5)
    roadbed_stiffness: float = quantity("N/m^2", "stiffness of the roadbed per length", gt=0, le=1e18)
    roadbed_damping: float = quantity("N s/m^2", "damping of the roadbed per length", ge=0, le=1e10)
    joint: Joint = field(default_factory=Joint)


@dataclass(frozen=True, kw_only=True)
class Numerics(Checked):
    """Mesh, step and observed time."""

    _path = "numerics."

    track_length: float = quantity("m", "length of track that moves with the vehicle", ge=90, le=1000, default=140.0)
    elements_per_pad: int = quantity("", "elements of each beam between two pads", ge=2, le=64, default=12)
    mesh_offset: float = quantity(
        "", "part of an element by which the mesh lies behind the first wheel", ge=0, lt=1, default=0.5
    )
    time_step: float = quantity(
        "s", "largest time step; the step used divides the time from pad to pad", ge=1e-6, le=1e-3, default=1e-4
    )
    start: float = quantity("m", "position of the first wheel on the track at the start", ge=-1e5, le=1e5, default=0.0)
    settle: float = quantity("s", "time computed and discarded before the window", ge=0.3, le=20, default=1.0)
    window: float = quantity("s", "steady window from which peaks are read", gt=0.01, le=60, default=3.0)
    ease_in: float = quantity("s", "time over which the irregularity grows to its full height", gt=0, le=5, default=0.2)
    spectral_radius: float = quantity(
        "", "spectral radius of the integrator at infinite frequency", ge=0, le=1, default=0.8
    )
    absorbing_length: float = quantity("m", "length of each absorbing end", ge=5, le=200, default=24.0)
    absorbing_damping: float = quantity(
        "N s/m^2", "damping of the whole track added at the very ends", ge=0, le=1e9, default=3e6
    )
    joint_blending: float = quantity(
        "", "pad spacings over which the shape functions of a joint fade", ge=0.5, le=3, default=2.0
    )


@dataclass(frozen=True, kw_only=True)
class Case(Checked):
    """One simulation."""

    speed: float = quantity("m/s", "speed of the train", ge=10 / 3.6, le=600 / 3.6)
    slab: Slab = "continuous"
    irregularity: Irregularity
    track: Track
    vehicle: Vehicle
    numerics: Numerics = field(default_factory=Numerics)

    def __post_init__(self) -> None:
        super().__post_init__()
        _check_choice("slab", self.slab, get_args(Slab))

        self._check_domain()
        self._check_step()
        self._check_mesh()

    @property
    def phases(self) -> int:
        """Time steps from pad to pad."""
        return max(1, math.ceil(self.track.pad_spacing / (self.speed * self.numerics.time_step) - 1e-9))

    @property
    def time_step(self) -> float:
        """The step used, s: the time from pad to pad divided by a whole number."""
        return self.track.pad_spacing / (self.speed * self.phases)

    @property
    def cells(self) -> int:
        """Pad spacings in the moving track."""
        return math.floor(self.numerics.track_length / self.track.pad_spacing + 1e-9)

    @property
    def absorbing_cells(self) -> int:
        """Pad spacings in each absorbing end."""
        return max(1, round(self.numerics.absorbing_length / self.track.pad_spacing))

    def _check_domain(self) -> None:
        overhang = self.vehicle.half_bogie_distance + self.vehicle.half_wheelbase + CLEARANCE
        ends = max(self.absorbing_cells, CLOSED_PADS * (self.slab == "discontinuous"))
        shortest = 2 * (overhang + ends * self.track.pad_spacing) + self.track.pad_spacing
        if self.cells * self.track.pad_spacing < shortest:
            raise InvalidParameterError(
                "numerics.track_length_m",
                f"must hold the vehicle, {CLEARANCE:g} m on either side and the absorbing ends: at least "
                f"{shortest + self.track.pad_spacing:.2f} m, is {self.numerics.track_length:g} m",
            )

    def _check_step(self) -> None:
        if self.phases > MAX_PHASES:
            raise InvalidParameterError(
                "numerics.time_step_s",
                f"must be at least {self.track.pad_spacing / (self.speed * MAX_PHASES):.3g} s at this speed "
                f"({MAX_PHASES} steps from pad to pad), is {self.numerics.time_step:g} s",
            )
        coarsest = min(self.track.pad_spacing, self.irregularity.shortest_wavelength) / MIN_STEPS
        if self.speed * self.time_step > coarsest:
            raise InvalidParameterError(
                "numerics.time_step_s",
                f"must be at most {coarsest / self.speed:.3g} s at this speed to resolve pads and irregularity "
                f"({MIN_STEPS} steps each), is {self.numerics.time_step:g} s",
            )

    def _check_mesh(self) -> None:
        t, n = self.track, self.numerics
        omega = 2 * math.pi * self.speed / min(t.pad_spacing, self.irregularity.shortest_wavelength)
        wave = 2 * math.pi * (t.rail_elastic_modulus * t.rail_second_moment / t.rail_mass / omega**2) ** 0.25
        fewest = MIN_ELEMENTS * t.pad_spacing / wave
        if self.slab == "discontinuous":
            fewest = max(fewest, MIN_ELEMENTS / n.joint_blending)
        if n.elements_per_pad < fewest - 1e-9:
            raise InvalidParameterError(
                "numerics.elements_per_pad",
                f"must be at least {math.ceil(fewest - 1e-9)} to resolve the bending waves of the rail and the joints "
                f"({MIN_ELEMENTS} elements each), is {n.elements_per_pad}",
            )

    def to_dict(self, *, samples: bool = True) -> dict[str, Any]:
        """Plain numbers, strings and dicts in SI units, from which :meth:`from_dict` gives an equal case.

        Parameters
        ----------
        samples : bool
            Whether measured profiles are written out, or only named by their digest.
        """
        irregularity = irregularity_to_dict(self.irregularity, samples=samples)
        operator = _operator(self.speed, self.slab, self.track, self.numerics)
        return {**operator, "irregularity": irregularity, "vehicle": dict(vars(self.vehicle))}

    @classmethod
    def from_dict(cls, data: dict[str, Any], profiles: Profiles | None = None) -> "Case":
        """The case of a :meth:`to_dict`.

        Parameters
        ----------
        data : dict
            The case.
        profiles : callable, optional
            Positions and heights of a measured profile by its digest, where they are not written out.
        """
        return cls(
            speed=data["speed"],
            slab=data["slab"],
            irregularity=irregularity_from_dict(data["irregularity"], profiles),
            track=Track(**data["track"] | {"joint": Joint(**data["track"]["joint"])}),
            vehicle=Vehicle(**data["vehicle"]),
            numerics=Numerics(**data["numerics"]),
        )

    def operator_key(self) -> str:
        """SHA-256 of what cases must share to be solved side by side: track, speed, slab, numerics, axle positions."""
        axles = self.vehicle.half_bogie_distance, self.vehicle.half_wheelbase
        return _operator_key(self.speed, self.slab, self.track, self.numerics, axles)

    def digest(self) -> str:
        """SHA-256, as 64 hexadecimal digits, of the canonical JSON: equal for equal physics, on any machine."""
        return _sha256(_without_joints(self.to_dict(samples=False)))


def _operator(speed: float, slab: Slab, track: Track, numerics: Numerics) -> dict[str, Any]:
    # Not dataclasses.asdict: it copies every number deeply, and studies have thousands of cases.
    joint = {"joint": dict(vars(track.joint))}
    return {"speed": speed, "slab": slab, "track": vars(track) | joint, "numerics": dict(vars(numerics))}


@lru_cache(maxsize=1024)
def _operator_key(speed: float, slab: Slab, track: Track, numerics: Numerics, axles: tuple[float, float]) -> str:
    return _sha256(_without_joints({**_operator(speed, slab, track, numerics), "axles": axles}))


def _without_joints(data: dict[str, Any]) -> dict[str, Any]:
    """Leave out what a continuous slab does not have."""
    if data["slab"] == "continuous":
        for part, unused in (("track", "joint"), ("numerics", "joint_blending")):
            data[part] = {name: value for name, value in data[part].items() if name != unused}
    return data


def _sha256(data: dict[str, Any]) -> str:
    canonical = json.dumps(data, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(canonical.encode()).hexdigest()
