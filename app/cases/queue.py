"""The order of the queue: by priority, then by turn, then by age.

A turn is a place in a line that all studies of one priority share. A new study begins where the line stands, and its
n-th case stands n places behind that; so two studies alternate however many cases each has, and a small study does
not wait for a large one that came before. (This is start-time fair queueing with every case of equal weight. Were it
to be fair between owners rather than studies, an owner's next study would begin behind the last turn of that owner.)

Whoever changes which studies want which cases calls :func:`one_at_a_time` first. Rows of cases are locked in the
order of their digests, before those of studies.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, TypeVar

from sqlalchemy import Row, func, select, text, update
from sqlalchemy.orm import Session

from app.db.models import Case, CaseState, Study, StudyCase
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


def next_turn(session: Session, priority: int) -> int:
    """Where the line of a priority stands: the turn of its first case or, if none waits, behind those that run."""
    of_priority = select(Case.turn).where(Case.priority == priority)
    first = of_priority.where(Case.state == "queued").order_by(Case.turn).limit(1)
    last = of_priority.where(Case.state == "running").order_by(Case.turn.desc()).limit(1)
    if (turn := session.scalar(first)) is not None:
        return turn
    return 0 if (turn := session.scalar(last)) is None else turn + 1


def lock_cases(session: Session, study_id: str, states: Sequence[CaseState]) -> Sequence[Row[Any]]:
    """A study's cases in some states, locked, each with the highest priority among other live studies that contain
    it as ``wanted``; None if there are none.
    """
    wanted = (
        select(func.max(Study.priority))
        .join(StudyCase, StudyCase.study_id == Study.id)
        .where(StudyCase.case_id == Case.id, Study.id != study_id, Study.cancel_requested_at.is_(None))
        .correlate(Case)
        .scalar_subquery()
    )
    return session.execute(
        select(Case.id, Case.state, Case.priority, wanted.label("wanted"))
        .join(StudyCase, StudyCase.case_id == Case.id)
        .where(StudyCase.study_id == study_id, Case.state.in_(states))
        .order_by(Case.digest)
        .with_for_update(key_share=True, of=Case)
    ).all()


def line_up(session: Session, study_id: str, ids: Iterable[int], priority: int, begin: int) -> None:
    """Give cases of a study a priority, and turns from one on in the order of the study."""
    place = select(StudyCase.position).where(StudyCase.study_id == study_id, StudyCase.case_id == Case.id)
    values = {"priority": priority, "turn": begin + place.scalar_subquery()}
    for some in batches(ids):
        session.execute(update(Case).where(Case.id.in_(some)).values(values))


def revive(session: Session, ids: Iterable[int]) -> None:
    """Queue cases that had ended, as if they had never been tried."""
    nothing = dict.fromkeys(("error", "processing", "started_at", "finished_at", "worker"))
    anew = {"state": "queued", "attempt": 0, "progress": 0.0, **nothing}
    for some in batches(ids):
        session.execute(update(Case).where(Case.id.in_(some)).values(anew))


def call_off(session: Session, ids: Iterable[int]) -> None:
    """Cancel unfinished cases. Whoever computes one finds at the next heartbeat that the lease is gone."""
    values = {"state": "cancelled", "finished_at": Clock(), "lease_token": None, "lease_expires": None, "error": None}
    for some in batches(ids):
        session.execute(update(Case).where(Case.id.in_(some)).values(values))
