"""What is computed: studies as the service takes them, by name.

The presets are the article's own studies, as fine as it describes them. All others are coarse; what they share with the
presets shows that this is fine enough for what is read from them.
"""

from collections.abc import Iterator
from typing import Any

from app.studies.sweep.vary import PARAMETERS
from solver.catalogue import TRACKS, VEHICLES
from worker.article.hypotheses import AS_DESCRIBED, HYPOTHESES, Hypothesis
from worker.article.reported import BANDS_M, LONGEST_M, PERCENTILES, SPEEDS_KMH, TABLE_1_BAND_M

Study = dict[str, Any]

PRESETS = {
    "continuous": "article-speed-continuous",
    "discontinuous": "article-speed-discontinuous",
    "percentiles": "article-percentiles",
    "bands": "article-wavelength-bands",
}
COARSE = {"track_length_m": 100, "elements_per_pad": 6, "time_step_s": 2e-4, "settle_s": 0.5}
FINER = COARSE | {"time_step_s": 1e-4}  # where the wheel nearly lifts off, the rail's acceleration needs it
COARSEST = {"track_length_m": 100, "elements_per_pad": 4, "time_step_s": 4e-4}  # for forces and deflections only
REPEAT_S = 13.0 / (SPEEDS_KMH[0] / 3.6)  # in 13 m pads, joints and the wave of 1 m repeat
RANDOM_S, PARAMETER_S = 5.0, 1.5
SLABS = ["continuous", "discontinuous"]

REALISATIONS = 64
REALISATIONS_OF_A_HYPOTHESIS = 2
REALISATIONS_OF_A_PARAMETER = 7  # and a wave: eight cases are computed side by side
CHANGE = 0.1  # of every parameter, up and down

FINE_SPEEDS = {"kind": "range", "start": 100, "stop": 400, "step": 5}
WAVELENGTHS_M = [0.5, 0.575, 0.65, 0.75, 0.87, 1.0, 1.15, 1.3, 1.5, 1.75, 2.0, 2.3, 2.65, 3.0, 3.5, 4.0]
AMPLITUDE_MM = 0.3

# Percentile and shortest wavelength of every row of Tables 1 and 2.
CONDITIONS = [(percentile, TABLE_1_BAND_M) for percentile in PERCENTILES] + [
    (63.2, shortest) for shortest in BANDS_M if shortest != TABLE_1_BAND_M
]
NOT_VARIED = {
    "track.rail_second_moment_m4": "acts with the modulus of the rail only",
    "track.slab_second_moment_m4": "acts with the modulus of the slab only",
    "track.base_second_moment_m4": "acts with the modulus of the base only",
    "track.joint.pads_per_slab": "is a whole number",
    "track.joint.position": "is a place",
}


def studies() -> dict[str, Study]:
    """All studies by their names."""
    return dict(_named())


def _named() -> Iterator[tuple[str, Study]]:
    for name, preset in PRESETS.items():
        yield name, {"name": f"Article: {name}", "sweep": preset, "keep_history": True}
    yield "ensemble", random(AS_DESCRIBED, REALISATIONS)
    yield "sweep", product("sweep", FINE_SPEEDS, SLABS, wave([1.0]), FINER | {"window_s": REPEAT_S})
    map_speeds = FINE_SPEEDS | {"step": 10}
    yield "map", product("map", map_speeds, SLABS[:1], wave(WAVELENGTHS_M), COARSE | {"window_s": REPEAT_S})
    for hypothesis in HYPOTHESES:
        yield f"waves, {hypothesis.name}", waves(hypothesis)
        yield f"random, {hypothesis.name}", random(hypothesis, REALISATIONS_OF_A_HYPOTHESIS)
    for path in parameters():
        changes = {path: [(1 - CHANGE) * value_of(path), value_of(path), (1 + CHANGE) * value_of(path)]}
        for name, irregularity in (("wave", wave([1.0])), ("spectrum", spectrum(REALISATIONS_OF_A_PARAMETER))):
            numerics = COARSE | {"window_s": PARAMETER_S}
            yield f"{name}, {path}", product(path, [350.0], SLABS[1:], irregularity, numerics, vary=changes)


def wave(wavelengths_m: list[float]) -> Study:
    """The article's wave, or of other lengths."""
    return {"kind": "harmonic", "wavelength_m": wavelengths_m, "amplitude_mm": [AMPLITUDE_MM]}


def spectrum(realisations: int) -> Study:
    """The mean spectrum in the widest band."""
    band = {"min": TABLE_1_BAND_M, "max": LONGEST_M}
    return {"kind": "spectrum", "wavelength_band_m": [band], "realisations": realisations}


def product(name: str, speeds: Any, slabs: list[str], irregularity: Study, numerics: Study, **sweep: Any) -> Study:
    """A study of every speed with every slab and irregularity."""
    axes = {"kind": "product", "speed_kmh": speeds, "slab": slabs, "irregularity": irregularity, **sweep}
    return {"name": f"Article: {name}", "sweep": axes, "numerics": numerics}


def waves(hypothesis: Hypothesis) -> Study:
    """Section 4 under a hypothesis."""
    numerics = FINER | {"window_s": REPEAT_S}
    return product(hypothesis.name, list(SPEEDS_KMH), SLABS, wave([1.0]), numerics) | hypothesis.model(numerics)


def random(hypothesis: Hypothesis, realisations: int) -> Study:
    """Every row of Tables 1 and 2 under a hypothesis."""
    irregularity = {
        "kind": "spectrum",
        "spectrum": hypothesis.spectrum,
        "percentile": [percentile for percentile, _ in CONDITIONS],
        "wavelength_band_m": [{"min": shortest, "max": LONGEST_M} for _, shortest in CONDITIONS],
        "realisations": realisations,
    }
    numerics = COARSEST | {"window_s": RANDOM_S}
    study = product(hypothesis.name, [350.0], SLABS[1:], irregularity, numerics)
    study["sweep"]["kind"] = "zip"
    return study | hypothesis.model(numerics)


def parameters() -> list[str]:
    """Paths of the parameters whose influence is looked at."""
    paths = (path for path in PARAMETERS if path.startswith(("track.", "vehicle.")))
    return [path for path in paths if path not in NOT_VARIED]


def value_of(path: str) -> float:
    """A parameter of the article's track or vehicle."""
    value: Any = {"track": TRACKS["crts2"].values, "vehicle": VEHICLES["crh3"].values}
    part, *names = PARAMETERS[path].inside
    value = value[part]
    for name in names:
        value = getattr(value, name)
    return float(value)
