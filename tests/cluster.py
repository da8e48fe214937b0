"""The service on several hosts: API, PostgreSQL and broker on one, workers on the others."""

import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import httpx
from sqlalchemy import make_url

import migrations
from app.serve.broker import server
from tests.conftest import Postgres
from tests.e2e.conftest import clean_environment
from tests.hosts import Host, network

PORT = 8000
WORKER = ("-m", "worker.cli", "worker")
DURABLE = "-c max_wal_size=4GB -c shared_buffers=1GB"  # and all else as PostgreSQL comes
START_S = 120.0


def broker(host: Host, folder: Path) -> list[str]:
    """The command of a broker that other hosts reach, and that forgets nothing."""
    options = ["--bind", host.address, "--protected-mode", "no", "--appendonly", "yes", "--save", ""]
    return [server(), *options, "--maxmemory-policy", "noeviction", "--dir", str(folder)]


def api(host: Host) -> list[str]:
    """The command of an API that other hosts reach."""
    return [sys.executable, "-m", "worker.cli", "api", "--host", host.address, "--port", str(PORT)]


def is_ready(http: httpx.Client) -> bool:
    """Whether the API is."""
    with suppress(httpx.HTTPError):
        return http.get("/readyz").is_success
    return False


class Cluster:
    """A service whose first host answers and whose others compute.

    Parameters
    ----------
    folder : Path
        Of what is stored; all hosts see it.
    hosts : sequence of Host
    postgresql : str
        Its options.
    environment : dict of str
        Settings besides.
    """

    def __init__(self, folder: Path, hosts: Sequence[Host], postgresql: str, environment: dict[str, str]) -> None:
        self.folder, self.center, self.others = folder, hosts[0], list(hosts[1:])
        self.postgres = Postgres(folder / "pg", postgresql, self.center)
        self.local_url = self.postgres.create_database()  # by its socket
        migrations.upgrade(self.local_url)
        database = make_url(self.local_url).database
        self.environment = clean_environment() | {
            "TRACKSWEEP_DATA_DIR": str(folder / "data"),
            "TRACKSWEEP_DATABASE_URL": f"postgresql+psycopg://tracksweep@{self.center.address}/{database}",
            "TRACKSWEEP_BROKER_URL": f"redis://{self.center.address}/0",
            "TRACKSWEEP_REQUIRE_KEYS": "never",
            "TRACKSWEEP_READS_PER_MINUTE": "0",
            "TRACKSWEEP_WORKER_NICE": "0",
            **environment,
        }
        (folder / "data").mkdir()
        self.running: list[subprocess.Popen[bytes]] = []
        self.http = httpx.Client(base_url=f"http://{self.center.address}:{PORT}", timeout=60, trust_env=False)

    def start(self) -> None:
        """Start the broker and the API, and wait for them."""
        self._start(self.center, "broker", broker(self.center, self.folder))
        self.api = self._start(self.center, "api", api(self.center))
        deadline = time.monotonic() + START_S
        while not is_ready(self.http):
            if time.monotonic() > deadline or self.api.poll() is not None:
                raise TimeoutError((self.folder / "api.log").read_text())
            time.sleep(0.1)

    def start_worker(self, host: Host, command: Sequence[str] = WORKER) -> subprocess.Popen[bytes]:
        """One more worker on a host."""
        return self._start(host, f"worker-{len(self.running)}", [sys.executable, *command])

    def workers(self) -> list[dict[str, Any]]:
        """Who is there."""
        found: list[dict[str, Any]] = self.http.get("/v1/queue").json()["workers"]
        return found

    def _start(self, host: Host, name: str, command: Sequence[str]) -> subprocess.Popen[bytes]:
        with (self.folder / f"{name}.log").open("wb") as log:
            process = subprocess.Popen(
                host.command(*command), env=self.environment, stdout=log, stderr=log, start_new_session=True
            )
        self.running.append(process)
        return process

    def close(self) -> None:
        self.http.close()
        for process in self.running:
            process.kill()
            process.wait()
        self.postgres.stop()


@contextmanager
def cluster(others: int, postgresql: str = DURABLE, **environment: str) -> Iterator[Cluster]:
    """A cluster of one host that answers and some that compute."""
    with tempfile.TemporaryDirectory(prefix="ts", ignore_cleanup_errors=True) as folder, network(others + 1) as hosts:
        made = Cluster(Path(folder), hosts, postgresql, environment)
        try:
            made.start()
            yield made
        finally:
            made.close()
