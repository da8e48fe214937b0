"""The service under test: all of its parts as processes, and the doors by which faults come in."""

import os
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import psutil
from sqlalchemy import make_url

import migrations
from tests.chaos import changes
from tests.chaos.apart import Apart, apart
from tests.chaos.changes import Follower
from tests.chaos.record import Record
from tests.conftest import Postgres
from tests.e2e.conftest import Served, gone, served, until
from tests.hosts import Host, network

INSIDE = Path(__file__).parent / "inside"
ROOT = Path(__file__).parents[2]
DISK_MB = 1024
LEASE_S = 2.0
SWEEP_S = LEASE_S / 3  # the pause between two sweeps of one worker
MAX_ATTEMPTS = 6


def faketime() -> Path | None:
    """The library that gives a process another clock, where it runs."""
    try:
        import libfaketime  # noqa: PLC0415
    except ImportError:  # there is none for this system
        return None
    library = Path(libfaketime.__file__).parent / "vendor/libfaketime/src/libfaketime.so.1"
    probe = ["date", "-d", "now", "+%s"]
    with suppress(OSError, subprocess.CalledProcessError):
        real, fake = (
            int(subprocess.run(probe, env=os.environ | more, capture_output=True, check=True).stdout)
            for more in ({}, {"LD_PRELOAD": str(library), "FAKETIME": "+3600s"})
        )
        return library if fake - real > 3000 else None
    return None


class System:
    """A ``tracksweep serve`` on a folder of its own, on SQLite or on PostgreSQL, or a service on several hosts.

    Attributes
    ----------
    hosts : sequence of Host
        If there are several.
    control : Path
        The folder through which the processes are told what to do, see ``inside/sitecustomize.py``.
    disk : Path or None
        Where the data lie, if that is a disk of their own, which can be filled.
    """

    def __init__(
        self,
        folder: Path,
        postgres: Postgres | None,
        record: Record,
        environment: dict[str, str],
        hosts: Sequence[Host] = (),
    ) -> None:
        self.folder, self.postgres, self.record, self.hosts = folder, postgres, record, hosts
        self.data, self.control = folder / "data", folder / "control"
        self.data.mkdir()
        self.control.mkdir()
        self.disk = self.data if _mounted(self.data) else None
        self.url = postgres.create_database() if postgres else f"sqlite:///{self.data}/tracksweep.db"
        migrations.upgrade(self.url)
        changes.install(self.url)
        self.library = faketime()
        self.environment = {
            "TRACKSWEEP_DATABASE_URL": self.url,
            "TRACKSWEEP_LEASE_S": str(LEASE_S),
            "TRACKSWEEP_MAX_ATTEMPTS": str(MAX_ATTEMPTS),
            "TRACKSWEEP_READS_PER_MINUTE": "0",
            "TRACKSWEEP_WRITES_PER_MINUTE": "0",
            "PYTHONPATH": str(INSIDE),
            "CHAOS_CONTROL": str(self.control),
            "CHAOS_CLOCK": "clock.{pid}" if postgres else "clock",
            **({"CHAOS_FAKETIME": str(self.library)} if self.library else {}),
            **environment,
        }
        self.broker_url = f"unix://{self.data}/broker.sock"
        if hosts:
            address = hosts[0].address
            self.broker_url = f"redis://{address}/0"
            self.environment |= {
                "TRACKSWEEP_DATA_DIR": str(self.data),
                "TRACKSWEEP_DATABASE_URL": f"postgresql+psycopg://tracksweep@{address}/{make_url(self.url).database}",
                "TRACKSWEEP_BROKER_URL": self.broker_url,
                "TRACKSWEEP_REQUIRE_KEYS": "never",
                "TRACKSWEEP_WORKER_NICE": "0",
            }
        self.follower = Follower(self.url, record)
        self.service: Served | Apart

    @contextmanager
    def running(self, workers: int) -> Iterator[None]:
        with (
            apart(self.folder, self.hosts, self.environment)
            if self.hosts
            else served(self.data, "--workers", str(workers), **self.environment)
        ) as self.service:
            until(lambda: len(self.workers()) == workers, 180)
            yield

    def workers(self) -> list[psutil.Process]:
        """Workers that have begun their work."""
        return [each for each in self.service.parts("worker") if worker_name(each.pid) in self.follower.present]

    def part(self, word: str) -> psutil.Process | None:
        return next(iter(self.service.parts(word)), None)

    def close(self) -> None:
        self.follower.close()
        self.follower.database.close()
        if self.disk:
            subprocess.run(["umount", "--lazy", str(self.disk)], check=False)


def worker_name(pid: int) -> str:
    return f"{os.uname().nodename}:{pid}"


def _mounted(folder: Path) -> bool:
    """Put a small disk in place of a folder, if that is permitted. The harness has its own view of what is mounted."""
    if os.environ.get("CHAOS_MOUNTS") != "own":
        return False
    command = ["mount", "-t", "tmpfs", "-o", f"size={DISK_MB}m", "tmpfs", str(folder)]
    return subprocess.run(command, check=False, capture_output=True).returncode == 0


@contextmanager
def system(kind: str, record: Record, hosts: int, **environment: str) -> Iterator[System]:
    """A system on ``sqlite``, ``postgresql`` or ``hosts``, with the folder, the network and the server it needs."""
    with ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="ch", ignore_cleanup_errors=True))
        found = stack.enter_context(network(hosts)) if kind == "hosts" else []
        path = Path(folder)  # short, for sockets
        postgres = None
        if kind != "sqlite":
            postgres = Postgres(path / "pg", "", found[0]) if found else Postgres(path / "pg")
            stack.callback(postgres.stop)
        made = System(path, postgres, record, environment, found)
        stack.callback(made.close)
        yield made


__all__ = ["System", "gone", "system", "until"]
