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
from typing import Any, Literal

from sqlalchemy import ColumnElement, Row, Select, bindparam, func, select
from sqlalchemy.orm import Session

from app.cases.queue import batches
from app.db.models import Case, Worker
from app.db.types import Clock
from app.studies.loads import Load
from app.studies.schemas import FinishEstimate

LATEST = 500  # computed cases from which the cost per unknown and step is learnt
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
    now = datetime.fromtimestamp(session.scalars(_NOW).one(), UTC)
    expected, earliest, latest = (now + timedelta(seconds=s / workers) for s in (cpu.expected, cpu.least, cpu.most))
    return FinishEstimate(expected=expected, earliest=earliest, latest=latest)


def count_workers(session: Session) -> int:
    """How many workers are there."""
    return session.scalar(_WORKERS) or 0


def _of_operators(session: Session, operators: Iterable[str]) -> Mapping[str, Interval]:
    """Cost of one case of each operator of which any was computed."""
    rows = (row for keys in batches(operators) for row in session.execute(_OF_OPERATORS, {"keys": keys}))
    return {row.operator_key: _interval(row) for row in rows}


def _of_any(session: Session) -> tuple[Interval, Basis]:
    """Cost per unknown and step."""
    row = session.execute(_OF_LATEST).one()
    return (_interval(row), "other-cases") if row.n else (BENCHMARK, "benchmark")


def _statistics(of: Any) -> tuple[ColumnElement[Any], ...]:
    return func.count().label("n"), func.avg(of).label("mean"), func.avg(of * of).label("mean_square")


def _of_latest() -> Select[Any]:
    rates = select((Case.cpu_s / Case.work).label("rate")).where(Case.state == "succeeded", Case.cpu_s / Case.work > 0)
    latest = rates.order_by(Case.id.desc()).limit(LATEST).subquery()
    return select(*_statistics(latest.c.rate))


_OF_LATEST = _of_latest()
_OF_OPERATORS = (
    select(Case.operator_key, *_statistics(Case.cpu_s))
    .where(Case.state == "succeeded", Case.cpu_s.is_not(None))
    .where(Case.operator_key.in_(bindparam("keys", expanding=True)))
    .group_by(Case.operator_key)
)
_WORKERS = select(func.count()).where(Worker.expires > Clock(), ~Worker.draining)
_NOW = select(Clock())


def _interval(row: Row[Any]) -> Interval:
    spread = 2 * math.sqrt(max(0.0, row.mean_square - row.mean**2)) + row.mean / row.n
    return Interval(row.mean, max(0.0, row.mean - spread), row.mean + spread)
