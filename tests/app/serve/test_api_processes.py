"""The API as several processes behind one port."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import httpx
import psutil

import migrations
from tests.conftest import free_port


def test_several_processes_answer_and_one_that_dies_is_replaced(tmp_path: Path) -> None:
    port = free_port()
    migrations.upgrade(f"sqlite:///{tmp_path}/tracksweep.db")
    settings = {"TRACKSWEEP_DATA_DIR": str(tmp_path), "TRACKSWEEP_API_PROCESSES": "2", "TRACKSWEEP_PORT": str(port)}
    with (tmp_path / "log").open("w") as log:
        api = subprocess.Popen(
            [sys.executable, "-m", "worker.cli", "api"], env=os.environ | settings, stdout=log, stderr=log
        )
    try:
        first = started(tmp_path, 2)
        assert httpx.get(f"http://127.0.0.1:{port}/readyz", trust_env=False, timeout=30).is_success
        psutil.Process(min(first)).kill()
        second = started(tmp_path, 3)
        assert len(second) == 3
        assert max(first) in {child.pid for child in psutil.Process(api.pid).children()}
        assert httpx.get(f"http://127.0.0.1:{port}/readyz", trust_env=False, timeout=30).is_success
        api.send_signal(signal.SIGTERM)
        assert api.wait(timeout=30) == 0
    finally:
        api.kill()
        api.wait()


def started(folder: Path, count: int) -> set[int]:
    """Process ids of servers, once so many have started."""
    deadline = time.monotonic() + 60
    while (text := (folder / "log").read_text()).count("Application startup complete") < count:
        assert time.monotonic() < deadline, text
        time.sleep(0.05)
    lines = [line for line in text.splitlines() if "Started server process" in line]
    return {int(line.partition("[")[2].rstrip("]")) for line in lines}
