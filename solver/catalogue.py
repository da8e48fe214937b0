"""Named vehicles, tracks and spectra, each with its source and how sure we are of it.

Marks: ``V`` the value was read in the named source; ``C`` the value is in common use in this literature and
its primary source was not seen.
"""

from dataclasses import dataclass
from typing import Generic, Literal, TypeVar

from solver.case import Track, Vehicle

Mark = Literal["V", "C"]
T = TypeVar("T")


@dataclass(frozen=True, kw_only=True)
class PowerLaw:
    """A one-sided spatial power spectral density ``S(f) = A / f**k``, piecewise.

    Attributes
    ----------
    coefficients : tuple of float
        A of each piece, such that S is in m^2/(1/m) with f in 1/m.
    exponents : tuple of float
        k of each piece.
    breaks : tuple of float
        Frequencies in 1/m between the pieces.
    wavelength_range : tuple of float
        Shortest and longest wavelength, m, for which the spectrum was drawn up.
    speed_range_kmh : tuple of float
        Lowest and highest speed for which it was drawn up.
    """

    coefficients: tuple[float, ...]
    exponents: tuple[float, ...]
    breaks: tuple[float, ...]
    wavelength_range: tuple[float, float]
    speed_range_kmh: tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class Entry(Generic[T]):
    """A named set of values with its provenance."""

    name: str
    title: str
    values: T
    source: str
    mark: Mark
    basis: str


def _by_name(*entries: Entry[T]) -> dict[str, Entry[T]]:
    return {entry.name: entry for entry in entries}


VEHICLES: dict[str, Entry[Vehicle]] = _by_name(
    Entry(
        name="crh3",
        title="CRH3 motor car",
        values=Vehicle(
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
        source="values in common use for the CRH3 in the vehicle-track literature",
        mark="C",
        basis="whole car; suspensions per axle and per bogie",
    )
)

_SLAB_WIDTH, _SLAB_THICKNESS = 2.55, 0.20
_BASE_WIDTH, _BASE_THICKNESS = 2.95, 0.30

TRACKS: dict[str, Entry[Track]] = _by_name(
    Entry(
        name="crts2",
        title="CRTS II slab track with CHN60 rail",
        values=Track(
            rail_elastic_modulus=2.059e11,
            rail_second_moment=3.217e-5,
            rail_mass=60.64,
            pad_stiffness=6.0e7,
            pad_damping=4.77e4,
            pad_spacing=0.65,
            slab_elastic_modulus=3.9e10,
            slab_second_moment=_SLAB_WIDTH / 2 * _SLAB_THICKNESS**3 / 12,
            slab_mass=637.5,
            mortar_stiffness=9.0e8,
            mortar_damping=8.3e4,
            base_elastic_modulus=3.0e10,
            base_second_moment=_BASE_WIDTH / 2 * _BASE_THICKNESS**3 / 12,
            base_mass=1106.25,
            roadbed_stiffness=6.0e7,
            roadbed_damping=9.0e4,
        ),
        source="CHN60 rail section; other values in common use for CRTS II in the vehicle-track literature",
        mark="C",
        basis="one rail and half of slab and base; layers per metre of track",
    )
)

SPECTRA: dict[str, Entry[PowerLaw]] = _by_name(
    Entry(
        name="tb3352-ballastless",
        title="Vertical profile of ballastless high-speed track, mean spectrum (63.2 %)",
        values=PowerLaw(
            coefficients=tuple(a * 1e-6 for a in (1.0544e-5, 3.5588e-3, 1.9784e-2, 3.9488e-4)),  # mm^2 to m^2
            exponents=(3.3891, 1.9271, 1.3643, 3.4516),
            breaks=(0.0187, 0.0474, 0.1533),
            wavelength_range=(2.0, 200.0),
            speed_range_kmh=(300.0, 350.0),
        ),
        source="TB/T 3352-2014, table of the vertical channel",
        mark="V",
        basis="one-sided, per 1/m; amplitudes at percentile p scale with sqrt(-ln(1 - p))",
    )
)
