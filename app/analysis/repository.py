"""What is analysed: the numbers of a study's cases beside what varies between them."""

import json
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.analysis.schemas import AnalysisQuery
from app.cases.schemas import PARTS, case_file
from app.db.models import Case, Peak, Study, StudyCase
from app.problems import Problem, not_found

MAX_PEAKS = 50_000

Parameters = dict[str, Any]
Channel = tuple[str, str, str]  # quantity, position, unit


@dataclass(frozen=True)
class Data:
    """Numbers of the succeeded cases of a study.

    Attributes
    ----------
    varying : dict
        By case, in the order of the study, its values of everything that varies between the study's cases.
    numbers : dict
        By quantity, position and unit: the number of each case.
    """

    varying: dict[int, Parameters]
    numbers: dict[Channel, dict[int, float]]


def load(session: Session, study_id: str, query: AnalysisQuery) -> Data:
    """What is to be analysed of a study.

    Raises
    ------
    Problem
        404 if there is no such study, 422 if that is too much for one answer.
    """
    if session.get(Study, study_id) is None:
        raise not_found("study")
    of_study = select(StudyCase.case_id).where(StudyCase.study_id == study_id)
    peaks = select(
        Peak.case_id, Peak.quantity, Peak.position, Peak.unit, getattr(Peak, query.statistic).label("number")
    )
    peaks = peaks.where(Peak.case_id.in_(of_study))
    if query.quantity is not None:
        peaks = peaks.where(Peak.quantity == query.quantity)
    if query.position is not None:
        peaks = peaks.where(Peak.position == query.position)
    rows = session.execute(peaks.limit(MAX_PEAKS + 1)).all()
    if len(rows) > MAX_PEAKS:
        raise Problem(
            422, f"There are more than {MAX_PEAKS} peaks: name a quantity and a position.", code="too-many-peaks"
        )
    numbers: dict[Channel, dict[int, float]] = {}
    for row in sorted(rows, key=lambda row: (row.quantity, row.position)):
        numbers.setdefault((row.quantity, row.position, row.unit), {})[row.case_id] = row.number
    return Data(_varying(session, study_id), numbers)


def _varying(session: Session, study_id: str) -> dict[int, Parameters]:
    cases = (
        select(Case.id, Case.inputs)
        .join(StudyCase, StudyCase.case_id == Case.id)
        .where(StudyCase.study_id == study_id)
        .order_by(StudyCase.position)
    )
    rows = session.execute(cases).all()
    parts = [part for part in PARTS if any(row.inputs[part] != rows[0].inputs[part] for row in rows)]
    values = {row.id: parameters(row.inputs, parts) for row in rows}
    first = next(iter(values.values()), {})
    names = dict.fromkeys(name for each in values.values() for name in each)  # in the order in which cases name them
    varying = [name for name in names if any(each.get(name) != first.get(name) for each in values.values())]
    return {case: {name: each.get(name) for name in varying} for case, each in values.items()}


def parameters(inputs: dict[str, Any], parts: Collection[str]) -> Parameters:
    """What makes a case, of its ``Case.to_dict()``, by the names of a study; of the model, these parts only."""
    file = case_file(inputs, parts)
    irregularity = file.pop("irregularity")
    kind = irregularity.pop("kind")
    return {"speed_kmh": file.pop("speed_kmh"), "slab": file.pop("slab"), "irregularity": kind, **irregularity} | dict(
        _leaves(file)
    )


def _leaves(values: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    for name, value in values.items():
        if isinstance(value, dict):
            yield from _leaves(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def key(value: Any) -> str:
    """Equal for equal values of a parameter."""
    return json.dumps(value, sort_keys=True)
