"""Workers as processes, with a real broker: bells, crashes, and a broker that goes away."""

import signal
import time
from collections.abc import Callable
from typing import Any, TypeVar

import pytest
from sqlalchemy import func, select

from app.context import Context
from app.db.models import Case, Event, Peak
from app.db.session import Database
from app.queue import Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies import service
from app.studies.schemas import StudyDetail
from worker import presence

SECONDS_LONG = {
    "track_length_m": 90.0,
    "absorbing_length_m": 10.0,
    "elements_per_pad": 2,
    "time_step_s": 1e-4,
    "settle_s": 0.3,
    "window_s": 6.0,
}

T = TypeVar("T")


def until(condition: Callable[[], T], timeout_s: float = 120.0) -> T:
    deadline = time.monotonic() + timeout_s
    while not (value := condition()):
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
    return value


@pytest.fixture
def database_url(sqlite_settings: Settings) -> str:
    return sqlite_settings.database_url


@pytest.fixture
def context(sqlite_settings: Settings, database: Database) -> Context:
    store = HistoryStore(sqlite_settings.resolved_storage_url)
    return Context(sqlite_settings, database, Doorbell(sqlite_settings), store)


def test_the_life_of_workers(context: Context, submit: Callable[..., StudyDetail], processes: Any) -> None:
    def state(study: StudyDetail) -> str:
        with context.database.read() as session:
            return service.get(session, study.id).state

    def running(attempt: int = 1) -> Case | None:
        with context.database.read() as session:
            running = select(Case).where(Case.state == "running", Case.attempt == attempt, Case.progress > 0)
            return session.scalars(running).first()

    def there() -> int:
        with context.database.read() as session:
            return presence.count_with(session, "nobody") - 1

    # Two workers say that they are there. A bell wakes the first, which wakes the second.
    workers = {process.pid: process for process in (processes.start(), processes.start())}
    until(lambda: there() == 2)
    study = submit(200, 210, 220, 230)
    until(lambda: state(study) == "succeeded")

    # A worker is killed: when its lease has run out another one takes the case.
    slow = submit(300, numerics=SECONDS_LONG)
    case = until(running)
    assert case is not None
    assert case.worker is not None
    workers.pop(int(case.worker.rpartition(":")[2])).kill()
    until(lambda: running(attempt=2))

    # The other is told to stop: it puts the case back at once, uncounted, and ends cleanly.
    (last,) = workers.values()
    last.send_signal(signal.SIGTERM)
    assert last.wait(timeout=30) == 0
    with context.database.read() as session:
        put_back = session.get_one(Case, case.id)
        assert (put_back.state, put_back.attempt) == ("queued", 1)

    # A new one finds it without anybody ringing.
    processes.start()
    until(lambda: state(slow) == "succeeded")
    with context.database.read() as session:
        per_case = select(func.count(Peak.id)).group_by(Peak.case_id)
        assert len(set(session.scalars(per_case))) == 1
        assert session.scalar(select(func.count()).where(Event.kind == "done")) == 2
