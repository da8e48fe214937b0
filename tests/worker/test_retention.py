"""What retention deletes and what it leaves, on both databases."""

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from sqlalchemy import func, select, text, update

from app.cases import queue
from app.context import Context
from app.db.models import Case, Event, History, Peak, Study, StudyCase, Verification
from app.settings import Settings
from app.studies import lifecycle, service
from app.studies.schemas import StudyDetail
from tests.outcomes import succeed
from worker import lease, retention
from worker.claim import claim
from worker.sweeper import Sweeper

Submit = Callable[..., StudyDetail]
STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
PEAK: dict[str, Any] = {"quantity": "pad_force", "position": "middle", "unit": "N"} | dict.fromkeys(STATISTICS, 1.0)
DAY_S = 24 * 3600.0


def finish_all(context: Context, state: str = "succeeded") -> None:
    """End whatever is queued, with a peak and a history."""
    while True:
        with context.database.write() as session:
            batch = claim(session, "test", 15.0, 1)
            for held in batch:
                if state == "failed":
                    lease.fail(session, held, "diverged", "for a test")
                    continue
                history = {"key": f"{held.case_id}.npz", "digest": "d" * 64, "size_bytes": 1}
                assert succeed(session, held, peaks=[PEAK], processing={}, history=history, cpu_s=1.0)
        if not batch:
            return


def age(context: Context, study: StudyDetail, days: float, *, cases: bool = True) -> None:
    """Let a study, and its cases, have ended some days ago."""
    with context.database.write() as session:
        long_ago = Study.finished_at - days * DAY_S
        session.execute(update(Study).where(Study.id == study.id).values(finished_at=long_ago))
        if cases:
            ids = select(StudyCase.case_id).where(StudyCase.study_id == study.id)
            session.execute(update(Case).where(Case.id.in_(ids)).values(finished_at=Case.finished_at - days * DAY_S))


def expire_all(context: Context, days: int = 30) -> None:
    for _ in range(20):
        with context.database.write() as session:
            if retention.expire(session, days) == 0:
                return
    raise AssertionError("there is always something left to delete")


def left(context: Context) -> dict[str, set[Any]]:
    with context.database.read() as session:
        return {
            "studies": set(session.scalars(select(Study.name))),
            "cases": set(session.scalars(select(Case.speed_kmh))),
            "peaks": set(session.scalars(select(Peak.speed_kmh))),
            "histories": set(session.scalars(select(Case.speed_kmh).join(History))),
        }


def test_what_a_study_refers_to_stays_and_the_rest_goes(context: Context, submit: Submit) -> None:
    old = submit(200, 210, keep_history=True, name="old")
    finish_all(context)
    young = submit(210, 220, name="young")
    finish_all(context)
    with context.database.write() as session:
        case_id = session.scalars(select(Case.id).where(Case.speed_kmh == 200)).one()
        session.add(Verification(case_id=case_id))
    age(context, old, 31)
    expire_all(context)
    assert left(context) == {"studies": {"young"}, "cases": {210, 220}, "peaks": {210, 220}, "histories": {220}}
    with context.database.read() as session:
        assert session.scalar(select(func.count()).where(Event.study_id == old.id)) == 0
        assert service.get(session, young.id).state == "succeeded"
        assert session.scalar(select(func.count()).select_from(Verification)) == 0
    age(context, young, 31)
    expire_all(context)
    assert left(context) == {"studies": set(), "cases": set(), "peaks": set(), "histories": set()}


def test_a_history_that_a_younger_study_keeps_stays(context: Context, submit: Submit) -> None:
    old = submit(200, keep_history=True, name="old")
    finish_all(context)
    submit(200, keep_history=True, name="young")
    age(context, old, 31)
    expire_all(context)
    assert left(context) == {"studies": {"young"}, "cases": {200}, "peaks": {200}, "histories": {200}}


def test_what_has_not_ended_stays_however_old(context: Context, submit: Submit) -> None:
    submit(200, name="queued")
    again = submit(210, name="again")
    finish_all(context)
    age(context, again, 31)
    submit(220, name="more")
    with context.database.write() as session:  # computed once more, as when a study wants histories
        session.execute(update(Case).where(Case.speed_kmh == 210).values(state="queued", finished_at=None))
        ids = select(StudyCase.case_id).join(Study).where(Study.name == "queued")
        session.execute(update(Case).where(Case.id.in_(ids)).values(state="running", finished_at=1.0))
    expire_all(context)
    assert left(context)["studies"] == {"queued", "again", "more"}


def test_failed_and_cancelled_studies_go_too_and_leave_shared_cases(context: Context, submit: Submit) -> None:
    failed = submit(200, name="failed")
    finish_all(context, "failed")
    cancelled = submit(210, 220, name="cancelled")
    submit(220, name="other")
    lifecycle.cancel(context, cancelled.id)
    age(context, failed, 31)
    age(context, cancelled, 31, cases=False)
    expire_all(context)
    assert (left(context)["studies"], left(context)["cases"]) == ({"other"}, {220})


def test_results_of_deleted_studies_stay_for_as_long_as_studies_would(context: Context, submit: Submit) -> None:
    study = submit(200, name="deleted by hand")
    finish_all(context)
    lifecycle.remove(context, study.id)
    expire_all(context)
    assert left(context)["peaks"] == {200}
    with context.database.write() as session:
        session.execute(update(Case).values(finished_at=Case.finished_at - 31 * DAY_S))
    expire_all(context)
    assert left(context)["cases"] == set()


def test_a_case_that_a_study_is_coming_to_want_stays(context: Context, submit: Submit) -> None:
    """On SQLite there is nothing to interleave: whoever writes is alone."""
    if context.database.engine.name == "sqlite":
        return
    first = submit(200)
    finish_all(context)
    lifecycle.remove(context, first.id)
    with context.database.write() as session:
        session.execute(update(Case).values(finished_at=1.0))

    def expire() -> int:
        with context.database.write() as session:
            return retention.expire(session, 30)

    with ThreadPoolExecutor(1) as pool:
        with context.database.write() as session:
            queue.one_at_a_time(session)
            case = session.scalars(select(Case).with_for_update(key_share=True)).one()
            expiring = pool.submit(expire)
            waiting = text("SELECT 1 FROM pg_locks WHERE NOT granted LIMIT 1")
            while session.scalar(waiting) is None:
                time.sleep(0.01)
            study = Study(
                id="0" * 32, name="new", labels={}, priority=0, keep_history=False, request={}, cases_reused=1
            )
            session.add(study)
            session.flush()
            session.add(StudyCase(study_id=study.id, case_id=case.id, position=0))
        assert expiring.result() == 0


def test_a_sweeper_expires_studies_where_that_is_asked_for(context: Context, submit: Submit, tmp_path: Path) -> None:
    for retention_days, expected in ((0, {"one", "two", "three"}), (30, {"three"})):
        if retention_days == 0:
            for n, name in enumerate(sorted(expected)):
                study = submit(200 + n, name=name)
                finish_all(context)
                age(context, study, 0 if name == "three" else 31)
        settings = Settings(**context.settings.model_dump() | {"retention_days": retention_days, "lease_s": 0.1})
        sweeper = Sweeper(settings)
        sweeper.start()
        if retention_days:
            while left(context)["studies"] != expected:
                time.sleep(0.05)
        sweeper.stop()
        assert left(context)["studies"] == expected
