"""How much one key may have computed. What a case takes is charged to whoever asked for its computation first."""

import math
from typing import NamedTuple

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.access.caller import Caller
from app.access.schemas import CallerLimits
from app.db.models import Case
from app.db.types import Clock
from app.problems import Problem
from app.settings import Settings

DAY_S = 24 * 3600.0
RETRY_QUEUED_S = 60  # when the queue will be shorter is not known


class Usage(NamedTuple):
    """What is charged to a key."""

    queued_cases: int
    cpu_s: float


def usage(session: Session, key_id: int | None) -> Usage:
    """Cases that wait or run, and processor time of those that were computed in the last 24 hours."""
    charged = select(func.count(), func.sum(Case.cpu_s)).where(Case.charged_to == key_id)
    queued, _ = session.execute(charged.where(Case.finished_at.is_(None))).one()
    _, cpu_s = session.execute(charged.where(Case.finished_at > Clock() - DAY_S)).one()
    return Usage(queued, cpu_s or 0.0)


def limits(session: Session, settings: Settings, caller: Caller) -> CallerLimits:
    """What the caller may do, and has left of it."""
    used = usage(session, caller.key_id)
    return CallerLimits(
        key=caller.name,
        scope=caller.scope,
        max_queued_cases=caller.max_queued_cases,
        queued_cases=used.queued_cases,
        cpu_s_per_day=caller.cpu_s_per_day,
        cpu_s_last_day=used.cpu_s,
        reads_per_minute=settings.reads_per_minute,
        writes_per_minute=settings.writes_per_minute,
    )


def check(session: Session, caller: Caller) -> None:
    """Call it in the transaction that has queued something, which is undone if that was too much.

    Raises
    ------
    Problem
        429.
    """
    if caller.max_queued_cases is None and caller.cpu_s_per_day is None:
        return
    used = usage(session, caller.key_id)
    if caller.max_queued_cases is not None and used.queued_cases > caller.max_queued_cases:
        detail = f"{used.queued_cases} cases of this key would be queued; it may have {caller.max_queued_cases}."
        raise _exceeded(detail, RETRY_QUEUED_S)
    if caller.cpu_s_per_day is not None and used.cpu_s >= caller.cpu_s_per_day:
        detail = (
            f"Cases of this key took {used.cpu_s:.0f} s in the last 24 hours; it may have {caller.cpu_s_per_day:g} s."
        )
        raise _exceeded(detail, _until_below(session, caller.key_id, used.cpu_s - caller.cpu_s_per_day))


def _exceeded(detail: str, retry_after_s: int) -> Problem:
    return Problem(429, detail, code="quota-exceeded", headers={"Retry-After": str(retry_after_s)})


def _until_below(session: Session, key_id: int | None, excess_s: float) -> int:
    """Seconds until the oldest cases that make up the excess are a day old."""
    age = (Clock() - Case.finished_at).label("age")
    oldest = select(age, Case.cpu_s).where(Case.charged_to == key_id, Case.finished_at > Clock() - DAY_S)
    for row in session.execute(oldest.order_by(Case.finished_at)):
        excess_s -= row.cpu_s or 0.0
        if excess_s < 0:
            return max(1, math.ceil(DAY_S - row.age))
    return math.ceil(DAY_S)
