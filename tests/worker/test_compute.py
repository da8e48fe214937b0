"""What a worker makes of the cases it claims: in this process, with the real solver, on both databases."""

import io
import json
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest
from sqlalchemy import select, update

from app.cases import service as cases
from app.context import Context
from app.db.models import Case, History, Peak
from app.histories import service as histories
from app.studies import service as studies
from app.studies.schemas import StudyDetail
from solver import case as solver_case
from solver.peaks import peaks
from solver.processing import processing
from solver.simulate import Response, solve
from worker import compute
from worker.compute import Worker

Submit = Callable[..., StudyDetail]


@pytest.fixture
def stopping() -> threading.Event:
    return threading.Event()


@pytest.fixture
def worker(context: Context, stopping: threading.Event) -> Iterator[Worker]:
    worker = Worker(context.settings, stopping)
    yield worker
    worker.database.close()


def only_case(context: Context) -> Case:
    with context.database.read() as session:
        return session.scalars(select(Case)).one()


def test_a_study_is_computed(context: Context, submit: Submit, worker: Worker) -> None:
    study = submit(250, 300)
    assert worker.work() == 2
    with context.database.read() as session:
        assert studies.get(session, study.id).state == "succeeded"
        rows = session.scalars(select(Case).order_by(Case.id)).all()
        for row in rows:
            (response,) = solve([solver_case.Case.from_dict(row.inputs)])
            assert isinstance(response, Response)
            stored = session.scalars(select(Peak).where(Peak.case_id == row.id).order_by(Peak.id)).all()
            for one, other in zip(stored, peaks(response), strict=True):
                assert (one.quantity, one.position, one.unit) == (other.quantity, other.position, other.unit)
                assert (one.peak, one.rms, one.time_s) == (other.peak, other.rms, other.time)  # to the last digit
            assert cases.get(session, row.id).processing == processing(response)
        assert all(row.cpu_s is not None and row.cpu_s > 0 for row in rows)
        assert session.scalars(select(History)).all() == []
    assert list(context.histories.keys_older_than(-60)) == []


def test_a_history_is_kept_if_asked_for(context: Context, submit: Submit, worker: Worker) -> None:
    submit(300, keep_history=True)
    worker.work()
    row = only_case(context)
    with context.database.read() as session:
        history = histories.find(session, row.id).history
    content = b"".join(context.histories.read(history.key))
    assert len(content) == history.size_bytes
    (response,) = solve([solver_case.Case.from_dict(row.inputs)])
    assert isinstance(response, Response)
    with np.load(io.BytesIO(content)) as archive:
        assert archive["values"].dtype == np.float32
        np.testing.assert_array_equal(archive["values"], response.values.astype(np.float32))
        assert list(archive["quantity"]) == [channel.quantity for channel in response.channels]
        assert json.loads(str(archive["processing"])) == processing(response)


def test_a_case_that_cannot_be_solved_fails_at_once(context: Context, submit: Submit, worker: Worker) -> None:
    """Next to no pads under a car of a thousand tonnes: the wheels fall without end."""
    submit(300, track={"pad_stiffness_n_per_m": 1e-6}, vehicle={"car_body_mass_kg": 1e6})
    assert worker.work() == 1
    case = only_case(context)
    assert (case.state, case.attempt, case.processing) == ("failed", 1, None)
    assert case.error is not None
    assert case.error["code"] == "diverged"


def test_an_attempt_that_breaks_is_repeated_until_it_is_poison(
    context: Context, submit: Submit, worker: Worker
) -> None:
    submit(300)
    with context.database.write() as session:
        session.execute(update(Case).values(inputs={"speed": 1.0}))
    assert worker.work() == context.settings.max_attempts
    case = only_case(context)
    assert (case.state, case.attempt) == ("failed", 3)
    assert case.error is not None
    assert case.error["code"] == "poison"
    assert "KeyError" in case.error["detail"]


SLOW = {"settle_s": 20.0, "window_s": 60.0}  # more than half a minute


def test_progress_is_seen_and_a_stopped_worker_puts_its_case_back(
    context: Context, submit: Submit, worker: Worker, stopping: threading.Event
) -> None:
    study = submit(300, numerics=SLOW)
    thread = threading.Thread(target=worker.work)
    thread.start()
    while True:
        with context.database.read() as session:
            seen = studies.get(session, study.id)
        if seen.progress > 0:
            break
        time.sleep(0.05)
    assert seen.state == "running"
    assert seen.progress < 1
    stopping.set()
    thread.join()
    case = only_case(context)
    assert (case.state, case.attempt, case.lease_token, case.progress) == ("queued", 0, None, 0)


def test_a_case_taken_away_is_not_computed_to_its_end(context: Context, submit: Submit, worker: Worker) -> None:
    submit(300, numerics=SLOW)
    thread = threading.Thread(target=worker.work)
    thread.start()
    while only_case(context).state != "running":
        time.sleep(0.05)
    with context.database.write() as session:
        session.execute(update(Case).values(state="cancelled", lease_token=None))
    thread.join(timeout=20)
    assert not thread.is_alive()
    assert only_case(context).state == "cancelled"


def test_a_case_that_takes_too_long_is_given_up(context: Context, submit: Submit) -> None:
    submit(300, numerics=SLOW)
    limits = {"case_time_limit_s": 0.2, "max_attempts": 2, "lease_s": 600.0}  # the watchdog would end this process
    worker = Worker(context.settings.model_copy(update=limits), threading.Event())
    assert worker.work() == 2
    case = only_case(context)
    assert (case.state, case.attempt) == ("failed", 2)
    assert case.error is not None
    assert case.error["code"] == "time-limit"
    worker.database.close()


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_an_outcome_is_written_again_after_a_pause_that_cost_its_transaction(
    context: Context, submit: Submit, stopping: threading.Event, monkeypatch: pytest.MonkeyPatch
) -> None:
    study = submit(300)
    write_down, pauses = compute.write_down, iter([1.0])

    def paused(*arguments: Any) -> set[int]:
        written = write_down(*arguments)
        time.sleep(next(pauses, 0.0))  # before the commit
        return written

    monkeypatch.setattr(compute, "write_down", paused)
    worker = Worker(context.settings.model_copy(update={"lease_s": 0.5}), stopping)
    assert worker.work() == 1
    worker.database.close()
    with context.database.read() as session:
        assert studies.get(session, study.id).state == "succeeded"
    assert only_case(context).attempt == 1
    assert next(pauses, None) is None
