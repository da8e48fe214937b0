"""RabbitMQ in place of Redis: a real server, from the system's packages."""

import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from amqp import Connection
from amqp.exceptions import PreconditionFailed

from app.context import Context
from app.db.session import Database
from app.queue import QUEUE, Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies.schemas import StudyDetail
from tests.conftest import free_port
from tests.worker.conftest import SECONDS_LONG
from tests.worker.test_processes import state, there, until

pytestmark = [pytest.mark.slow, pytest.mark.parametrize("database_url", ["sqlite"], indirect=True)]

PROGRAM = Path("/usr/lib/rabbitmq/bin/rabbitmq-server")  # not Debian's wrapper, which changes the user


class RabbitMQ:
    """A server of one node, its data in a folder."""

    def __init__(self, folder: Path) -> None:
        self.port = free_port()
        self.environment = os.environ | {
            "HOME": str(folder),
            "ERL_EPMD_PORT": str(free_port()),
            "ERL_EPMD_ADDRESS": "127.0.0.1",
            "RABBITMQ_NODENAME": f"test{self.port}@localhost",
            "RABBITMQ_NODE_IP_ADDRESS": "127.0.0.1",
            "RABBITMQ_NODE_PORT": str(self.port),
            "RABBITMQ_DIST_PORT": str(free_port()),
            "RABBITMQ_BASE": str(folder),
            "RABBITMQ_MNESIA_BASE": str(folder / "mnesia"),
            "RABBITMQ_LOG_BASE": str(folder / "log"),
            "RABBITMQ_ENABLED_PLUGINS_FILE": str(folder / "plugins"),
            "RABBITMQ_CONFIG_FILE": str(folder / "rabbitmq"),
            "RABBITMQ_PID_FILE": str(folder / "pid"),
        }
        self.start()

    @property
    def url(self) -> str:
        return f"amqp://guest:guest@127.0.0.1:{self.port}//"

    def start(self) -> None:
        self.process = subprocess.Popen(
            [PROGRAM],
            env=self.environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
        )
        until(self.answers, 60)

    def answers(self) -> bool:
        assert self.process.poll() is None
        try:
            with self.connect():
                return True
        except OSError:
            return False

    def connect(self) -> Connection:
        connection = Connection(f"127.0.0.1:{self.port}", connect_timeout=5, read_timeout=10)
        connection.connect()
        return connection

    def waiting(self) -> int:
        """How many bells nobody has been told of."""
        with self.connect() as connection:
            return int(connection.channel().queue_declare(QUEUE, passive=True).message_count)

    def restart(self) -> None:
        """In good order: version 3.10 forgets a quorum queue's replicas if it crashes soon after making it."""
        os.killpg(self.process.pid, signal.SIGTERM)
        self.process.wait()
        self.start()

    def crash(self) -> None:
        os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()

    def stop(self) -> None:
        self.crash()
        subprocess.run(["epmd", "-kill"], env=self.environment, stdout=subprocess.DEVNULL, check=False)


@pytest.fixture
def rabbitmq() -> Iterator[RabbitMQ]:
    if not PROGRAM.exists():
        pytest.fail(f"There is no RabbitMQ ({PROGRAM}): apt-get install rabbitmq-server")
    with tempfile.TemporaryDirectory(prefix="rmq") as folder:
        server = RabbitMQ(Path(folder))
        yield server
        server.stop()


@pytest.fixture
def context(tmp_path: Path, database_url: str, database: Database, rabbitmq: RabbitMQ) -> Context:
    settings = Settings(data_dir=tmp_path, database_url=database_url, broker_url=rabbitmq.url, lease_s=2.0)
    return Context(settings, database, Doorbell(settings), HistoryStore(settings.resolved_storage_url))


def test_workers_hear_bells_and_survive_a_broker_that_crashes(
    context: Context, submit: Callable[..., StudyDetail], processes: Any, rabbitmq: RabbitMQ
) -> None:
    # The first bell is rung before there is a queue to look into.
    before = submit(200)
    rabbitmq.restart()
    processes.start()
    processes.start()
    until(lambda: state(context, before) == "succeeded")
    classic = {"x-queue-type": "classic"}
    with rabbitmq.connect() as connection, pytest.raises(PreconditionFailed, match="x-queue-type"):
        connection.channel().queue_declare(QUEUE, durable=True, auto_delete=False, arguments=classic)
    until(lambda: there(context) == 2)

    # While a worker computes, the broker crashes, and comes back with what it had confirmed.
    busy = submit(300, numerics=SECONDS_LONG)
    until(lambda: state(context, busy) == "running")
    rabbitmq.crash()
    began = time.monotonic()
    assert not context.doorbell.ring()
    assert time.monotonic() - began < 30
    away = submit(210)
    rabbitmq.start()
    until(lambda: state(context, away) == state(context, busy) == "succeeded")

    # Both listen again.
    assert all(process.poll() is None for process in processes.running)
    after = [submit(speed, numerics=SECONDS_LONG) for speed in (220, 230)]
    until(lambda: [state(context, study) for study in after] == ["running"] * 2)
    until(lambda: {state(context, study) for study in after} == {"succeeded"})


def test_bells_do_not_pile_up(context: Context, rabbitmq: RabbitMQ) -> None:
    assert context.doorbell.ring()
    with rabbitmq.connect() as connection:
        assert connection.channel().queue_declare(QUEUE, passive=True).message_count <= 1
    for _ in range(20):
        assert context.doorbell.ring()
    assert rabbitmq.waiting() == 1
    rabbitmq.restart()
    assert rabbitmq.waiting() == 1
    rabbitmq.crash()
    rabbitmq.start()
    assert until(rabbitmq.waiting) == 1  # a bell that was confirmed is kept
