"""The order of the queue: by priority, then by turn, then by age.

A turn is a place in a line that all studies of one priority share. A new study begins where the line stands, and its
n-th case stands n places behind that; so two studies alternate however many cases each has, and a small study does
not wait for a large one that came before. This is start-time fair queueing with every case of equal weight. Where
studies have owners (API keys) it is the owners who take turns: an owner's next study begins behind the last turn that
any study of that owner had, also when those have ended, and one who comes anew goes before all that only wait.

Whoever changes which studies want which cases calls :func:`one_at_a_time` first. Rows of cases are locked in the
order of their digests, before those of studies.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeVar

from sqlalchemy import Row, delete, func, select, text, update
from sqlalchemy.orm import Session

from app.db import tally
from app.db.models import Case, CaseState, Peak, Study, StudyCase
from app.db.types import Clock

T = TypeVar("T")
BATCH = 1000  # well below what either database takes as parameters of one statement
UNFINISHED: tuple[CaseState, ...] = ("queued", "running")

_LOCK = 4_250_962_617_395_811  # PostgreSQL's, for the function below; any number


def one_at_a_time(session: Session) -> None:
    """Let nobody else change which studies want which cases: on PostgreSQL what SQLite's write lock does anyway."""
    if session.get_bind().dialect.name == "postgresql":
        session.execute(text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": _LOCK})


def batches(items: Iterable[T]) -> Iterator[list[T]]:
    """Items in portions that one statement can name."""
    everything = list(items)
    return (everything[n : n + BATCH] for n in range(0, len(everything), BATCH))


def next_turn(session: Session, priority: int, owner_id: int | None = None) -> int:
    """Where the line of a priority stands: the turn of its first case or, if none waits, behind those that run. For
    an owner, with the first that runs or, later, behind all studies of that owner.
    """
    of_priority = select(Case.turn).where(Case.priority == priority)
    queued = session.scalar(of_priority.where(Case.state == "queued").order_by(Case.turn).limit(1))
    running = of_priority.where(Case.state == "running")
    behind = select(func.max(Study.end_turn)).where(Study.priority == priority)
    if owner_id is None:
        last = session.scalar(running.order_by(Case.turn.desc()).limit(1))
        stand = queued if queued is not None else None if last is None else last + 1
    else:
        first = session.scalar(running.order_by(Case.turn).limit(1))
        stand = queued if first is None else first
    if stand is None:  # nobody is there: on from where the line was, as owners remember their place in it
        stand = session.scalar(behind) or 0
    if owner_id is None:
        return stand
    return max(stand, session.scalar(behind.where(Study.owner_id == owner_id)) or 0)


def lock_cases(session: Session, study_id: str, states: Sequence[CaseState]) -> Sequence[Row[Any]]:
    """A study's cases in some states, locked, each with its place in the study and, as ``wanted``, the highest priority
    among other live studies that contain it; None if there are none.
    """
    wanted = (
        select(func.max(Study.priority))
        .join(StudyCase, StudyCase.study_id == Study.id)
        .where(StudyCase.case_id == Case.id, Study.id != study_id, Study.cancel_requested_at.is_(None))
        .correlate(Case)
        .scalar_subquery()
    )
    return session.execute(
        select(Case.id, Case.state, Case.priority, StudyCase.position, wanted.label("wanted"))
        .join(StudyCase, StudyCase.case_id == Case.id)
        .where(StudyCase.study_id == study_id, Case.state.in_(states))
        .order_by(Case.digest)
        .with_for_update(key_share=True, of=Case)
    ).all()


def line_up(session: Session, cases: Iterable[Row[Any]], priority: int, begin: int) -> int:
    """Give locked cases a priority, and turns from one on in the order of their study. Returns the turn behind them."""
    places = [
        {"id": row.id, "priority": priority, "turn": begin + n}
        for n, row in enumerate(sorted(cases, key=lambda row: int(row.position)))
    ]
    if places:
        session.execute(update(Case), places)
    return begin + len(places)


def revive(session: Session, ids: Iterable[int], charged_to: int | None) -> None:
    """Queue cases that had ended, as if they had never been tried: where there is no success, there are no peaks. They
    are charged to whose key asks for that.
    """
    nothing = dict.fromkeys(("error", "processing", "started_at", "finished_at", "worker"))
    anew = {"state": "queued", "attempt": 0, "progress": 0.0, "charged_to": charged_to, **nothing}
    for some in batches(ids):
        session.execute(update(Case).where(Case.id.in_(some)).values(anew))
        session.execute(delete(Peak).where(Peak.case_id.in_(some)))


def call_off(session: Session, ids: Iterable[int]) -> None:
    """Cancel unfinished cases. Whoever computes one finds at the next heartbeat that the lease is gone."""
    values = {"state": "cancelled", "finished_at": Clock(), "lease_token": None, "lease_expires": None, "error": None}
    for some in batches(ids):
        session.execute(update(Case).where(Case.id.in_(some)).values(values))
        tally.count(session, "cases_ended", "cancelled", len(some))
