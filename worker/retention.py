"""What is kept no longer: studies that ended long ago, and results that no study refers to any more."""

import structlog
from sqlalchemy import delete, exists, or_, select
from sqlalchemy.orm import Session

from app.cases import queue
from app.db.models import Case, Study, StudyCase
from app.db.types import Clock
from app.studies import lifecycle

DAY_S = 24 * 3600.0
CASES_AT_ONCE = 200  # with their peaks, thousands of rows: others write in between

log = structlog.get_logger()


def expire(session: Session, days: int) -> int:
    """Delete one study, and some cases without a study, that ended more than some days ago.

    A case that a study contains stays, however old it is, and so does a history that a study asked to keep.

    Returns
    -------
    int
        How many of both; 0 when nothing is left to delete.
    """
    queue.one_at_a_time(session)  # nobody may come to want a case meanwhile
    before = Clock() - days * DAY_S
    unfinished = select(StudyCase).join(Case).where(StudyCase.study_id == Study.id, Case.state.in_(queue.UNFINISHED))
    ended = or_(Study.cancel_requested_at.is_not(None), ~exists(unfinished))
    study = session.scalars(
        select(Study).where(Study.finished_at < before, ended).order_by(Study.finished_at).limit(1)
    ).one_or_none()
    if study is not None:
        log.info("study expired", study_id=study.id, name=study.name)
        lifecycle.forget(session, study)
    unused = ~exists().where(StudyCase.case_id == Case.id)
    old = select(Case.id).where(Case.finished_at < before, Case.state.not_in(queue.UNFINISHED), unused)
    ids = session.scalars(old.limit(CASES_AT_ONCE)).all()
    session.execute(delete(Case).where(Case.id.in_(ids)))
    return len(ids) + (study is not None)
