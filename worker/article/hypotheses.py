"""What could explain differences: each a change of the model, tried alone or with others, none adopted."""

import math
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from solver.catalogue import SPECTRA, TRACKS
from solver.spectrum import PowerLaw

NAME = "tb3352-ballastless"


def _own_spectrum(factor: float = 1.0, **changes: Any) -> dict[str, Any]:
    """The standard's spectrum, its densities multiplied and its convention changed."""
    standard = SPECTRA[NAME].values
    assert isinstance(standard, PowerLaw)  # noqa: S101 - for the type checker
    coefficients = tuple(factor * each for each in standard.coefficients)
    values = asdict(replace(standard, coefficients=coefficients, **changes))
    kept = ("per", "sides", "coefficients", "exponents", "breaks")
    return {"kind": "power-law"} | {name: list(v) if isinstance(v := values[name], tuple) else v for name in kept}


@dataclass(frozen=True, kw_only=True)
class Hypothesis:
    """A change of the model.

    Attributes
    ----------
    name : str
        For people.
    track, vehicle, numerics : dict
        What a study says of them in place of the defaults.
    spectrum : str or dict
        Of the random irregularity.
    """

    name: str
    track: dict[str, Any] = field(default_factory=dict)
    vehicle: dict[str, Any] = field(default_factory=dict)
    numerics: dict[str, Any] = field(default_factory=dict)
    spectrum: str | dict[str, Any] = NAME

    def model(self, numerics: dict[str, Any]) -> dict[str, Any]:
        """Track, vehicle and numerics of a study, given the numerics without the hypothesis."""
        return {"track": self.track, "vehicle": self.vehicle, "numerics": numerics | self.numerics}


def together(name: str, *hypotheses: Hypothesis) -> Hypothesis:
    """Several at once; of what two of them say, the later holds."""
    merged: dict[str, Any] = {"track": {}, "vehicle": {}, "numerics": {}, "spectrum": NAME}
    for each in hypotheses:
        for part in ("track", "vehicle", "numerics"):
            merged[part] = merged[part] | getattr(each, part)
        if each.spectrum != NAME:
            merged["spectrum"] = each.spectrum
    return Hypothesis(name=name, **merged)


def _joints(name: str, stiffness: float, damping: float = 8e4) -> Hypothesis:
    joint = {"shear_stiffness_n_per_m": stiffness, "shear_damping_ns_per_m": damping}
    return Hypothesis(name=name, track={"joint": joint})


def _pads(stiffness: float, damping: float) -> Hypothesis:
    pads = {"pad_stiffness_n_per_m": stiffness, "pad_damping_ns_per_m": damping}
    return Hypothesis(name=f"pads {stiffness / 1e6:g} kN/mm, {damping / 1e3:g} kN s/m", track=pads)


_LAYERS = TRACKS["crts2"].values
PER_RAD_FACTOR = math.sqrt(2 * math.pi)  # on the heights
AS_DESCRIBED = Hypothesis(name="as described")
PER_RAD = Hypothesis(name="spectrum per rad/m (heights × √2π)", spectrum=_own_spectrum(2 * math.pi))
SOFT = Hypothesis(name="soft mortar and roadbed (crts2-soft)", track={"base": "crts2-soft"})
SOFT_PADS = _pads(2.9e7, 5.0e4)
FREE = _joints("joints free (0 N/m)", 0.0, 0.0)

HYPOTHESES = (
    AS_DESCRIBED,
    PER_RAD,
    Hypothesis(name="spectrum two-sided (heights × √2)", spectrum=_own_spectrum(sides=2)),
    Hypothesis(name="spectrum a formula in rad/m", spectrum=_own_spectrum(per="rad/m")),
    SOFT,
    Hypothesis(
        name="mortar and roadbed values per pad",
        track={
            "mortar_stiffness_n_per_m2": _LAYERS.mortar_stiffness / _LAYERS.pad_spacing,
            "mortar_damping_ns_per_m2": _LAYERS.mortar_damping / _LAYERS.pad_spacing,
            "roadbed_stiffness_n_per_m2": _LAYERS.roadbed_stiffness / _LAYERS.pad_spacing,
            "roadbed_damping_ns_per_m2": _LAYERS.roadbed_damping / _LAYERS.pad_spacing,
        },
    ),
    Hypothesis(name="mortar 1.5e9 N/m²", track={"mortar_stiffness_n_per_m2": 1.5e9}),
    _pads(5.0e7, 3.625e4),
    _pads(4.0e7, 5.2e4),
    SOFT_PADS,
    FREE,
    _joints("joints 1e6 N/m", 1e6),
    _joints("joints 1e7 N/m", 1e7),
    _joints("joints 1e9 N/m", 1e9),
    _joints("joints 1e12 N/m (hinges)", 1e12),
    Hypothesis(name="conical tread", vehicle={"wheel_tread": "conical"}),
    Hypothesis(name="car sv2014", vehicle={"base": "sv2014"}),
    Hypothesis(name="car sv2019", vehicle={"base": "sv2019"}),
    Hypothesis(name="car velaro", vehicle={"base": "velaro"}),
    Hypothesis(name="hardly any numerical damping (spectral radius 0.98)", numerics={"spectral_radius": 0.98}),
    Hypothesis(name="no numerical damping", numerics={"spectral_radius": 1.0}),
    together("per rad/m and soft", PER_RAD, SOFT),
    together("per rad/m, soft and soft pads", PER_RAD, SOFT, SOFT_PADS),
    together("per rad/m, soft and free joints", PER_RAD, SOFT, FREE),
)
