"""What can become of a study after it was accepted.

What one study does to cases that others contain too: nothing that another live study would notice. A study is live
until it is cancelled or deleted.
"""

from collections import defaultdict
from collections.abc import Callable, Sequence
from typing import Any

from sqlalchemy import Row, delete, exists, select
from sqlalchemy.orm import Session

from app import events
from app.access import quotas
from app.access.caller import ANYBODY, Caller
from app.cases import queue
from app.context import Context
from app.db.models import Case, History, Study, StudyCase
from app.db.types import Clock
from app.problems import Problem, invalid, not_found
from app.studies import service
from app.studies.schemas import MAX_LABELS, StudyDetail, StudyPatch


def update(context: Context, study_id: str, patch: StudyPatch, check: Callable[[StudyDetail], None]) -> StudyDetail:
    """Change a study's name, labels or priority.

    Parameters
    ----------
    check : callable
        Called with the study as it is; raises if the client means another version of it.

    Raises
    ------
    Problem
        404 if there is no such study, 422 if it would have too many labels.
    """
    with context.database.write() as session:
        study = _find(session, study_id)
        check(service.get(session, study_id))
        changes = patch.model_dump(exclude_unset=True)
        merged = study.labels | changes.pop("labels", {})
        study.labels = {label: value for label, value in merged.items() if value is not None}
        if len(study.labels) > MAX_LABELS:
            detail = f"The study would have {len(study.labels)} labels; it may have {MAX_LABELS}."
            raise invalid("/labels", "too-many-labels", detail)
        if "priority" in changes and study.cancel_requested_at is None:
            cases = queue.lock_cases(session, study_id, queue.UNFINISHED)
            _move(session, study, cases, changes["priority"])
        for name, value in changes.items():
            setattr(study, name, value)
        session.flush()
        return service.get(session, study_id)


def cancel(context: Context, study_id: str) -> StudyDetail:
    """Cancel a study that has not ended.

    Cases that no other live study contains are cancelled at once, running ones too: their lease is taken away, the
    worker stops at its next heartbeat and writes nothing. So the study is cancelled when this returns, and never seen
    ``cancelling``. The others go on, with the priority of who still wants them.

    Raises
    ------
    Problem
        404 if there is no such study.
    """
    with context.database.write() as session:
        study = _find(session, study_id)
        if study.cancel_requested_at is None and (cases := queue.lock_cases(session, study_id, queue.UNFINISHED)):
            queue.call_off(session, [row.id for row in cases if row.wanted is None])
            _move(session, study, [row for row in cases if row.wanted is not None], None)
            study.cancel_requested_at = study.finished_at = Clock()
            session.flush()  # locks the study, before its events
            events.record(session, study_id, "done", {"state": events.state_now(session, study_id)})
        return service.get(session, study_id)


def retry(context: Context, study_id: str, caller: Caller = ANYBODY) -> StudyDetail:
    """Queue the failed and cancelled cases of a study once more; it is live again if it was cancelled.

    A failed case is tried again for every study that contains it.

    Raises
    ------
    Problem
        404 if there is no such study, 429 if the caller's quota is used up.
    """
    with context.database.write() as session:
        study = _find(session, study_id)
        cases = queue.lock_cases(session, study_id, (*queue.UNFINISHED, "failed", "cancelled"))
        ended = [row for row in cases if row.state not in queue.UNFINISHED]
        if ended or study.cancel_requested_at is not None:
            queue.revive(session, [row.id for row in ended], caller.key_id)
            if ended:
                quotas.check(session, caller)
            _line_up(session, study, ended, study.priority)
            _move(session, study, [row for row in cases if row.state in queue.UNFINISHED], study.priority)
            study.cancel_requested_at = study.finished_at = None
            session.flush()  # locks the study, before its events
            events.state_now(session, study_id)
            events.finish_if_done(session, study_id)
        answer = service.get(session, study_id)
    if answer.cases.queued:
        context.doorbell.ring()
    return answer


def remove(context: Context, study_id: str) -> None:
    """Delete a study that has ended, as :func:`forget` does.

    Raises
    ------
    Problem
        404 if there is no such study, 409 if it has not ended.
    """
    with context.database.write() as session:
        study = _find(session, study_id)
        if (state := service.get(session, study_id).state) in ("queued", "running"):
            raise Problem(409, f"The study is {state}. Cancel it before you delete it.", code="study-not-ended")
        forget(session, study)


def forget(session: Session, study: Study) -> None:
    """Delete a study that has ended.

    Cases of other studies stay as they are. Of the rest, those that succeeded stay too, with their peaks: they are
    results, small and dear, which the next study that contains them need not compute again. Failed and cancelled ones
    go, so that such a study tries them anew. Histories are large and kept on request: those that no other study asked
    to keep are forgotten here, and the sweeper deletes the objects.
    """
    ids = session.scalars(select(StudyCase.case_id).where(StudyCase.study_id == study.id)).all()
    session.delete(study)
    session.flush()
    studies = select(StudyCase).where(StudyCase.case_id == Case.id)
    keeping = select(Study).join(StudyCase).where(StudyCase.case_id == History.case_id, Study.keep_history)
    for some in queue.batches(ids):
        session.execute(delete(History).where(History.case_id.in_(some), ~exists(keeping)))
        worthless = Case.state.in_(["failed", "cancelled"])
        session.execute(delete(Case).where(Case.id.in_(some), worthless, ~exists(studies)))


def _find(session: Session, study_id: str) -> Study:
    queue.one_at_a_time(session)
    study = session.get(Study, study_id)
    if study is None:
        raise not_found("study")
    return study


def _move(session: Session, study: Study, cases: Sequence[Row[Any]], priority: int | None) -> None:
    """Let unfinished cases have the highest priority among the studies that want them, this one's being as given."""
    targets: dict[int, list[Row[Any]]] = defaultdict(list)
    for row in cases:
        target = max(each for each in (priority, row.wanted) if each is not None)
        if target != row.priority:
            targets[target].append(row)
    for target, rows in targets.items():
        if target == priority:
            _line_up(session, study, rows, target)
        else:  # for the sake of others
            queue.line_up(session, rows, target, queue.next_turn(session, target))


def _line_up(session: Session, study: Study, cases: Sequence[Row[Any]], priority: int) -> None:
    study.end_turn = queue.line_up(session, cases, priority, queue.next_turn(session, priority, study.owner_id))
