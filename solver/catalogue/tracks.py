"""Tracks."""

from dataclasses import replace

from solver.case import Track
from solver.catalogue.entry import Entry, Source, by_name, of_every_value

_SLAB_WIDTH, _SLAB_THICKNESS = 2.55, 0.20
_BASE_WIDTH, _BASE_THICKNESS = 2.95, 0.30
_RAIL = "one rail"
_PAD = "one pad"
_LAYER = "one rail, a metre of track"

COMMON = Source("in common use for CRTS II in the vehicle-track literature", "C")
RAIL = Source("rail section CHN60", "V")
PAD = Source(
    "in common use for CRTS II; also printed: 5.0e7 N/m with 3.625e4 N s/m, 4.0e7 with 5.2e4, 2.9e7 with 5.0e4", "C"
)
MORTAR = Source("in common use for CRTS II; also printed: 1.5e9 N/m^2 per rail", "C")
ROADBED = Source("in common use for CRTS II; whether it is meant per metre or per pad spacing is disputed", "C")
OURS = Source("assumed: no published value was found", "A")
SOFT = Source("assumed: half of crts2; the rail sinks 1.29 mm under a standing crh3", "A")

_SOURCES = {
    "rail_elastic_modulus": RAIL,
    "rail_second_moment": RAIL,
    "rail_mass": RAIL,
    "pad_stiffness": PAD,
    "pad_damping": PAD,
    "pad_spacing": Source("in common use for CRTS II; 0.625 to 0.65 m are printed", "C"),
    "slab_second_moment": Source(f"half of a slab {_SLAB_WIDTH} m wide and {_SLAB_THICKNESS} m thick", "C"),
    "mortar_stiffness": MORTAR,
    "base_second_moment": Source(f"half of a base {_BASE_WIDTH} m wide and {_BASE_THICKNESS} m thick", "C"),
    "roadbed_stiffness": ROADBED,
    "roadbed_damping": ROADBED,
    "joint": OURS,
    "joint.pads_per_slab": Source("slabs 6.45 m long, every 6.5 m", "C"),
}
_BASIS = {
    "rail_elastic_modulus": _RAIL,
    "rail_second_moment": _RAIL,
    "rail_mass": _RAIL,
    "pad_stiffness": _PAD,
    "pad_damping": _PAD,
    "pad_spacing": _RAIL,
    "slab_elastic_modulus": "slab",
    "slab_second_moment": "half slab",
    "slab_mass": "half slab",
    "base_elastic_modulus": "base",
    "base_second_moment": "half base",
    "base_mass": "half base",
    "joint": "half slab",
    "joint.pads_per_slab": _RAIL,
    "joint.position": _RAIL,
}


def _track(name: str, title: str, track: Track, **sources: Source) -> Entry[Track]:
    return Entry(
        name=name,
        title=title,
        values=track,
        provenance=of_every_value(track, COMMON, _SOURCES | sources),
        basis=of_every_value(track, _LAYER, _BASIS),
    )


_CRTS2 = Track(
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
)

TRACKS: dict[str, Entry[Track]] = by_name(
    _track("crts2", "CRTS II slab track with CHN60 rail", _CRTS2),
    _track(
        "crts2-soft",
        "CRTS II slab track with CHN60 rail on soft mortar and roadbed",
        replace(_CRTS2, mortar_stiffness=4.5e8, roadbed_stiffness=3.0e7),
        mortar_stiffness=SOFT,
        roadbed_stiffness=SOFT,
    ),
)
