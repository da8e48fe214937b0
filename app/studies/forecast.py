"""What cases will cost and when they will be done, learnt from those that were computed.

The cost of a case is the mean of its like: of computed cases with the same operator, which have the same number of
steps too; failing these, per unknown and step, of the latest computed cases; failing any, of a benchmark. An interval
is twice the standard deviation on either side, and the more the fewer were computed. All cases of a study are taken to
err alike: what makes one dearer, such as a slower machine, does so to its neighbours.
"""

import math
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import Any, Literal, NamedTuple

from sqlalchemy import ColumnElement, Row, Select, and_, case, func, or_, select
from sqlalchemy.orm import Session

from app.cases.queue import UNFINISHED, batches
from app.db.models import Case, Study, StudyCase, Worker
from app.db.types import Clock
from app.studies.schemas import FinishEstimate

LATEST = 500  # computed cases from which the cost per unknown and step is learnt
TYPICAL_WORK = 6e8  # of a case stored before its work was: default numerics
Basis = Literal["same-operator", "other-cases", "benchmark"]


@dataclass(frozen=True)
class Interval:
    """A time in s that lies between two others."""

    expected: float = 0.0
    least: float = 0.0
    most: float = 0.0

    def times(self, factor: float) -> "Interval":
        """As many of them."""
        return Interval(self.expected * factor, self.least * factor, self.most * factor)

    def __add__(self, other: "Interval") -> "Interval":
        return Interval(self.expected + other.expected, self.least + other.least, self.most + other.most)


# Processor time per unknown and step. `python -m benchmarks.contenders` prints what one step of 15 480 unknowns takes:
# ms_per_lane_and_step where eight cases are computed side by side, ms_per_step_one_case for one alone. The least is of
# the former, the most of the latter on a machine that takes twice the time.
BENCHMARK = Interval(5e-9, 2.8e-9, 1.7e-8)


class Load(NamedTuple):
    """Cases of one operator that are to come, and their unknowns times steps. Of running ones, what is left."""

    operator: str
    cases: float
    work: float


def left(session: Session, study_id: str) -> list[Load]:
    """What is left of a study."""
    own = _unfinished().join(StudyCase, StudyCase.case_id == Case.id).where(StudyCase.study_id == study_id)
    return _loads(session, own)


def ahead(session: Session, study: Study) -> list[Load]:
    """What others have running, or in the queue before the last case of a study."""
    own = select(StudyCase.case_id).where(StudyCase.study_id == study.id)
    last = select(func.max(Case.turn)).where(Case.id.in_(own), Case.state == "queued", Case.priority == study.priority)
    before = comes_before(study.priority, session.scalar(last) or 0)
    return _loads(session, _unfinished().where(before, Case.id.not_in(own)))


def before_turn(session: Session, priority: int, turn: int) -> list[Load]:
    """What is running, or in the queue before a turn."""
    return _loads(session, _unfinished().where(comes_before(priority, turn)))


def comes_before(priority: int, turn: int) -> ColumnElement[bool]:
    """Whether a case is claimed before those of a turn."""
    sooner = or_(Case.priority > priority, and_(Case.priority == priority, Case.turn < turn))
    return or_(Case.state == "running", and_(Case.state == "queued", sooner))


def _unfinished() -> Any:
    rest = case((Case.state == "running", 1 - Case.progress), else_=1.0)
    work = func.coalesce(Case.work, TYPICAL_WORK)
    columns = Case.operator_key, func.sum(rest).label("cases"), func.sum(rest * work).label("work")
    return select(*columns).where(Case.state.in_(UNFINISHED)).group_by(Case.operator_key)


def _loads(session: Session, statement: Select[Any]) -> list[Load]:
    return [Load(*row) for row in session.execute(statement)]


def cpu_s(session: Session, loads: Collection[Load]) -> tuple[Interval, Basis]:
    """Processor time of cases, and the weakest ground on which it was told."""
    operators = {load.operator for load in loads}
    known = _of_operators(session, operators)
    strangers = operators - known.keys()
    rate, basis = _of_any(session) if strangers else (Interval(), "same-operator")
    total = Interval()
    for operator, cases, work in loads:
        total += known[operator].times(cases) if operator in known else rate.times(work)
    return total, basis


def finish(session: Session, cpu: Interval) -> FinishEstimate | None:
    """When the workers that are there will have done so much; None if none is there."""
    workers = count_workers(session)
    if workers == 0:
        return None
    now = datetime.fromtimestamp(session.scalars(select(Clock())).one(), UTC)
    expected, earliest, latest = (now + timedelta(seconds=s / workers) for s in (cpu.expected, cpu.least, cpu.most))
    return FinishEstimate(expected=expected, earliest=earliest, latest=latest)


def count_workers(session: Session) -> int:
    """How many workers are there."""
    return session.scalar(select(func.count()).where(Worker.expires > Clock())) or 0


def _of_operators(session: Session, operators: Iterable[str]) -> Mapping[str, Interval]:
    """Cost of one case of each operator of which any was computed."""
    statistics = select(Case.operator_key, *_statistics(Case.cpu_s)).group_by(Case.operator_key)
    computed = statistics.where(Case.state == "succeeded", Case.cpu_s.is_not(None))
    rows = (row for keys in batches(operators) for row in session.execute(computed.where(Case.operator_key.in_(keys))))
    return {row.operator_key: _interval(row) for row in rows}


def _of_any(session: Session) -> tuple[Interval, Basis]:
    """Cost per unknown and step."""
    rates = select((Case.cpu_s / Case.work).label("rate")).where(Case.state == "succeeded", Case.cpu_s / Case.work > 0)
    latest = rates.order_by(Case.id.desc()).limit(LATEST).subquery()
    row = session.execute(select(*_statistics(latest.c.rate))).one()
    return (_interval(row), "other-cases") if row.n else (BENCHMARK, "benchmark")


def _statistics(of: Any) -> tuple[ColumnElement[Any], ...]:
    return func.count().label("n"), func.avg(of).label("mean"), func.avg(of * of).label("mean_square")


def _interval(row: Row[Any]) -> Interval:
    spread = 2 * math.sqrt(max(0.0, row.mean_square - row.mean**2)) + row.mean / row.n
    return Interval(row.mean, max(0.0, row.mean - spread), row.mean + spread)
