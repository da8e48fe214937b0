"""The supervisor on small parts: what ends is restarted, what will not start is told, what will not stop is killed."""

import asyncio
import contextlib
import os
import signal
import sys
import time
from collections.abc import Awaitable, Callable, Iterator
from pathlib import Path

import psutil
import pytest

from app.serve import supervisor
from app.serve.supervisor import Part, PartFailedError, supervise

FOREVER = "import time; time.sleep(600)"


def part(name: str, script: str, *arguments: object, ready: Callable[[], Awaitable[bool]] | None = None) -> Part:
    return Part(name=name, command=[sys.executable, "-c", script, *map(str, arguments)], ready=ready)


def exists(path: Path) -> Callable[[], Awaitable[bool]]:
    async def check() -> bool:
        return path.exists()

    return check


def interrupt() -> None:
    os.kill(os.getpid(), signal.SIGINT)


@pytest.fixture(autouse=True)
def nothing_left_behind() -> Iterator[None]:
    before = set(psutil.Process().children(recursive=True))
    yield
    assert set(psutil.Process().children(recursive=True)) <= before


def test_a_part_that_ends_is_restarted(tmp_path: Path) -> None:
    runs, steady = tmp_path / "runs", tmp_path / "steady"
    script = f"""
import pathlib, sys
runs, steady = map(pathlib.Path, sys.argv[1:])
with runs.open("a") as file: file.write("run\\n")
if len(runs.read_text().split()) < 3: sys.exit("no luck")
steady.touch()
{FOREVER}
"""
    asyncio.run(supervise([[part("brittle", script, runs, steady, ready=exists(steady))]], tmp_path, interrupt))
    assert runs.read_text().split() == ["run"] * 3
    assert (tmp_path / "brittle.log").read_text() == "no luck\n" * 2


def test_a_part_that_never_starts_is_reported_with_its_last_words(tmp_path: Path) -> None:
    stages = [
        [part("first", FOREVER)],
        [part("broken", "import sys; sys.exit('the disk is full')", ready=exists(tmp_path / "never"))],
    ]
    with pytest.raises(PartFailedError, match=r"(?s)broken does not start.*the disk is full"):
        asyncio.run(supervise(stages, tmp_path, interrupt))


def wait_for_end(pid: int) -> None:
    """Return once a process that was killed is gone, or only waits to be buried; it may take a moment to die."""
    deadline = time.monotonic() + 10
    with contextlib.suppress(psutil.NoSuchProcess):
        while psutil.Process(pid).status() != psutil.STATUS_ZOMBIE:
            assert time.monotonic() < deadline, "the process still runs"
            time.sleep(0.01)


def test_a_part_that_will_not_stop_is_killed_with_what_it_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(supervisor, "STOP_TIMEOUT_S", 0.3)
    up = tmp_path / "up"
    script = f"""
import pathlib, signal, subprocess, sys
signal.signal(signal.SIGTERM, signal.SIG_IGN)
child = subprocess.Popen([sys.executable, "-c", {FOREVER!r}])
pathlib.Path(sys.argv[1]).write_text(str(child.pid))
{FOREVER}
"""
    asyncio.run(supervise([[part("stubborn", script, up, ready=exists(up))]], tmp_path, interrupt))
    wait_for_end(int(up.read_text()))


def test_parts_stop_in_reverse_order_of_starting(tmp_path: Path) -> None:
    order = tmp_path / "order"
    script = f"""
import pathlib, signal, sys
def end(*_):
    with open(sys.argv[1], "a") as file: file.write(sys.argv[2])
    sys.exit()
signal.signal(signal.SIGTERM, end)
pathlib.Path(sys.argv[1] + sys.argv[2]).touch()
{FOREVER}
"""
    stages = [[part(name, script, order, name, ready=exists(tmp_path / f"order{name}"))] for name in "abc"]
    asyncio.run(supervise(stages, tmp_path, interrupt))
    assert order.read_text() == "cba"


def test_a_signal_while_parts_come_up_stops_them(tmp_path: Path) -> None:
    async def interrupted() -> bool:
        interrupt()
        return False

    started = time.monotonic()
    asyncio.run(supervise([[part("slow", FOREVER, ready=interrupted)]], tmp_path, pytest.fail))
    assert time.monotonic() - started < 10


def test_the_last_stage_is_drained_before_the_others_stop(tmp_path: Path) -> None:
    order = tmp_path / "order"
    script = f"""
import pathlib, signal, sys
def end(number, _):
    with open(sys.argv[1], "a") as file: file.write(sys.argv[2] + signal.Signals(number).name + " ")
    sys.exit()
for number in signal.SIGTERM, signal.SIGUSR2: signal.signal(number, end)
pathlib.Path(sys.argv[1] + sys.argv[2]).touch()
{FOREVER}
"""
    stages = [[part(name, script, order, name, ready=exists(tmp_path / f"order{name}"))] for name in "ab"]
    asyncio.run(supervise(stages, tmp_path, lambda: os.kill(os.getpid(), signal.SIGUSR2)))
    assert order.read_text().split() == ["bSIGUSR2", "aSIGTERM"]
