"""Claiming, keeping and losing cases, on both databases."""

import multiprocessing
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import pytest
from sqlalchemy import func, select, update
from sqlalchemy.exc import InternalError

from app.context import Context
from app.db.models import Case, Event, IdempotencyKey, Peak
from app.db.session import Database
from app.db.types import Clock
from app.idempotency import KEPT_S
from app.settings import Settings
from app.studies import service
from app.studies.schemas import StudyDetail
from tests.e2e.conftest import until
from tests.outcomes import succeed
from worker import claim as claims
from worker import heartbeat, lease
from worker.claim import Claim
from worker.success import Success, write_down
from worker.sweeper import sweep

Submit = Callable[..., StudyDetail]


def claim(database: Database, lease_s: float = 15.0) -> Claim:
    with database.write() as session:
        (held,) = claims.claim(session, "test", lease_s, lanes=1)
    return held


def expire(database: Database) -> None:
    """Let every lease run out."""
    with database.write() as session:
        session.execute(update(Case).values(lease_expires=Clock() - 0.001))


def swept(database: Database) -> bool:
    """Whether a sweep found that there is something to do."""
    with database.write() as session:
        return sweep(session, max_attempts=3)


def get(database: Database, case_id: int) -> Case:
    with database.read() as session:
        return session.scalars(select(Case).where(Case.id == case_id)).one()


def claim_all(url: str) -> list[int]:
    """Claim and finish until nothing is queued, from four threads."""
    database = Database(url)

    def drain(_: int) -> list[int]:
        mine = []
        while True:
            with database.write() as session:
                batch = claims.claim(session, "test", 15.0)
            if not batch:
                return mine
            for held in batch:
                with database.write() as session:
                    assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=0.0)
                mine.append(held.case_id)

    with ThreadPoolExecutor(4) as pool:
        claimed = [case_id for mine in pool.map(drain, range(4)) for case_id in mine]
    database.close()
    return claimed


@pytest.fixture(scope="module")
def two_processes() -> Iterator[ProcessPoolExecutor]:
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        yield pool


def test_many_workers_claim_each_case_once(
    database_url: str, database: Database, submit: Submit, two_processes: ProcessPoolExecutor
) -> None:
    studies = [submit(*range(200, 240)), submit(*range(220, 260))]  # in part the same cases
    studies.append(submit(300, amplitudes=[n / 100 for n in range(1, 31)]))  # claimed several at a time
    claimed = [case_id for mine in two_processes.map(claim_all, [database_url] * 2) for case_id in mine]
    assert len(claimed) == 90
    assert max(Counter(claimed).values()) == 1
    with database.read() as session:
        assert [service.get(session, study.id).state for study in studies] == ["succeeded"] * 3
        done = session.scalars(select(Event.study_id).where(Event.kind == "done")).all()
        assert sorted(done) == sorted(study.id for study in studies)  # each said once
        ends = select(func.count()).where(Event.kind == "case")
        assert session.scalar(ends) == 110


def test_the_last_two_cases_end_at_once(database: Database, submit: Submit) -> None:
    for speed in range(200, 210):
        submit(speed, speed + 100)
        held = [claim(database), claim(database)]

        def end(one: Claim) -> None:
            with database.write() as session:
                assert succeed(session, one, peaks=[], processing={}, history=None, cpu_s=0.0)

        with ThreadPoolExecutor(2) as pool:
            list(pool.map(end, held))
    with database.read() as session:
        assert session.scalar(select(func.count()).where(Event.kind == "done")) == 10


def test_order_is_priority_and_then_turn(database: Database, submit: Submit) -> None:
    submit(200, 210)
    submit(220, priority=5)
    submit(230, 210, priority=1)  # lends its priority to the case that both want
    speeds = []
    for _ in range(4):
        speeds.append(get(database, claim(database).case_id).speed_kmh)
    assert speeds == [220, 230, 210, 200]


def test_nothing_to_claim(database: Database) -> None:
    with database.write() as session:
        assert claims.claim(session, "test", 15.0) == []


def test_an_expired_lease_is_given_to_another_and_the_late_one_is_fenced_out(
    database: Database, submit: Submit
) -> None:
    submit(300)
    late = claim(database)
    with database.write() as session:
        assert not sweep(session, max_attempts=3)  # still holds
    expire(database)
    with database.write() as session:
        assert not sweep(session, max_attempts=3, forbearing=True)  # as nobody could say that he lives
    with ThreadPoolExecutor(4) as pool:  # sweepers at once

        def run(_: int) -> bool:
            with database.write() as session:
                return sweep(session, max_attempts=3)

        assert any(pool.map(run, range(4)))
    again = claim(database)
    assert (again.case_id, again.attempt) == (late.case_id, late.attempt + 1)
    found = [_peak()]
    with database.write() as session:
        assert not lease.extend(session, [late], 15.0, {late.case_id: 0.9})
        assert not succeed(session, late, peaks=found, processing={}, history=None, cpu_s=1.0)
        assert not lease.fail(session, late, "diverged", "late")
        assert not lease.give_up(session, late, 3, "late")
        assert not lease.release(session, late)
    assert (get(database, late.case_id).state, get(database, late.case_id).progress) == ("running", 0)
    with database.write() as session:
        assert succeed(session, again, peaks=found, processing={}, history=None, cpu_s=1.0)
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Peak)) == 1


def test_of_cases_written_together_one_that_was_lost_keeps_what_another_wrote(
    database: Database, submit: Submit
) -> None:
    submit(300, amplitudes=(0.1, 0.2, 0.3))
    with database.write() as session:
        first, second, *_ = claims.claim(session, "test", 15.0)
        session.execute(update(Case).where(Case.id == first.case_id).values(lease_token="of another"))
    outcome = {"peaks": [_peak()], "processing": {}, "history": None, "cpu_s": 1.0, "simulated_s": 1.0}
    with database.write() as session:
        successes = [Success(held=held, **outcome) for held in (first, second)]
        assert write_down(session, successes, places=1) == {second.case_id}
    assert [get(database, held.case_id).state for held in (first, second)] == ["running", "succeeded"]
    with database.read() as session:
        assert session.scalars(select(Peak.case_id)).all() == [second.case_id]
        told = session.scalars(select(Event.payload).where(Event.kind == "case")).all()
    assert told == [{"case_id": second.case_id, "state": "succeeded"}]


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_a_worker_that_is_stopped_amid_a_transaction_does_not_hold_its_locks_for_longer_than_a_lease(
    database: Database, database_url: str, submit: Submit
) -> None:
    submit(300)
    held = claim(database)
    expire(database)
    stopped = Database(database_url, pause_s=0.5)
    with stopped.engine.connect() as connection:
        assert connection.scalars(select(Case.id).with_for_update()).all() == [held.case_id]
        swept(database)
        assert get(database, held.case_id).state == "running"
        until(lambda: swept(database) and get(database, held.case_id).state == "queued", 30)
        with pytest.raises(InternalError, match="idle-in-transaction"):
            connection.commit()
    stopped.close()


def _peak() -> dict[str, object]:
    return {"quantity": "pad_force", "position": "middle", "unit": "N"} | dict.fromkeys(STATISTICS, 1.0)


STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")


def test_a_heartbeat_keeps_the_lease(database: Database, submit: Submit) -> None:
    submit(300)
    held = claim(database, lease_s=0.0)
    with database.write() as session:
        assert lease.extend(session, [held], 15.0, {held.case_id: 0.25})
        sweep(session, max_attempts=3)
    case = get(database, held.case_id)
    assert (case.state, case.progress, case.attempt) == ("running", 0.25, 1)


def test_a_heartbeat_tells_of_each_case(database: Database, submit: Submit) -> None:
    submit(300, 310, 320)
    held = [claim(database, lease_s=0.0) for _ in range(3)]
    fractions = {each.case_id: fraction for each, fraction in zip(held, (0.25, 0.5, 0.25), strict=True)}
    with database.write() as session:
        assert lease.release(session, held[2])
    with database.write() as session:
        assert lease.extend(session, held, 15.0, fractions) == {held[0].case_id, held[1].case_id}
    assert [get(database, each.case_id).progress for each in held] == [0.25, 0.5, 0.0]
    with database.write() as session:
        assert claims.claim(session, "other", 15.0, lanes=1)[0].case_id == held[2].case_id
        assert not sweep(session, max_attempts=3)


def test_a_busy_database_hears_fewer_heartbeats(
    database: Database, submit: Submit, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    submit(300)
    held, beats = claim(database), 0

    def extend(*_: object) -> set[int]:
        nonlocal beats
        beats += 1
        time.sleep(0.05)
        return {held.case_id}

    monkeypatch.setattr(heartbeat, "LONGEST_SILENCE_S", 0.01)
    monkeypatch.setattr(lease, "extend", extend)
    with heartbeat.Heartbeat(database, [held], Settings(data_dir=tmp_path), threading.Event()):
        time.sleep(1.2)
    assert 1 <= beats <= 3


def test_a_lease_is_no_longer_because_the_clock_was_set_back(database: Database, submit: Submit) -> None:
    submit(300)
    held = claim(database)
    with database.write() as session:
        session.execute(update(Case).values(lease_expires=Case.lease_expires + 600, heartbeat_at=Clock() + 600))
    with database.write() as session:
        assert not sweep(session, max_attempts=3)
        assert lease.extend(session, [held], 15.0, {held.case_id: 0.5})  # whoever lives keeps it
    with database.write() as session:
        session.execute(update(Case).values(lease_expires=Clock() + 600.05, heartbeat_at=Clock() + 600))
    while not swept(database):  # nobody does, and the lease is as long as it was given for
        time.sleep(0.01)


def test_poison_is_quarantined(database: Database, submit: Submit) -> None:
    study = submit(300)
    for _ in range(3):
        held = claim(database)
        expire(database)
        with database.write() as session:
            sweep(session, max_attempts=3)
    case = get(database, held.case_id)
    assert (case.state, case.attempt) == ("failed", 3)
    assert case.error is not None
    assert case.error["code"] == "poison"
    with database.read() as session:
        assert service.get(session, study.id).state == "failed"


def test_a_released_case_is_not_to_blame(database: Database, submit: Submit) -> None:
    submit(300)
    for _ in range(5):
        held = claim(database)
        assert held.attempt == 1
        with database.write() as session:
            assert lease.release(session, held)
    assert get(database, held.case_id).state == "queued"


def test_a_cancelled_case_has_no_lease(database: Database, submit: Submit) -> None:
    submit(300)
    held = claim(database)
    with database.write() as session:
        session.execute(update(Case).values(state="cancelled"))
    with database.write() as session:
        assert not lease.extend(session, [held], 15.0, {held.case_id: 0.5})
    submit(300, 310)  # and is queued again when somebody wants it
    assert get(database, held.case_id).state == "queued"


def test_a_history_that_is_wanted_late_is_computed_once_more(database: Database, submit: Submit) -> None:
    submit(300)
    held = claim(database)
    submit(300, keep_history=True)
    with database.write() as session:
        assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=0.0)
    assert get(database, held.case_id).state == "queued"
    again = claim(database)
    history = {"key": "k", "digest": "d" * 64, "size_bytes": 1}
    with database.write() as session:
        assert succeed(session, again, peaks=[], processing={}, history=history, cpu_s=0.0)
    assert get(database, held.case_id).state == "succeeded"


def test_old_idempotency_keys_are_forgotten(database: Database) -> None:
    with database.write() as session:
        for key, age in (("old", KEPT_S + 1), ("new", KEPT_S - 60)):
            session.add(IdempotencyKey(key=key, request_digest="", response={}, created_at=Clock() - age))
    with database.write() as session:
        sweep(session, max_attempts=3)
        assert session.scalars(select(IdempotencyKey.key)).all() == ["new"]


@pytest.mark.parametrize("threads", [16])
def test_no_increment_is_lost(database: Database, submit: Submit, context: Context, threads: int) -> None:
    """Read, modify, write: what the driver's own transactions lose on SQLite."""
    submit(300)

    def increment(_: int) -> None:
        with database.write() as session:
            case = session.scalars(select(Case).with_for_update()).one()
            case.attempt += 1

    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(increment, range(200)))
    with database.read() as session:
        assert session.scalar(select(Case.attempt)) == 200
