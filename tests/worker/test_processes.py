"""Workers as processes, with a real broker: bells, crashes, and a broker that goes away."""

import signal
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import pytest
from celery import Celery
from kombu import disable_insecure_serializers, enable_insecure_serializers
from sqlalchemy import delete, func, select

from app.context import Context
from app.db.models import Case, Event, Peak, StudyCase
from app.db.session import Database
from app.queue import QUEUE, WORK, Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies import service
from app.studies.schemas import StudyDetail
from tests.app.conftest import serving
from tests.worker.conftest import SECONDS_LONG
from worker import presence, verification

T = TypeVar("T")


def until(condition: Callable[[], T], timeout_s: float = 120.0) -> T:
    deadline = time.monotonic() + timeout_s
    while not (value := condition()):
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
    return value


@pytest.fixture
def context(tmp_path: Path, database_url: str, database: Database, broker_url: str) -> Context:
    """With a broker, unlike that of the other tests of workers."""
    settings = Settings(data_dir=tmp_path, database_url=database_url, broker_url=broker_url, lease_s=2.0)
    return Context(settings, database, Doorbell(settings), HistoryStore(settings.resolved_storage_url))


def peaks_of(context: Context, speed_kmh: float) -> list[dict[str, Any]]:
    """The stored peaks of the case with an amplitude of 0.1 mm."""
    chosen = select(Peak).join(Case).where(Case.speed_kmh == speed_kmh, Case.amplitude_mm == 0.1)
    with context.database.read() as session:
        return [vars(peak) for peak in session.scalars(chosen)]


def forget(context: Context, speed_kmh: float) -> None:
    """Let the cases of a speed be new ones."""
    of_speed = select(Case.id).where(Case.speed_kmh == speed_kmh)
    with context.database.write() as session:
        session.execute(delete(StudyCase).where(StudyCase.case_id.in_(of_speed)))
        session.execute(delete(Case).where(Case.speed_kmh == speed_kmh))


def test_the_life_of_workers(context: Context, submit: Callable[..., StudyDetail], processes: Any) -> None:
    def running(attempt: int = 1) -> Case | None:
        with context.database.read() as session:
            running = select(Case).where(Case.state == "running", Case.attempt == attempt, Case.progress > 0)
            return session.scalars(running).first()

    # Two workers say that they are there. A bell wakes the first, which wakes the second.
    workers = {process.pid: process for process in (processes.start(), processes.start())}
    until(lambda: there(context) == 2)
    study = submit(200, 210, 220, 230)
    until(lambda: state(context, study) == "succeeded")
    alone = peaks_of(context, 200)

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

    # A new one finds it without anybody ringing. What another computed alone it computes beside others: the same.
    forget(context, 200)
    processes.start()
    beside = submit(200, amplitudes=[0.1, 0.2, 0.3, 0.4, 0.5])
    until(lambda: state(context, slow) == state(context, beside) == "succeeded")
    assert max(verification.differences(alone, peaks_of(context, 200)).values()) <= 1e-9
    with context.database.read() as session:
        per_case = select(func.count(Peak.id)).group_by(Peak.case_id)
        assert len(set(session.scalars(per_case))) == 1
        assert session.scalar(select(func.count()).where(Event.kind == "done")) == 3


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_a_drained_worker_finishes_what_it_computes(
    context: Context, submit: Callable[..., StudyDetail], processes: Any
) -> None:
    def cases() -> list[Case]:
        with context.database.read() as session:
            return list(session.scalars(select(Case).order_by(Case.turn)))

    drained = processes.start()
    submit(300, numerics=SECONDS_LONG | {"window_s": 60.0})
    until(lambda: cases()[0].state == "running")
    submit(310)
    drained.send_signal(signal.SIGUSR2)
    with serving(context.settings) as client:
        (worker,) = until(lambda: [each for each in client.get("/v1/queue").json()["workers"] if each["draining"]])
    assert worker["running"] == 1
    assert drained.wait(timeout=120) == 0
    first, second = cases()
    assert (first.state, first.attempt, first.worker) == ("succeeded", 1, worker["name"])
    assert (second.state, second.attempt, second.worker) == ("queued", 0, None)


@pytest.mark.parametrize("database_url", ["sqlite"], indirect=True)
def test_messages_that_are_no_bells_are_refused(
    context: Context, submit: Callable[..., StudyDetail], processes: Any, tmp_path: Path
) -> None:
    """Who reaches the broker can ring and nothing else: neither pickles nor commands are taken."""
    marker = tmp_path / "marker"
    harmful = Celery(broker=context.settings.broker_url, set_as_current=False)
    harmful.conf.task_default_queue = QUEUE
    enable_insecure_serializers()
    try:
        harmful.send_task(WORK, args=[Touch(str(marker))], serializer="pickle")
        disable_insecure_serializers()
        harmful.send_task("os.system", args=[f"touch {marker}"])
        processes.start()
        until(lambda: there(context) == 1)
        harmful.control.broadcast("shutdown")
        study = submit(200)  # the bell behind them is heard
        until(lambda: state(context, study) == "succeeded")
    finally:
        harmful.close()
    (process,) = processes.running
    assert process.poll() is None
    assert not marker.exists()


class Touch:
    """An object whose unpickling makes a file."""

    def __init__(self, path: str) -> None:
        self.path = path

    def __reduce__(self) -> tuple[Any, ...]:
        return (Path.touch, (Path(self.path),))


def there(context: Context) -> int:
    with context.database.read() as session:
        return presence.count_with(session, "nobody") - 1


def state(context: Context, study: StudyDetail) -> str:
    with context.database.read() as session:
        return service.get(session, study.id).state
