"""What the article says in words, and whether our numbers say so too."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from app.console import digits
from worker.article.outcome import joint_differences, sample, shown, speeds, unit_of
from worker.article.reported import (
    FALL_ALONG_BANDS,
    GROWTH_25_TO_90,
    SECTION_4,
    TABLE_1_TARGETS,
    TABLE_2_TARGETS,
    Target,
)
from worker.article.results import Results

GROW = "All peaks grow with speed"
GROW_BY_PERCENTILE = "Peaks grow with the percentile"
FALL_BY_BAND = "Peaks fall as short waves are left out"
HOLDS = "holds"
SLABS = ("continuous", "discontinuous")
PEAKS = ("rail_acceleration", "slab_acceleration", "base_acceleration", "wheel_rail_force")
PERCEPTIBLE = 0.015  # m/s², peak: what every second person just feels (ISO 2631-1, annex C)
VISIBLE = 0.05  # of the highest value of a figure
ALIKE = 2.0  # percentage points within which a percentage is the article's


@dataclass(frozen=True, kw_only=True)
class Verdict:
    """A claim, and what of it our numbers bear out: ``evidence`` is a list of (what, whether that holds)."""

    claim: str
    where: str
    evidence: list[tuple[str, bool]]

    @property
    def words(self) -> str:
        """In one or two words."""
        held = [holds for _, holds in self.evidence]
        return HOLDS if all(held) else "holds in part" if any(held) else "**holds not**"


Judge = Callable[[Results], Iterator[tuple[str, bool]]]


def _name(column: str) -> str:
    return column.replace("_", " ").replace("wheel rail", "wheel–rail")


def _grows(results: Results) -> Iterator[tuple[str, bool]]:
    for column in PEAKS:
        for slab in SLABS:
            values = shown(speeds(results).where(slab=slab), column)
            listed = ", ".join(f"{value:.1f}" for value in values)
            yield f"{_name(column)}, {slab}: {listed} {unit_of(column)}", all(a < b for a, b in pairwise(values))


def _not_proportional(results: Results) -> Iterator[tuple[str, bool]]:
    cases = speeds(results).where(slab="discontinuous")
    faster = cases["speed_kmh"][-1] / cases["speed_kmh"][0]
    for column in PEAKS:
        values = shown(cases, column)
        larger = values[-1] / values[0]
        yield f"{_name(column)}: speed × {faster:.2f}, peak × {larger:.2f}", abs(larger / faster - 1) > 0.1


def _upper_layers(results: Results) -> Iterator[tuple[str, bool]]:
    for slab in SLABS:
        rail, layer, base = (shown(speeds(results).where(slab=slab), column) for column in PEAKS[:3])
        for name, upper, lower in (("rail > slab", rail, layer), ("slab > base", layer, base)):
            count = int(np.count_nonzero(upper > lower))
            yield f"{name}, {slab}: at {count} of {len(upper)} speeds", count == len(upper)


def _joints_raise(results: Results) -> Iterator[tuple[str, bool]]:
    for column in SECTION_4:
        found = joint_differences(speeds(results), column)
        more = f"{_name(column)}: {', '.join(f'{each:+.2f}' for each in found)} {unit_of(column)}"
        yield more, bool((found > 0).all())


def _not_the_car(results: Results) -> Iterator[tuple[str, bool]]:
    cases, column = speeds(results), "car_body_acceleration"
    apart = float(np.abs(joint_differences(cases, column)).max())
    part = apart / float(shown(cases, column).max())
    yield f"nobody feels it: at most {apart:.4f} m/s² apart, {PERCEPTIBLE:g} can be felt", apart < PERCEPTIBLE
    yield f"nobody sees it in a figure: {100 * part:.0f} % of the largest value", part < VISIBLE


def _grows_with_percentile(results: Results) -> Iterator[tuple[str, bool]]:
    for column, (theirs,) in GROWTH_25_TO_90.items():
        low, _, high = (sample(results, target).mean for target in TABLE_1_TARGETS if target.quantity == column)
        ours = 100 * (high / low - 1)
        yield f"{_name(column)}: ours +{ours:.1f} %, the article's +{theirs:g} %", abs(ours - theirs) < ALIKE


def _falls_along_bands(results: Results) -> Iterator[tuple[str, bool]]:
    for column, theirs in FALL_ALONG_BANDS.items():
        means = [sample(results, target).mean for target in TABLE_2_TARGETS if target.quantity == column]
        for (one, other), their in zip(pairwise(means), theirs, strict=True):
            ours = 100 * (1 - other / one)
            yield f"{_name(column)}: ours −{ours:.1f} %, the article's −{their:g} %", abs(ours - their) < ALIKE


def _percentiles_in_order(results: Results) -> Iterator[tuple[str, bool]]:
    return _in_order(results, TABLE_1_TARGETS, 1)


def _bands_in_order(results: Results) -> Iterator[tuple[str, bool]]:
    return _in_order(results, TABLE_2_TARGETS, -1)


def _in_order(results: Results, targets: tuple[Target, ...], sign: int) -> Iterator[tuple[str, bool]]:
    """Whether means grow (sign 1) or fall (-1) from row to row, and how often single realisations do."""
    for column in GROWTH_25_TO_90:
        samples = [sample(results, target) for target in targets if target.quantity == column]
        steps = [sign * (after.values - before.values) for before, after in pairwise(samples)]
        single = 100 * float(np.mean(np.array(steps) > 0))
        means = ", ".join(digits(each.mean) for each in samples)
        evidence = f"{_name(column)}: {means} {unit_of(column)} in the mean; so do {single:.0f} % of single steps"
        yield evidence, all(step.mean() > 0 for step in steps)


def _listed(percentages: Mapping[str, Sequence[float]]) -> str:
    """What the article says by how much peaks change."""
    return " and ".join(
        f"{', '.join(f'{each:g}' for each in values)} % ({_name(column)})" for column, values in percentages.items()
    )


CLAIMS: tuple[tuple[str, str, Judge], ...] = (
    (GROW, "Section 4, Figs. 5–9", _grows),
    ("… but not in proportion to it", "Section 4", _not_proportional),
    ("The rail is accelerated more than the slab, the slab more than the base", "Section 4", _upper_layers),
    ("Joints raise accelerations of the track and the contact force", "Section 4", _joints_raise),
    ("Joints make no visible difference to the car body", "Section 4", _not_the_car),
    (GROW_BY_PERCENTILE, "Section 5, Table 1", _percentiles_in_order),
    (f"… from 25 to 90 % by {_listed(GROWTH_25_TO_90)}", "Section 5", _grows_with_percentile),
    (FALL_BY_BAND, "Section 5, Table 2", _bands_in_order),
    (f"… from band to band by {_listed(FALL_ALONG_BANDS)}", "Section 5", _falls_along_bands),
)


def verdicts(results: Results) -> list[Verdict]:
    """All of them."""
    return [Verdict(claim=claim, where=where, evidence=list(judge(results))) for claim, where, judge in CLAIMS]
