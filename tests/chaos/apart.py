"""The service on hosts with a network of their own: API, broker and PostgreSQL on the first, workers on the others."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import psutil

from solver.warm import warm
from tests.cluster import PORT, WORKER, api, broker, is_ready
from tests.e2e.conftest import clean_environment, named, until
from tests.hosts import Host

AGAIN = 'while :; do "$@"; sleep 0.2; done'  # what ends is started again, as systemd would


class Apart:
    """Stands for ``Served``.

    Parameters
    ----------
    folder : Path
        All hosts see it.
    hosts : sequence of Host
    environment : dict of str
    """

    def __init__(self, folder: Path, hosts: Sequence[Host], environment: dict[str, str]) -> None:
        self.folder, (center, *others) = folder, hosts
        self.environment = clean_environment() | environment
        self.keepers: list[tuple[Host, subprocess.Popen[bytes]]] = []
        self._keep(center, *broker(center, folder))
        self._keep(center, *api(center))
        self.http = httpx.Client(base_url=f"http://{center.address}:{PORT}", timeout=30, trust_env=False)
        until(lambda: is_ready(self.http), 240)
        for host in others:
            self._keep(host, sys.executable, *WORKER)

    def _keep(self, host: Host, *command: str) -> None:
        with (self.folder / f"{len(self.keepers)}.log").open("wb") as log:
            words = host.command("sh", "-c", AGAIN, "sh", *command)
            keeper = subprocess.Popen(words, env=self.environment, stdout=log, stderr=log, start_new_session=True)
        self.keepers.append((host, keeper))

    def parts(self, word: str) -> list[psutil.Process]:
        """The parts whose command has a word, such as ``worker`` or ``api``."""
        return named((part for _, keeper in self.keepers for part in psutil.Process(keeper.pid).children()), word)

    def host_of(self, part: psutil.Process) -> Host:
        """Where it runs."""
        return next(host for host, keeper in self.keepers if keeper.pid == part.ppid())

    def get(self, path: str) -> Any:
        return self.http.get(path).raise_for_status().json()

    def stop(self) -> None:
        self.http.close()
        for _, keeper in self.keepers:
            os.killpg(keeper.pid, signal.SIGKILL)
            keeper.wait()


@contextmanager
def apart(folder: Path, hosts: Sequence[Host], environment: dict[str, str]) -> Iterator[Apart]:
    """Such a service, until it is no longer needed."""
    warm()  # here, once, rather than beside clocks
    made = Apart(folder, hosts, environment)
    try:
        yield made
    finally:
        made.stop()
