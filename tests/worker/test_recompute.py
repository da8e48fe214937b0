"""Stored cases computed once more, on both databases."""

import threading
from collections.abc import Callable, Iterator

import pytest
from sqlalchemy import select, update

from app.context import Context
from app.db.models import Case, Peak, Verification
from app.db.session import Database
from app.problems import Problem
from app.studies import lifecycle
from app.studies.schemas import StudyDetail
from app.verifications import service
from app.verifications.schemas import VerificationDetail
from worker import verification
from worker.compute import Worker
from worker.sweeper import sweep
from worker.verification import differences

Submit = Callable[..., StudyDetail]


@pytest.fixture
def worker(context: Context) -> Iterator[Worker]:
    worker = Worker(context.settings, threading.Event())
    yield worker
    worker.database.close()


def latest(database: Database, case_id: int) -> VerificationDetail:
    with database.read() as session:
        return service.get(session, case_id)


def stored(database: Database) -> list[tuple[int, float, float]]:
    with database.read() as session:
        return [(row.id, row.peak, row.rms) for row in session.scalars(select(Peak).order_by(Peak.id))]


def test_a_stored_case_is_verified(context: Context, database: Database, submit: Submit, worker: Worker) -> None:
    submit(300)
    assert worker.work() == 1
    with database.read() as session:
        (case_id,) = session.scalars(select(Case.id))
    asked = service.request(context, case_id)
    assert service.request(context, case_id) == asked  # it is on its way
    assert asked.state == "queued"
    peaks = stored(database)
    assert worker.work() == 0
    done = latest(database, case_id)
    assert (done.state, done.outcome, done.error) == ("succeeded", "same", None)
    assert done.differences is not None
    assert set(done.differences.values()) == {0.0}
    with database.write() as session:  # somebody meddles with a result
        session.execute(update(Peak).where(Peak.quantity == "pad_force").values(rms=Peak.rms * 1.01))
    meddled = stored(database)
    service.request(context, case_id)
    worker.work()
    found = latest(database, case_id)
    assert found.outcome == "differs"
    assert found.differences is not None
    assert [quantity for quantity, difference in found.differences.items() if difference] == ["pad_force"]
    assert stored(database) == meddled != peaks


def test_only_results_can_be_verified(context: Context, database: Database, submit: Submit) -> None:
    submit(300)
    with database.read() as session:
        (case_id,) = session.scalars(select(Case.id))
    with pytest.raises(Problem, match="nothing to verify"):
        service.request(context, case_id)
    with pytest.raises(Problem, match="no such case"):
        service.request(context, case_id + 1)
    with database.read() as session, pytest.raises(Problem, match="no such verification"):
        service.get(session, case_id)


def test_a_silent_worker_loses_it_and_poison_ends(context: Context, database: Database, submit: Submit) -> None:
    submit(300)
    with database.write() as session:
        session.execute(update(Case).values(state="succeeded"))
        (case_id,) = session.scalars(select(Case.id))
    service.request(context, case_id)
    for attempt in (1, 2):
        with database.write() as session:
            assert sweep(session, 2)
            held = verification.claim(session, 15.0, 2)
            assert held is not None
            assert held.attempt == attempt
            assert verification.claim(session, 15.0, 2) is None
            assert not sweep(session, 2)
            session.execute(update(Verification).values(lease_expires=0.0))
    with database.write() as session:
        assert verification.claim(session, 15.0, 2) is None
        assert not verification.extend(session, [held], 15.0, {held.case_id: 0.5})
        assert not verification.compare(session, held, [])
    ended = latest(database, case_id)
    assert ended.state == "failed"
    assert ended.error is not None
    assert ended.error.code == "poison"


def test_differences_are_relative_to_the_largest_magnitude() -> None:
    def peak(quantity: str, **values: float) -> dict[str, str | float]:
        return {"quantity": quantity, "position": "middle"} | dict.fromkeys(verification.VALUES, 0.0) | values

    old = [peak("a", maximum=2.0, minimum=-4.0), peak("b"), peak("c", mean=1.0), peak("d")]
    new = [peak("a", maximum=2.5, minimum=-4.0), peak("b"), peak("d", std=1e-300), peak("e", mean=1.0)]
    assert differences(old, new) == {"a": 0.125, "b": 0.0, "c": 1.0, "d": 1.0}


def test_a_cancelled_computation_leaves_no_peaks(
    context: Context, database: Database, submit: Submit, worker: Worker
) -> None:
    """The case had succeeded, and was to be computed once more for its history."""
    first = submit(300)
    worker.work()
    lifecycle.remove(context, first.id)
    again = submit(300, keep_history=True)
    assert again.cases.queued == 1
    lifecycle.cancel(context, again.id)
    assert stored(database) == []
    submit(300)
    worker.work()
    assert stored(database) != []
