"""The service as its users run it: the program ``tracksweep`` in processes of its own."""

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, TypeVar

import httpx
import psutil
import pytest

from solver.warm import warm

T = TypeVar("T")
PROGRAM = [sys.executable, "-m", "worker.cli"]
SMALL = {"track_length_m": 90, "elements_per_pad": 4, "settle_s": 0.3, "window_s": 0.2}
SECONDS_LONG = 30.0  # s, a window for tests that meet a case half done: it takes more than five even on a fast machine


def until(condition: Callable[[], T], timeout_s: float = 60) -> T:
    """The first truthy value of a condition."""
    deadline = time.monotonic() + timeout_s
    while not (value := condition()):
        assert time.monotonic() < deadline, "it did not happen in time"
        time.sleep(0.05)
    return value


def gone(process: psutil.Process) -> bool:
    """Whether a process has ended, reaped or not."""
    return not process.is_running() or process.status() == psutil.STATUS_ZOMBIE


def study(*speeds: float, **numerics: float) -> dict[str, Any]:
    """A small study."""
    irregularity = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}
    sweep = {"kind": "product", "speed_kmh": list(speeds), "slab": ["continuous"], "irregularity": irregularity}
    return {"name": "small", "sweep": sweep, "numerics": SMALL | numerics}


class Served:
    """A ``tracksweep serve`` and a client of it."""

    def __init__(self, data: Path, *options: str, program: Sequence[str] = PROGRAM, **environment: str) -> None:
        self.data = data
        ours = {"TRACKSWEEP_LEASE_S": "2", "TRACKSWEEP_WORKER_NICE": "0"}  # other tests run beside
        self.environment = clean_environment() | ours | environment
        self.environment["TRACKSWEEP_DATA_DIR"] = str(data)
        command = [*program, "serve", "--port", "0", *options]
        self.process = subprocess.Popen(
            command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL
        )
        self.supervisor = psutil.Process(self.process.pid)
        try:
            url = self._url()
        except BaseException:
            self.process.kill()
            self.process.communicate()
            raise
        self.http = httpx.Client(base_url=url, timeout=30, trust_env=False)

    def _url(self) -> str:
        def note() -> dict[str, Any] | None:
            assert self.process.poll() is None, self.process.communicate()[1].decode()
            path = self.data / "serve.json"
            found = json.loads(path.read_text()) if path.exists() else {}
            return found if found.get("pid") == self.process.pid else None

        return str(until(note, 240)["url"])

    def parts(self, word: str) -> list[psutil.Process]:
        """The parts whose command has a word, such as ``worker`` or ``api``."""
        return named(self.supervisor.children(), word)

    def get(self, path: str, **query: Any) -> Any:
        return self.http.get(path, params=query).raise_for_status().json()

    def submit(self, body: dict[str, Any]) -> str:
        return str(self.http.post("/v1/studies", json=body).raise_for_status().json()["id"])

    def cases(self, study_id: str) -> list[dict[str, Any]]:
        return list(self.get(f"/v1/studies/{study_id}/cases")["items"])

    def ended(self, study_id: str) -> dict[str, Any]:
        """A study once it has ended."""
        ended = {"succeeded", "partially_failed", "failed", "cancelled"}
        return until(lambda: s if (s := self.get(f"/v1/studies/{study_id}"))["state"] in ended else None, 240)

    def stop(self) -> int:
        """The exit code after a Ctrl-C."""
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=30)
        return self.process.returncode


def named(parts: Iterable[psutil.Process], word: str) -> list[psutil.Process]:
    """Those whose command has a word, and that have not ended."""
    found = []
    for part in parts:
        with suppress(psutil.NoSuchProcess):  # it ended just now
            if not gone(part) and (word in part.cmdline()[1:] or word in part.name()):
                found.append(part)
    return found


def clean_environment() -> dict[str, str]:
    """The environment without settings of whoever runs the tests."""
    return {name: value for name, value in os.environ.items() if not name.startswith("TRACKSWEEP_")}


@contextmanager
def served(data: Path, *options: str, program: Sequence[str] = PROGRAM, **environment: str) -> Iterator[Served]:
    """A service that is killed at the end, if it still runs."""
    warm()  # here, once, rather than beside the tests' clocks
    service = Served(data, *options, program=program, **environment)
    try:
        yield service
    finally:
        service.http.close()
        service.process.kill()
        service.process.communicate()


@pytest.fixture(scope="session")
def service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """A service for all tests that leave it as they found it. One worker, to know which one works."""
    with served(tmp_path_factory.mktemp("service") / "data", "--workers", "1") as service:
        yield service


def tracksweep(*arguments: object, **environment: object) -> subprocess.CompletedProcess[str]:
    """Run the program to its end."""
    variables = clean_environment() | {name: str(value) for name, value in environment.items()}
    command = [*PROGRAM, *map(str, arguments)]
    return subprocess.run(command, env=variables, capture_output=True, text=True, check=False, timeout=120)
