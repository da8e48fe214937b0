"""Statistics over the realisations of a random irregularity."""

import math
import statistics
from collections import defaultdict
from typing import Any

from sqlalchemy.orm import Session

from app.analysis.repository import key, load
from app.analysis.schemas import AnalysisQuery, ConfidenceInterval, Quantiles, Statistics, Summary
from app.analysis.student import t_limit

CHANCE = ("realisation", "seed")  # in what cases may differ that are of one condition
CONFIDENCE = 0.95


def summarise(session: Session, study_id: str, query: AnalysisQuery) -> Statistics:
    """Summarise the cases of a study over their realisations.

    Raises
    ------
    Problem
        404 if there is no such study.
    """
    data, summaries = load(session, study_id, query), []
    conditions = {
        case: {name: value for name, value in values.items() if name not in CHANCE}
        for case, values in data.varying.items()
    }
    for (quantity, position, unit), numbers in data.numbers.items():
        groups: dict[str, list[int]] = defaultdict(list)
        for case, values in conditions.items():
            if case in numbers:
                groups[key(values)].append(case)
        for cases in groups.values():
            sample = describe([numbers[case] for case in cases])
            channel = {"quantity": quantity, "position": position, "unit": unit, "conditions": conditions[cases[0]]}
            summaries.append(Summary.model_validate(channel | sample))
    return Statistics(study_id=study_id, statistic=query.statistic, conditions=summaries)


def describe(values: list[float]) -> dict[str, Any]:
    """Statistics of a sample."""
    count, mean = len(values), statistics.fmean(values)
    std = statistics.stdev(values) if count > 1 else None
    parts = statistics.quantiles(values, n=20, method="inclusive") if count > 1 else values * 19
    if std is None:
        interval = None
    else:
        reach = t_limit(CONFIDENCE, count - 1) * std / math.sqrt(count)
        interval = ConfidenceInterval(lower=mean - reach, upper=mean + reach)
    return {
        "count": count,
        "mean": mean,
        "std": std,
        "minimum": min(values),
        "maximum": max(values),
        "quantiles": Quantiles(p5=parts[0], p25=parts[4], p50=parts[9], p75=parts[14], p95=parts[18]),
        "mean_95": interval,
    }
