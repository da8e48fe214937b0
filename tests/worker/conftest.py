"""Cases in the queue, and workers in processes of their own."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from app.context import Context
from app.db.session import Database
from app.queue import Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies import service
from app.studies.schemas import StudyDetail, StudyRequest
from solver.warm import warm

# The smallest case there is; it takes about a tenth of a second.
QUICK = {
    "track_length_m": 90.0,
    "absorbing_length_m": 10.0,
    "elements_per_pad": 2,
    "time_step_s": 5e-4,
    "settle_s": 0.3,
    "window_s": 0.05,
}
# For tests that meet a case half done: more than three seconds even on a fast machine.
SECONDS_LONG = QUICK | {"time_step_s": 1e-4, "window_s": 30.0}
SLOW = QUICK | {"window_s": 60.0, "settle_s": 20.0, "time_step_s": 1e-4}

Submit = Callable[..., StudyDetail]


@pytest.fixture
def context(tmp_path: Path, database_url: str, database: Database) -> Context:
    """What the service holds. No broker listens unless a test starts one."""
    broker_url = f"redis+socket://{tmp_path}/nobody"
    settings = Settings(data_dir=tmp_path, database_url=database_url, broker_url=broker_url, lease_s=2.0)
    return Context(settings, database, Doorbell(settings), HistoryStore(settings.resolved_storage_url))


@pytest.fixture
def submit(context: Context) -> Submit:
    """Creates a study of given speeds, and of amplitudes in mm: these share an operator."""

    def create(
        *speeds: float, amplitudes: Sequence[float] = (0.1,), numerics: dict[str, Any] = QUICK, **more: Any
    ) -> StudyDetail:
        irregularity = {"kind": "harmonic", "wavelength_m": [2.0], "amplitude_mm": list(amplitudes)}
        sweep = {"kind": "product", "speed_kmh": list(speeds), "irregularity": irregularity}
        request = {"name": "A study", "sweep": sweep, "numerics": numerics, **more}
        return service.create(context, StudyRequest.model_validate(request), None)

    return create


class Processes:
    """Workers of one data folder, as ``tracksweep worker`` runs them."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.running: list[subprocess.Popen[bytes]] = []

    def start(self) -> subprocess.Popen[bytes]:
        names = ("data_dir", "database_url", "broker_url", "lease_s", "max_attempts")
        own = {f"TRACKSWEEP_{name.upper()}": str(getattr(self.settings, name)) for name in names}
        command = [sys.executable, "-m", "celery", "-A", "worker.celery", "worker", "--loglevel", "INFO"]
        command += ["--without-gossip", "--without-mingle", "--without-heartbeat", "-n", f"{len(self.running)}@test"]
        with (self.settings.data_dir / f"worker-{len(self.running)}.log").open("wb") as log:
            self.running.append(subprocess.Popen(command, env=os.environ | own, stdout=log, stderr=log))
        return self.running[-1]


@pytest.fixture
def processes(context: Context) -> Iterator[Processes]:
    warm()  # here, once, rather than in every worker at the same time
    processes = Processes(context.settings)
    yield processes
    for process in processes.running:
        process.kill()
        process.wait()
