"""Standard problems shared by the solver's tests."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import settings

from solver.case import Case, Harmonic, Numerics
from solver.catalogue import TRACKS, VEHICLES

settings.register_profile("tracksweep", deadline=None)  # a first call compiles
settings.load_profile("tracksweep")

QUICK = Numerics(track_length=95.0, elements_per_pad=6, settle=0.4, window=0.3)


@pytest.fixture
def make_case() -> Callable[..., Case]:
    """A quick case of the catalogue's train and track; keywords replace its parts."""

    def make(**parts: Any) -> Case:
        values: dict[str, Any] = {
            "speed": 350 / 3.6,
            "irregularity": Harmonic(wavelength=1.0, amplitude=3e-4),
            "track": TRACKS["crts2"].values,
            "vehicle": VEHICLES["crh3"].values,
            "numerics": QUICK,
        }
        return Case(**values | parts)

    return make


@pytest.fixture
def conical_vehicle() -> Any:
    return replace(VEHICLES["crh3"].values, wheel_tread="conical")
