"""Differences between cases that are equal but for one axis."""

import json
from collections import defaultdict
from statistics import fmean, stdev
from typing import Any

from sqlalchemy.orm import Session

from app.analysis.repository import Channel, Data, Parameters, key, load
from app.analysis.schemas import Comparison, ComparisonQuery, Difference, MeanDifference, Pairing
from app.problems import invalid


def compare(session: Session, study_id: str, query: ComparisonQuery) -> Comparison:
    """Compare the cases of a study along an axis.

    Raises
    ------
    Problem
        404 if there is no such study; 422 if the axis does not vary in it, or has no such value as the baseline.
    """
    data = load(session, study_id, query)
    baseline = _baseline(data, query)
    groups, without_baseline = [], 0
    for channel, numbers in data.numbers.items():
        for cases in _groups(data, query.axis, numbers):
            pairing = _pair(channel, numbers, cases, data.varying, query.axis, baseline)
            if pairing is None:
                without_baseline += 1
            elif pairing.differences:
                groups.append(pairing)
    return Comparison(
        study_id=study_id,
        axis=query.axis,
        statistic=query.statistic,
        baseline=baseline,
        averages=_averages(groups),
        groups=groups,
        groups_without_baseline=without_baseline,
    )


def _baseline(data: Data, query: ComparisonQuery) -> Any:
    varied = list(next(iter(data.varying.values()), {}))
    if query.axis not in varied:
        what = f"What varies is {', '.join(varied)}." if varied else "Nothing does."
        raise invalid("/query/axis", "axis-not-varied", f"{query.axis} does not vary in this study. {what}")
    values = [each[query.axis] for each in data.varying.values()]
    if query.baseline is None:
        return values[0]
    for value in values:
        if value == _read(query.baseline) or value == query.baseline:
            return value
    detail = f"No case has {query.axis} {query.baseline}."
    raise invalid("/query/baseline", "no-such-value", detail)


def _read(text: str) -> Any:
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        return text


def _groups(data: Data, axis: str, numbers: dict[int, float]) -> list[list[int]]:
    """Cases that are equal but for the axis, in the order of the study."""
    groups: dict[str, list[int]] = defaultdict(list)
    for case, values in data.varying.items():
        if case in numbers:
            groups[key(_without(values, axis))].append(case)
    return list(groups.values())


def _without(values: Parameters, *names: str) -> Parameters:
    return {name: value for name, value in values.items() if name not in names}


def _pair(
    channel: Channel,
    numbers: dict[int, float],
    cases: list[int],
    varying: dict[int, Parameters],
    axis: str,
    baseline: Any,
) -> Pairing | None:
    quantity, position, unit = channel
    of_baseline = [numbers[case] for case in cases if varying[case][axis] == baseline]
    if not of_baseline:
        return None
    begin = of_baseline[0]
    return Pairing(
        quantity=quantity,
        position=position,
        unit=unit,
        conditions=_without(varying[cases[0]], axis),
        baseline_value=begin,
        differences=[
            Difference(
                at=varying[case][axis],
                value=numbers[case],
                absolute=numbers[case] - begin,
                relative=(numbers[case] - begin) / abs(begin) if begin else None,
            )
            for case in cases
            if varying[case][axis] != baseline
        ],
    )


def _averages(groups: list[Pairing]) -> list[MeanDifference]:
    found: dict[tuple[str, str, str, str], list[Difference]] = defaultdict(list)
    for group in groups:
        for each in group.differences:
            found[group.quantity, group.position, group.unit, key(each.at)].append(each)
    return [
        MeanDifference(
            quantity=quantity,
            position=position,
            unit=unit,
            at=several[0].at,
            groups=len(several),
            absolute=fmean(each.absolute for each in several),
            absolute_std=stdev(each.absolute for each in several) if len(several) > 1 else None,
            relative=_mean([each.relative for each in several]),
        )
        for (quantity, position, unit, _), several in found.items()
    ]


def _mean(values: list[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return fmean(known) if len(known) == len(values) else None
