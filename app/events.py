"""What happens to studies, written down in the transaction that makes it happen.

Whoever records an event of a study that others can see has locked the study's row, and holds the lock until the
commit. So the events of one study become visible in the order of their numbers, although PostgreSQL hands out numbers
before it is known who commits first, and a follower who asks for all after the last one seen misses none.
"""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import insert, select, update
from sqlalchemy.orm import Session

from app.db import tally
from app.db.models import Case, CaseState, Event, EventKind, Study, StudyCase
from app.db.types import Clock
from app.studies import repository

LIVE = Study.cancel_requested_at.is_(None)  # a study that was cancelled hears no more of cases it shares


def record(session: Session, study_id: str, kind: EventKind, payload: dict[str, Any]) -> None:
    """Write one event. It is numbered now: later events of this transaction come later."""
    session.execute(insert(Event), {"study_id": study_id, "kind": kind, "payload": payload})


def cases_started(session: Session, case_ids: Sequence[int]) -> None:
    """A worker took cases: studies in which they are the first are running."""
    containing = select(StudyCase.study_id).where(StudyCase.case_id.in_(case_ids))
    waiting = select(Study.id).where(Study.started_at.is_(None), Study.id.in_(containing), LIVE).order_by(Study.id)
    for study_id in session.scalars(waiting.with_for_update(key_share=True)).all():
        session.execute(update(Study).where(Study.id == study_id).values(started_at=Clock()))
        record(session, study_id, "state", {"state": "running"})


def cases_ended(session: Session, case_ids: Sequence[int], state: CaseState) -> None:
    """Cases reached their end: studies in which they were the last are finished.

    Call it after the cases' own rows were updated. Their locks, and then the studies', order the ends of two
    last cases on PostgreSQL: without them each would see the other still running, and nobody would say `done`.
    """
    tally.count(session, "cases_ended", state, len(case_ids))
    containing = select(StudyCase.study_id, StudyCase.case_id).where(StudyCase.case_id.in_(case_ids))
    pairs = session.execute(containing.order_by(StudyCase.study_id, StudyCase.position)).all()
    studies = select(Study.id).where(Study.id.in_({study_id for study_id, _ in pairs}), LIVE).order_by(Study.id)
    concerned = session.scalars(studies.with_for_update(key_share=True)).all()  # from here on others wait
    told = [
        {"study_id": study_id, "kind": "case", "payload": {"case_id": case_id, "state": state}}
        for study_id, case_id in pairs
        if study_id in concerned
    ]
    if told:
        session.execute(insert(Event), told)
    for study_id in concerned:
        finish_if_done(session, study_id)


def finish_if_done(session: Session, study_id: str) -> None:
    """Write down the end of a study if none of its cases is still to come."""
    own = select(StudyCase.case_id).where(StudyCase.study_id == study_id)
    to_come = select(Case.id).where(Case.state.in_(["queued", "running"])).limit(1)
    # The last is looked at first: while it waits, as most of the time, nobody looks for others among thousands.
    last = own.order_by(StudyCase.case_id.desc()).limit(1)
    if any(session.scalar(to_come.where(Case.id.in_(of_study))) is not None for of_study in (last, own)):
        return
    session.execute(update(Study).where(Study.id == study_id).values(finished_at=Clock()))
    state = state_now(session, study_id)
    record(session, study_id, "done", {"state": state})


def state_now(session: Session, study_id: str) -> str:
    """Write down the state that a study has come to. Returns it."""
    state = repository.state(session, study_id)
    record(session, study_id, "state", {"state": state})
    return state
