"""What can be done with studies."""

import hashlib
from functools import cache, partial
from typing import Any
from uuid import uuid4

import structlog
from sqlalchemy import Row, insert
from sqlalchemy.orm import Session

from app import events, idempotency
from app.access import quotas, visibility
from app.access.caller import ANYBODY, Caller, forbidden
from app.cases import queue
from app.cases.repository import enqueue, row_of
from app.context import Context
from app.db import tally
from app.db.models import Study, StudyCase
from app.problems import FieldProblem, Problem, invalid, not_found
from app.profiles import repository as profiles
from app.studies import forecast, loads, repository
from app.studies.schemas import (
    CaseCounts,
    FinishEstimate,
    StudyDetail,
    StudyPage,
    StudyQuery,
    StudyRequest,
    StudySummary,
)
from app.studies.sweep import ContradictionError
from solver.case import Case

log = structlog.get_logger()


def create(context: Context, request: StudyRequest, key: str | None, caller: Caller = ANYBODY) -> StudyDetail:
    """Accept a study: store it, queue its cases, wake a worker.

    Raises
    ------
    Problem
        409 if a request with the key is in progress; 422 if the study is too large, its values contradict each other,
        or the key belongs to another request; 429 if the caller's quota is used up.
    """
    check_priority(caller, request.priority)
    if key is None:
        return _create(context, request, None, caller)
    key = idempotency.key_of(caller.key_id, key)
    with context.in_progress.only(key):
        return _create(context, request, key, caller)


def _create(context: Context, request: StudyRequest, key: str | None, caller: Caller) -> StudyDetail:
    cases = expand(context, request, caller)
    rows = {row["digest"]: row for row in (row_of(case, request.priority) for case in cases)}
    digest = hashlib.sha256(request.model_dump_json().encode()).hexdigest()
    with context.database.write() as session:
        if key is not None:
            idempotency.hold(session, key)
        queue.one_at_a_time(session)
        if key is not None and (answer := idempotency.recall(session, key, digest)) is not None:
            return StudyDetail.model_validate({"owner": None} | answer)  # the version before knew of no owners
        study = get(session, _store(session, request, rows, caller))
        profiles.hold(session, study.id, profiles.used_by(cases))
        if key is not None:
            idempotency.remember(session, key, digest, study.model_dump(mode="json"))
    log.info("study created", study_id=study.id, cases=study.cases.total, reused=study.cases_reused)
    if study.cases.queued:
        context.doorbell.ring()
    return study


def check_priority(caller: Caller, priority: int | None) -> None:
    """Let only administrators put their studies before those of others.

    Raises
    ------
    Problem
        403.
    """
    if priority is not None and priority > 0 and not caller.is_admin:
        raise forbidden("A priority above 0 takes a key of scope admin.", "priority-needs-admin")


def expand(context: Context, request: StudyRequest, caller: Caller = ANYBODY) -> list[Case]:
    """The cases of a study, counted before they are made.

    Raises
    ------
    Problem
        422 if there are more than the limit, or the values contradict each other.
    """
    if (count := request.count()) > (limit := context.settings.max_cases_per_study):
        detail = f"The sweep has {count} cases; a study may have {limit} (max_cases_per_study)."
        error = FieldProblem(pointer="/sweep", code="max-cases-per-study", detail=detail)
        raise Problem(422, detail, code="max-cases-per-study", errors=[error])
    try:
        with context.database.read() as session:
            return request.expand(cache(partial(profiles.samples, session, caller=caller)))
    except ContradictionError as error:
        raise invalid(error.pointer, "contradiction", error.detail) from None


def get(session: Session, study_id: str) -> StudyDetail:
    """One study.

    Raises
    ------
    Problem
        404 if there is none.
    """
    row = repository.find(session, study_id)
    if row is None:
        raise not_found("study")
    definition = row.Study.request
    return StudyDetail.model_validate(_summary(row) | {"finish": _finish(session, row), "definition": definition})


def list_page(session: Session, query: StudyQuery, max_page_size: int, caller: Caller) -> StudyPage:
    """A page of the studies that the caller sees."""
    rows, cursor = repository.find_page(session, query, max_page_size, *visibility.studies(caller))
    return StudyPage(items=[StudySummary.model_validate(_summary(row)) for row in rows], next_cursor=cursor)


def _store(session: Session, request: StudyRequest, rows: dict[str, dict[str, Any]], caller: Caller) -> str:
    begin = queue.next_turn(session, request.priority, caller.key_id)
    enqueued = enqueue(session, rows, begin, keep_history=request.keep_history, charged_to=caller.key_id)
    tally.count(session, "cases_requested", "reused", enqueued.reused)
    tally.count(session, "cases_requested", "queued", enqueued.end - begin)
    if enqueued.charged:
        quotas.check(session, caller)
    study = Study(
        id=uuid4().hex,
        owner_id=caller.key_id,
        end_turn=enqueued.end,
        name=request.name,
        labels=request.labels,
        priority=request.priority,
        keep_history=request.keep_history,
        request=request.model_dump(mode="json", exclude_unset=True),
        cases_reused=enqueued.reused,
    )
    session.add(study)
    session.flush()  # before the rows that refer to it
    events.record(session, study.id, "state", {"state": "queued"})
    places = [{"study_id": study.id, "case_id": enqueued.ids[digest], "position": n} for n, digest in enumerate(rows)]
    session.execute(insert(StudyCase), places)
    events.finish_if_done(session, study.id)
    return study.id


def _summary(row: Row[Any]) -> dict[str, Any]:
    columns = {name: getattr(row.Study, name) for name in StudySummary.model_fields if hasattr(row.Study, name)}
    counts = {name: getattr(row, name) for name in CaseCounts.model_fields}
    return columns | {
        "owner": row.owner,
        "state": row.state,
        "progress": row.progress,
        "cases": counts,
        "finished_at": None if row.state in ("queued", "running") else row.Study.finished_at,
    }


def _finish(session: Session, row: Row[Any]) -> FinishEstimate | None:
    if row.state not in ("queued", "running"):
        return None
    to_come = [*loads.left(session, row.Study.id), *loads.ahead(session, row.Study)]
    cpu, _ = forecast.cpu_s(session, to_come)
    return forecast.finish(session, cpu)
