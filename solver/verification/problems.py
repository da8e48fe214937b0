"""Problems that the checks share, and how their answers are read."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from solver.arrays import Array
from solver.case import Case, Harmonic, Joint, Numerics, Spectral
from solver.catalogue import TRACKS, VEHICLES
from solver.errors import SolverError
from solver.simulate import Response, solve

TRACK = TRACKS["crts2"].values
SMEARABLE = replace(TRACK, pad_spacing=0.625)
WORN = VEHICLES["crh3"].values
CONICAL = replace(WORN, wheel_tread="conical")
SINE = Harmonic(wavelength=1.0, amplitude=3e-4)
RANDOM = Spectral(wavelength_min=2.0, wavelength_max=30.0)
QUICK = Numerics(track_length=95.0, elements_per_pad=6, settle=0.4, window=0.3)
REPEAT_M = 13.0  # m after which pads, joints and the sine of 1 m repeat


def make_case(**parts: Any) -> Case:
    """The catalogue's train and track at 350 km/h over a sine; keywords replace its parts."""
    values: dict[str, Any] = {
        "speed": 350 / 3.6,
        "irregularity": SINE,
        "track": TRACK,
        "vehicle": CONICAL,
        "numerics": Numerics(settle=0.8, window=0.5),
    }
    return Case(**values | parts)


def jointed(shear_stiffness: float = 1e8, shear_damping: float = 8e4, **track: float) -> dict[str, Any]:
    """Parts of a case whose slab has joints."""
    joint = Joint(shear_stiffness=shear_stiffness, shear_damping=shear_damping)
    return {"slab": "discontinuous", "track": replace(TRACK, joint=joint, **track)}


def over_one_repeat(speed_kmh: float, **numerics: Any) -> Numerics:
    """Numerics whose window is the time in which pads, joints and the sine repeat."""
    return Numerics(**{"settle": 0.8, "window": 1.001 * REPEAT_M * 3.6 / speed_kmh} | numerics)


def solved(cases: Sequence[Case]) -> list[Response]:
    """Responses of cases that must not fail."""
    results = solve(cases)
    for result in results:
        if isinstance(result, SolverError):
            raise result
    return [result for result in results if isinstance(result, Response)]


def history(response: Response, quantity: str, position: str = "wheelset_1") -> Array:
    """One channel of a response."""
    names = [(channel.quantity, channel.position) for channel in response.channels]
    return response.values[names.index((quantity, position))]


def magnitude(values: Array) -> float:
    """Largest magnitude."""
    return float(np.abs(values).max())
