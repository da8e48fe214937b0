"""What follows from the results: the numbers of the report, in the units in which it shows them."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from app.analysis.student import t_limit
from app.console import shown_unit
from solver.arrays import Array
from solver.observables import OBSERVABLES
from worker.article.hypotheses import AS_DESCRIBED, Hypothesis
from worker.article.reported import MEAN_DISPLACEMENT_MM, MEAN_FORCE_KN, SPEEDS_KMH, Target
from worker.article.results import PEAKS, Cases, Results
from worker.article.studies import CHANGE, CONDITIONS, value_of

CONFIDENCE = 0.95
NEAR = 0.05  # of the article's value: within reach
MEAN = {"rail_displacement": "mean_displacement", "wheel_rail_force": "mean_force"}
REPORTED_MEAN = {"rail_displacement": MEAN_DISPLACEMENT_MM, "wheel_rail_force": MEAN_FORCE_KN}


def unit_of(column: str) -> str:
    """Unit in which a column is shown."""
    return shown_unit(OBSERVABLES[PEAKS[column][0]].unit)[0]


def factor_of(column: str) -> float:
    """From SI units to that."""
    return shown_unit(OBSERVABLES[PEAKS[column][0]].unit)[1]


def shown(cases: Cases, column: str) -> Array:
    """A column in the unit in which it is shown."""
    return np.asarray(factor_of(column) * cases[column])


@dataclass(frozen=True)
class Sample:
    """Peaks of as many realisations."""

    values: Array

    @property
    def mean(self) -> float:
        """Of the sample."""
        return float(self.values.mean())

    @property
    def std(self) -> float:
        """Of the sample, over count - 1."""
        return float(self.values.std(ddof=1))

    @property
    def half_interval(self) -> float:
        """What the mean of all possible realisations is within, to either side, by Student's t."""
        return t_limit(CONFIDENCE, len(self.values) - 1) * self.std / math.sqrt(len(self.values))

    def quantile(self, part: float) -> float:
        """What a part of the sample stays below, interpolated linearly."""
        return float(np.quantile(self.values, part))

    def below(self, value: float) -> int:
        """How many stay below a value."""
        return int(np.count_nonzero(self.values < value))

    def needed(self, precision: float) -> int:
        """How many realisations it takes until the mean is known to a part of itself."""
        count = 2
        while t_limit(CONFIDENCE, min(count, 500) - 1) * self.std / math.sqrt(count) > precision * self.mean:
            count += 1
        return count


def of_target(cases: Cases, target: Target) -> Cases:
    """The cases of a row of Table 1 or 2."""
    return cases.where(percentile=target.percentile, wavelength_min_m=target.shortest_m)


def sample(results: Results, target: Target) -> Sample:
    """Our realisations of a number of Table 1 or 2."""
    return Sample(shown(of_target(results.cases["ensemble"], target), target.quantity))


def single(results: Results, target: Target) -> float:
    """Our one realisation of it, as fine as the article's."""
    study = "percentiles" if target.where == "Table 1" else "bands"
    (value,) = shown(of_target(results.cases[study], target), target.quantity)
    return float(value)


def joint_differences(cases: Cases, quantity: str) -> Array:
    """What joints add to a peak, at every speed."""
    continuous, jointed = (cases.where(slab=slab) for slab in ("continuous", "discontinuous"))
    if not np.array_equal(continuous["speed_kmh"], jointed["speed_kmh"]):
        raise ValueError("the slabs were not run at the same speeds")
    return shown(jointed, quantity) - shown(continuous, quantity)


def speeds(results: Results) -> Cases:
    """The article's speeds on both slabs."""
    both = [results.cases[slab].columns for slab in ("continuous", "discontinuous")]
    return Cases({name: np.concatenate([columns[name] for columns in both]) for name in both[0]})


def under(results: Results, hypothesis: Hypothesis, target: Target) -> float | None:
    """A target under a hypothesis; nothing if a run diverged.

    Of random irregularities, the ratio to as described is taken of the few realisations that were computed for both,
    and multiplied by the mean of all realisations as described.
    """
    if target.percentile is None:
        cases = results.cases[f"waves, {hypothesis.name}"]
        complete = len(cases) == 2 * len(SPEEDS_KMH)
        return float(joint_differences(cases, target.quantity).mean()) if complete else None
    few, plain = _few(results, hypothesis, target), _few(results, AS_DESCRIBED, target)
    return float(sample(results, target).mean * few.mean() / plain.mean()) if len(few) == len(plain) else None


def _few(results: Results, hypothesis: Hypothesis, target: Target) -> Array:
    return shown(of_target(results.cases[f"random, {hypothesis.name}"], target), target.quantity)


def scatter_of_ratios(results: Results, hypotheses: Sequence[Hypothesis], targets: Sequence[Target]) -> float:
    """Standard deviation of the ratio of one realisation under a hypothesis to that without, the median of all."""
    found = []
    for target in targets:
        plain = _few(results, AS_DESCRIBED, target)
        for hypothesis in hypotheses:
            few = _few(results, hypothesis, target)
            if hypothesis != AS_DESCRIBED and len(few) == len(plain):
                found.append(float(np.std(few / plain, ddof=1)))
    return float(np.median(found))


def strip_adds(results: Results, width: float | str, quantity: str) -> float | None:
    """What strips of a width add to a peak, averaged over the speeds; nothing if a run diverged."""
    trials = [trial for trial in results.strip if trial["width_m"] == width]
    if not all(trial["peaks"] for trial in trials):
        return None
    continuous = results.cases["map"].where(wavelength_m=1.0)  # on the same mesh, with the same step
    expected = [shown(continuous.where(speed_kmh=trial["speed_kmh"]), quantity)[0] for trial in trials]
    ours = [factor_of(quantity) * trial["peaks"][quantity] for trial in trials]
    return float(np.mean(ours) - np.mean(expected))


def residual(results: Results, hypothesis: Hypothesis, target: Target) -> float | None:
    """Under a hypothesis less the article's, per the article's; nothing if a run diverged."""
    found = under(results, hypothesis, target)
    return None if found is None else found / target.value - 1


def dynamic_ratio(results: Results, target: Target) -> float:
    """The article's peak above its mean, per ours above ours."""
    mean = shown(of_target(results.cases["ensemble"], target), MEAN[target.quantity]).mean()
    ours = sample(results, target).mean - mean
    return float((target.value - REPORTED_MEAN[target.quantity]) / ours)


def numerics_errors(results: Results) -> Iterator[tuple[str, list[float | None]]]:
    """Quantities, and by how much coarse numerics miss the fine ones at most: over the waves of all hypotheses, on the
    map, in the wave of all sensitivities, and in the rows of Tables 1 and 2; nothing where it does not matter.
    """
    fine, plain = speeds(results), results.cases[f"waves, {AS_DESCRIBED.name}"]
    rows = [_random(results, fine=fine) for fine in (True, False)]
    on_map = results.cases["map"].where(wavelength_m=1.0)
    path = next(name.removeprefix("wave, ") for name in results.cases if name.startswith("wave, "))
    unchanged = results.cases[f"wave, {path}"].where(**{path: value_of(path)})
    for column in PEAKS:
        if column in ("contact_loss", *MEAN.values()):
            continue
        smooth, jointed = (fine.where(slab=slab)[column] for slab in ("continuous", "discontinuous"))
        mapped = np.array([on_map.where(speed_kmh=speed)[column][0] for speed in SPEEDS_KMH])
        waves = [_largest(smooth, plain.where(slab="continuous")[column])]
        waves.append(_largest(jointed, plain.where(slab="discontinuous")[column]))
        yield (
            column,
            [
                max(waves),
                _largest(smooth, mapped) if column == "wheel_rail_force" else None,
                _largest(jointed[-1:], unchanged[column]),
                _largest(rows[0][column], rows[1][column]) if column in MEAN else None,
            ],
        )


def _random(results: Results, *, fine: bool) -> dict[str, Array]:
    """The first realisation of every row of Tables 1 and 2."""
    found = []
    for percentile, shortest in CONDITIONS:
        study = ("bands" if percentile == 63.2 else "percentiles") if fine else "ensemble"
        found.append(results.cases[study].where(percentile=percentile, wavelength_min_m=shortest, realisation=0.0))
    return {column: np.concatenate([each[column] for each in found]) for column in MEAN}


def _largest(expected: Array, ours: Array) -> float:
    return float(np.abs(ours / expected - 1).max())


def elasticities(results: Results, path: str, column: str, excitation: str) -> Sample:
    """By how many percent a peak grows per percent of a parameter, of every realisation."""
    cases = results.cases[f"{excitation}, {path}"]
    low, high = (cases[column][cases[path] == value] for value in (cases[path].min(), cases[path].max()))
    return Sample(np.log(high / low) / math.log((1 + CHANGE) / (1 - CHANGE)))


def rms(values: Sequence[float]) -> float:
    """Root mean square."""
    return math.sqrt(math.fsum(value**2 for value in values) / len(values))
