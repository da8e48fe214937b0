"""What the report concludes from: the few numbers that its sentences hold."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from worker.article import outcome, strip
from worker.article.claims import FALL_BY_BAND, GROW, GROW_BY_PERCENTILE, HOLDS, Verdict
from worker.article.hypotheses import AS_DESCRIBED, HYPOTHESES, PER_RAD, Hypothesis
from worker.article.reported import JOINT_TARGETS, SPEEDS_KMH, TARGETS, Target
from worker.article.results import Results
from worker.article.studies import parameters

RANDOM_TARGETS = tuple(target for target in TARGETS if target.percentile is not None)
GROUPS = {
    "joints": JOINT_TARGETS,
    "displacement": tuple(target for target in RANDOM_TARGETS if target.quantity == "rail_displacement"),
    "force": tuple(target for target in RANDOM_TARGETS if target.quantity == "wheel_rail_force"),
}


@dataclass(frozen=True, kw_only=True)
class Fit:
    """How near a hypothesis comes to a group of targets."""

    name: str
    residuals: dict[Target, float | None]  # none where the run diverges

    @property
    def rms(self) -> float | None:
        """Root mean square of the residuals."""
        values = [value for value in self.residuals.values() if value is not None]
        return outcome.rms(values) if len(values) == len(self.residuals) else None

    @property
    def near(self) -> list[Target]:
        """Targets within reach."""
        return [t for t, value in self.residuals.items() if value is not None and abs(value) <= outcome.NEAR]


def fits(results: Results) -> dict[str, list[Fit]]:
    """Every hypothesis, by group of targets; strips too where they bear on it."""
    found = {name: [_fit(results, each, targets) for each in HYPOTHESES] for name, targets in GROUPS.items()}
    for width in (strip.NARROW_M, strip.ELEMENT):
        added = {target: outcome.strip_adds(results, width, target.quantity) for target in JOINT_TARGETS}
        residuals = {t: None if value is None else value / t.value - 1 for t, value in added.items()}
        name = "the whole element" if isinstance(width, str) else f"a strip of {width:g} m"
        found["joints"].append(Fit(name=f"joints as the article describes them, {name}", residuals=residuals))
    return found


def _fit(results: Results, hypothesis: Hypothesis, targets: tuple[Target, ...]) -> Fit:
    return Fit(name=hypothesis.name, residuals={t: outcome.residual(results, hypothesis, t) for t in targets})


def best(found: list[Fit]) -> Fit:
    """The one with the smallest residuals."""
    return min(found, key=lambda fit: math.inf if fit.rms is None else fit.rms)


def facts(results: Results, verdicts: list[Verdict]) -> dict[str, Any]:
    """What the sentences say."""
    found = fits(results)
    by_name = {name: {fit.name: fit for fit in group} for name, group in found.items()}
    above = [
        t for t in RANDOM_TARGETS if outcome.sample(results, t).below(t.value) == len(outcome.sample(results, t).values)
    ]
    return {
        "fits": found,
        "best": {name: best(group) for name, group in found.items()},
        "plain": {name: group[AS_DESCRIBED.name] for name, group in by_name.items()},
        "per_rad": {name: group[PER_RAD.name] for name, group in by_name.items()},
        "reached": {t: [fit.name for fit in found["joints"] if t in fit.near] for t in JOINT_TARGETS},
        "above_all": above,
        "dynamic": {
            quantity: np.median([outcome.dynamic_ratio(results, t) for t in RANDOM_TARGETS if t.quantity == quantity])
            for quantity in outcome.MEAN
        },
        "scatter": outcome.scatter_of_ratios(results, HYPOTHESES, RANDOM_TARGETS),
        "tally": {words: [v for v in verdicts if v.words == words] for words in sorted({v.words for v in verdicts})},
        "highest": _highest(results),
        "map": _of_map(results),
        "strongest": {column: _strongest(results, column) for column in ("wheel_rail_force", "rail_displacement")},
    }


def unfounded(known: dict[str, Any], p2_hz: float) -> list[str]:
    """What the report's words take for granted and other numbers would not bear out."""
    wave_on_p2 = 3.6 * p2_hz
    words = {verdict.claim: verdict.words for verdict in known["verdicts"]}
    premises = {
        "peaks do not grow at every step of speed": words[GROW] != HOLDS,
        "the force is largest near where the wave meets P2": abs(
            known["highest"]["continuous"]["speed"] / wave_on_p2 - 1
        )
        < 0.1,
        "that is between two of the article's speeds": known["highest"]["continuous"]["speed"] not in SPEEDS_KMH,
        "random peaks are ordered as in the article": words[GROW_BY_PERCENTILE] == words[FALL_BY_BAND] == HOLDS,
        "chance does not explain the article's values": 2 * len(known["above_all"]) > len(RANDOM_TARGETS),
        "the spectrum per rad/m brings forces nearer": known["per_rad"]["force"].rms < known["plain"]["force"].rms,
    }
    return [premise for premise, holds in premises.items() if not holds]


def _highest(results: Results) -> dict[str, dict[str, float]]:
    """By slab, where between 100 and 400 km/h the force is largest, and what the article's speeds show of that."""
    found = {}
    for slab in ("continuous", "discontinuous"):
        cases = results.cases["sweep"].where(slab=slab)
        force, speed = outcome.shown(cases, "wheel_rail_force"), cases["speed_kmh"]
        shown = force[np.isin(speed, SPEEDS_KMH)].max()
        at = int(np.argmax(force))
        found[slab] = {"speed": float(speed[at]), "force": float(force[at]), "shown": float(shown)}
    return found


def _of_map(results: Results) -> dict[str, float]:
    cases = results.cases["map"]
    force = outcome.shown(cases, "wheel_rail_force")
    at = int(np.argmax(force))
    lost = float(np.mean(cases["contact_loss"] > 0))
    where = {name: float(cases[name][at]) for name in ("speed_kmh", "wavelength_m")}
    return where | {"force": float(force[at]), "lost": lost}


def _strongest(results: Results, column: str) -> list[tuple[str, float]]:
    """The three parameters by which a peak over the spectrum changes most."""
    means = [(path, outcome.elasticities(results, path, column, "spectrum").mean) for path in parameters()]
    return sorted(means, key=lambda pair: -abs(pair[1]))[:3]
