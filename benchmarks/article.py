"""The cases that are timed: the article's track, mesh and vehicle."""

from typing import Any

from solver.case import Case, Harmonic, Numerics, Slab
from solver.catalogue import TRACKS, VEHICLES

WAVE = Harmonic(wavelength=1.0, amplitude=3e-4)
SPEEDS_KMH = (160.0, 200.0, 250.0, 300.0, 350.0)


def article_case(speed_kmh: float = 350.0, slab: Slab = "continuous", **numerics: Any) -> Case:
    """The article's harmonic case: 140 m of track, 12 elements per pad, steps of 1e-4 s, unless told otherwise."""
    return Case(
        speed=speed_kmh / 3.6,
        slab=slab,
        irregularity=WAVE,
        track=TRACKS["crts2"].values,
        vehicle=VEHICLES["crh3"].values,
        numerics=Numerics(**numerics),
    )
