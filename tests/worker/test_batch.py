"""Cases computed side by side, on both databases, with the real solver: each has an end of its own."""

import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from sqlalchemy import event, func, select, update

from app.context import Context
from app.db.models import Case, Event, Peak
from app.studies import service
from app.studies.schemas import StudyDetail
from solver import case as solver_case
from solver.peaks import peaks
from solver.simulate import Response, solve
from tests.worker.conftest import SECONDS_LONG
from worker.claim import claim
from worker.compute import Worker

Submit = Callable[..., StudyDetail]
FOR_EVER = {"settle_s": 20.0, "window_s": 60.0}
THREE = [0.1, 0.2, 0.3]


@pytest.fixture
def stopping() -> threading.Event:
    return threading.Event()


@pytest.fixture
def worker(context: Context, stopping: threading.Event) -> Iterator[Worker]:
    worker = Worker(context.settings, stopping)
    yield worker
    worker.database.close()


@pytest.fixture
def in_background(worker: Worker, stopping: threading.Event) -> Iterator[threading.Thread]:
    """The worker at work, once the test starts it."""
    thread = threading.Thread(target=worker.work)
    yield thread
    stopping.set()
    thread.join()


def rows(context: Context) -> list[Case]:
    with context.database.read() as session:
        return list(session.scalars(select(Case).order_by(Case.id)))


def ends(context: Context) -> list[tuple[str, int]]:
    return [(row.state, row.attempt) for row in rows(context)]


def until(condition: Callable[[], bool]) -> None:
    deadline = time.monotonic() + 120
    while not condition():
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.02)


def change(context: Context, case_id: int, **values: Any) -> None:
    with context.database.write() as session:
        session.execute(update(Case).where(Case.id == case_id).values(**values))


def test_peaks_are_those_of_cases_computed_alone(context: Context, submit: Submit, worker: Worker) -> None:
    study = submit(300, amplitudes=THREE)
    assert worker.work() == 3
    computed = rows(context)
    started, finished = zip(*[(row.started_at or 0.0, row.finished_at or 0.0) for row in computed], strict=True)
    assert max(started) < min(finished)
    assert all(row.cpu_s is not None and row.cpu_s > 0 for row in computed)
    with context.database.read() as session:
        assert service.get(session, study.id).state == "succeeded"
        for row in computed:
            (response,) = solve([solver_case.Case.from_dict(row.inputs)])
            assert isinstance(response, Response)
            stored = session.scalars(select(Peak).where(Peak.case_id == row.id).order_by(Peak.id))
            for found, alone in zip(stored, peaks(response), strict=True):
                assert (found.quantity, found.position, found.time_s) == (alone.quantity, alone.position, alone.time)
                assert (found.peak, found.rms) == pytest.approx((alone.peak, alone.rms), rel=1e-9)


def test_a_diverging_lane_fails_alone(context: Context, submit: Submit, worker: Worker) -> None:
    soft = {"pad_stiffness_n_per_m": 1e6}
    submit(300, amplitudes=[0.1, 0.2], track=soft)
    submit(300, track=soft, vehicle={"car_body_mass_kg": 1e6})
    with context.database.write() as session:
        batch = claim(session, worker.name, 15.0)
    assert len(batch) == 3
    worker.compute(batch)
    assert ends(context) == [("succeeded", 1), ("succeeded", 1), ("failed", 1)]
    assert [row.error and row.error["code"] for row in rows(context)] == [None, None, "diverged"]


def test_an_unexpected_error_charges_only_its_case(context: Context, submit: Submit, worker: Worker) -> None:
    submit(300, amplitudes=THREE)
    change(context, rows(context)[1].id, inputs={"speed": 1.0})
    assert worker.work() == 3 + 2  # the broken one again, alone, until it is poison
    assert ends(context) == [("succeeded", 1), ("failed", 3), ("succeeded", 1)]
    assert rows(context)[1].error is not None
    assert "KeyError" in str(rows(context)[1].error)


def test_an_outcome_that_cannot_be_written_touches_no_other(context: Context, submit: Submit, worker: Worker) -> None:
    submit(300, amplitudes=THREE)
    broken = rows(context)[1].id

    @event.listens_for(worker.database.engine, "before_cursor_execute")
    def refuse(connection: Any, cursor: Any, statement: str, parameters: Any, *_: Any) -> None:
        values = parameters.values() if isinstance(parameters, dict) else parameters
        if statement.startswith("DELETE FROM peak") and broken in values:
            raise RuntimeError("the driver broke")

    with context.database.write() as session:
        batch = claim(session, worker.name, 15.0)
    worker.compute(batch)
    assert ends(context) == [("succeeded", 1), ("running", 1), ("succeeded", 1)]


@pytest.mark.parametrize(
    "taken", [{"state": "cancelled", "lease_token": None}, {"lease_token": "of another"}], ids=["cancelled", "lost"]
)
def test_a_case_taken_away_leaves_its_neighbours(
    context: Context, submit: Submit, in_background: threading.Thread, taken: dict[str, Any]
) -> None:
    submit(300, amplitudes=THREE, numerics=SECONDS_LONG)
    in_background.start()
    until(lambda: all(row.progress > 0 for row in rows(context)))
    one = rows(context)[0]
    change(context, one.id, **taken)
    until(lambda: [row.state for row in rows(context)[1:]] == ["succeeded"] * 2)
    left = rows(context)[0]
    assert (left.state, left.lease_token) == (taken.get("state", "running"), taken["lease_token"])
    with context.database.read() as session:
        assert session.scalar(select(func.count(Peak.case_id.distinct()))) == 2
        assert session.scalar(select(func.count()).where(Event.kind == "case")) == 2


def test_a_batch_taken_away_as_a_whole_is_not_computed_to_its_end(
    context: Context, submit: Submit, in_background: threading.Thread
) -> None:
    submit(300, amplitudes=THREE, numerics=FOR_EVER)
    in_background.start()
    until(lambda: all(row.state == "running" for row in rows(context)))
    with context.database.write() as session:
        session.execute(update(Case).values(state="cancelled", lease_token=None))
    in_background.join(timeout=60)
    assert not in_background.is_alive()
    assert {row.state for row in rows(context)} == {"cancelled"}


def test_a_stopped_worker_puts_back_what_it_still_holds(
    context: Context, submit: Submit, in_background: threading.Thread, stopping: threading.Event
) -> None:
    submit(300, amplitudes=THREE, numerics=FOR_EVER)
    in_background.start()
    until(lambda: all(row.progress > 0 for row in rows(context)))
    change(context, rows(context)[2].id, state="cancelled", lease_token=None)
    stopping.set()
    in_background.join(timeout=60)
    assert not in_background.is_alive()
    assert ends(context) == [("queued", 0), ("queued", 0), ("cancelled", 1)]


def test_where_one_attempt_is_all_a_case_has_nobody_rides(context: Context, submit: Submit) -> None:
    submit(300, amplitudes=THREE, numerics=FOR_EVER)
    stopping = threading.Event()
    worker = Worker(context.settings.model_copy(update={"max_attempts": 1}), stopping)
    thread = threading.Thread(target=worker.work)
    thread.start()
    until(lambda: any(row.state == "running" for row in rows(context)))
    assert sorted(row.state for row in rows(context)) == ["queued", "queued", "running"]
    stopping.set()
    thread.join()
    worker.database.close()
