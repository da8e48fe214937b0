"""Ready-made studies: those of the article, and some to begin with."""

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Preset:
    """A study to use as it is or to change.

    Attributes
    ----------
    title, description : str
        For people.
    study : dict
        What ``create_study`` takes.
    """

    title: str
    description: str
    study: dict[str, Any]


ARTICLE = "Lei, Xu, Xu, Jin and Wang (2023), Applied Sciences 13(11), 6566, doi:10.3390/app13116566"

_MESH = {"track_length_m": 140, "elements_per_pad": 12}
_SPEEDS = [160, 200, 250, 300, 350]
_SLABS = ["continuous", "discontinuous"]
_WAVE = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}
_SPECTRUM = {"kind": "spectrum", "spectrum": "tb3352-ballastless"}
_BAND = {"min": 2, "max": 30}


def _preset(title: str, description: str, window_s: float, **sweep: Any) -> Preset:
    study = {
        "name": title,
        "sweep": {"kind": "product", **sweep},
        "track": {"base": "crts2"},
        "vehicle": {"base": "crh3"},
        "numerics": _MESH | {"window_s": window_s},
    }
    return Preset(title=title, description=description, study=study)


def _article(title: str, what: str, window_s: float, **sweep: Any) -> Preset:
    return _preset(title, f"{what} From {ARTICLE}, which prints no parameters of track and car.", window_s, **sweep)


PRESETS: dict[str, Preset] = {
    "article-speed-continuous": _article(
        "Speeds on a continuous slab",
        "Five speeds over a sine wave of 1 m and 0.3 mm.",
        3,
        speed_kmh=_SPEEDS,
        slab=["continuous"],
        irregularity=_WAVE,
    ),
    "article-speed-discontinuous": _article(
        "Speeds on a jointed slab",
        "Five speeds over a sine wave of 1 m and 0.3 mm.",
        3,
        speed_kmh=_SPEEDS,
        slab=["discontinuous"],
        irregularity=_WAVE,
    ),
    "article-percentiles": _article(
        "Percentiles of the spectrum",
        "Three percentiles of the Chinese ballastless spectrum at 350 km/h on a jointed slab, 2 to 30 m (the article "
        "does not state the band).",
        5,
        speed_kmh=[350],
        slab=["discontinuous"],
        irregularity=_SPECTRUM | {"percentile": [25, 63.2, 90], "wavelength_band_m": [_BAND]},
    ),
    "article-wavelength-bands": _article(
        "Bands of wavelengths",
        "Five bands of the Chinese ballastless spectrum at 350 km/h on a jointed slab.",
        5,
        speed_kmh=[350],
        slab=["discontinuous"],
        irregularity=_SPECTRUM
        | {"percentile": [63.2], "wavelength_band_m": [{"min": low, "max": 30} for low in (2, 2.5, 3, 3.5, 4)]},
    ),
    "speed-sweep": _preset(
        "Speeds on both slabs",
        "From 160 to 350 km/h in steps of 10 km/h over a sine wave of 1 m and 0.3 mm, on both slabs.",
        3,
        speed_kmh={"kind": "range", "start": 160, "stop": 350, "step": 10},
        slab=_SLABS,
        irregularity=_WAVE,
    ),
    "pad-stiffness": _preset(
        "Stiffness of the pads",
        "Pads from 20 to 100 kN/mm at 300 km/h on both slabs, with eight realisations of the mean spectrum each.",
        5,
        speed_kmh=[300],
        slab=_SLABS,
        irregularity=_SPECTRUM | {"wavelength_band_m": [_BAND], "realisations": 8},
        vary={"track.pad_stiffness_n_per_m": [2e7, 3e7, 4e7, 6e7, 8e7, 1e8]},
    ),
    "joint-stiffness": _preset(
        "Stiffness of the joints between slabs",
        "From free ends to joints that pass nearly all shear, at 350 km/h over a sine wave of 1 m and 0.3 mm.",
        3,
        speed_kmh=[350],
        slab=["discontinuous"],
        irregularity=_WAVE,
        vary={"track.joint.shear_stiffness_n_per_m": [0, 1e6, 1e7, 1e8, 1e9, 1e10]},
    ),
}
