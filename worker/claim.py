"""Claiming: the next case of the queue, and with it those that can ride along.

Lanes of one block cost much less than as many single cases, so a worker takes several cases of one operator. The
order of the queue (app/cases/queue.py) decides which case is next, and riders come with it.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any
from uuid import uuid4

from sqlalchemy import ColumnElement, Double, Row, Select, bindparam, case, false, func, select, true, update
from sqlalchemy.orm import Session

from app import events
from app.db import tally
from app.db.models import Case
from app.db.types import Clock
from solver.block import lane_width
from solver.simd import MAX_LANES
from solver.version import SOLVER_VERSION
from worker import presence
from worker.lease import Lease, studies_of


@dataclass(frozen=True, kw_only=True)
class Claim(Lease):
    """A case that a worker may compute until its lease runs out."""

    digest: str
    inputs: dict[str, Any]


def claim(session: Session, worker: str, lease_s: float, lanes: int = MAX_LANES) -> list[Claim]:
    """Take the next case of the queue, and queued cases to compute with it.

    Those have the same operator and the same priority, as they slow down whom they ride with. Neither they nor the
    case that is next were tried before: what killed a worker is tried again alone, and kills no neighbour twice.

    Parameters
    ----------
    session : Session
        The transaction.
    worker : str
        Who takes them.
    lease_s : float
        How long the leases last, s.
    lanes : int
        How many cases to take at most.

    Returns
    -------
    list of Claim
        Empty if no case is queued.
    """
    first = _queued().order_by(Case.priority.desc(), Case.turn, Case.id).limit(1)
    head = session.execute(first.with_for_update(skip_locked=True)).one_or_none()
    if head is None:
        return []
    rows = [head, *_riders(session, head, _share(session, head, worker, lanes) - 1)]
    rows.sort(key=lambda row: str(row.digest))  # the order in which they will be locked again and again
    studies = studies_of(session, [row.id for row in rows])
    batch = [
        Claim(
            token=uuid4().hex,
            attempt=row.attempt + 1,
            case_id=row.id,
            study_ids=studies[row.id],
            digest=row.digest,
            inputs=row.inputs,
        )
        for row in rows
    ]
    taken = [{"taken_id": held.case_id, "token": held.token, "by": worker, "for_s": lease_s} for held in batch]
    session.connection().execute(_TAKE, taken)
    events.cases_started(session, [held.case_id for held in batch])
    tally.count(session, "lanes", "yes", len(batch))
    tally.count(session, "lanes", "no", lane_width(len(batch)) - len(batch))
    return batch


_TAKE = (
    update(Case)
    .where(Case.id == bindparam("taken_id"))
    .values(state="running", attempt=Case.attempt + 1, worker=bindparam("by"), progress=0.0)
    .values(started_at=Clock(), heartbeat_at=Clock(), lease_expires=Clock() + bindparam("for_s", type_=Double))
    .values(lease_token=bindparam("token"))
)


def _queued() -> Select[Any]:
    columns = Case.id, Case.digest, Case.inputs, Case.operator_key, Case.solver_version, Case.priority, Case.attempt
    return select(*columns).where(Case.state == "queued", _opaque(Case.solver_version == SOLVER_VERSION))


def _share(session: Session, head: Row[Any], worker: str, lanes: int) -> int:
    """How many cases to take of those with the operator of the first, itself included.

    Their number, queued or running, divided by that of the workers that are there: what others run is their part, so
    the share stays the same until the last is claimed, also when two claim at once. From three on it is as many as a
    block has lanes, as lanes left empty would be computed all the same.
    """
    if head.attempt > 0:
        return 1
    workers = presence.count_with(session, worker)
    unfinished = select(Case.id).where(*_alike(head), Case.state.in_(["queued", "running"]))
    cases = session.scalar(select(func.count()).select_from(unfinished.limit(lanes * workers).subquery())) or 1
    return min(lanes, lane_width(math.ceil(cases / workers)))


def _riders(session: Session, head: Row[Any], count: int) -> Sequence[Row[Any]]:
    if count == 0:
        return []
    untried = _queued().where(*_alike(head), Case.attempt == 0, Case.id != head.id)
    untried = untried.order_by(Case.priority, Case.id).limit(count)
    return session.execute(untried.with_for_update(skip_locked=True)).all()


def _alike(head: Row[Any]) -> list[Any]:
    like = [getattr(Case, name) == getattr(head, name) for name in ("solver_version", "priority")]
    return [Case.operator_key == head.operator_key, *map(_opaque, like)]


def _opaque(condition: ColumnElement[bool]) -> ColumnElement[bool]:
    """A condition that chooses no index. Of rows that are new, PostgreSQL takes each for rare, and would sort all that
    wait, at every claim, rather than read them in the order they have; of what it does not see through it believes that
    half of the rows fulfil it.
    """
    return case((condition, true()), else_=false())
