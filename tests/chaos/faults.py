"""What can go wrong. Each fault is a function that does it, and undoes it where it would pass; its name is its kind.

A fault returns what is worth recording, or None if there was nothing it could hit. ``silences`` in what is recorded
names the worker that from that moment on says nothing any more.
"""

import signal
import sqlite3
import time
from collections.abc import Callable
from contextlib import closing, suppress
from pathlib import Path
from random import Random
from typing import Any

import psutil
import redis

from app.db.session import SILENCE_MS
from tests.chaos.apart import Apart
from tests.chaos.system import LEASE_S, System, worker_name

Details = dict[str, Any]
Fault = Callable[[System, Random], Details | None]
REACHED_S = 4.0  # until some process comes by a point at which it is to die


def kill_worker(system: System, rng: Random) -> Details | None:
    return _signal(system, _some_worker(system, rng), signal.SIGKILL)


def kill_idle_or_starting_worker(system: System, rng: Random) -> Details | None:
    return _signal(system, rng.choice(system.service.parts("worker") or [None]), signal.SIGKILL)


def stop_worker_longer_than_its_lease(system: System, rng: Random) -> Details | None:
    worker = _some_worker(system, rng)
    details = _signal(system, worker, signal.SIGSTOP)
    time.sleep(LEASE_S + rng.uniform(0.5, 2))
    _signal(system, worker, signal.SIGCONT)
    return details


def terminate_worker(system: System, rng: Random) -> Details | None:
    details = _signal(system, _some_worker(system, rng), signal.SIGTERM)
    return details and {"pid": details["pid"]}  # it puts back what it holds


def kill_worker_after_claim(system: System, rng: Random) -> Details | None:
    return _ambush(system, "worker-after-claim")


def kill_worker_between_object_and_commit(system: System, rng: Random) -> Details | None:
    return _ambush(system, "worker-between-object-and-commit")


def kill_worker_after_commit(system: System, rng: Random) -> Details | None:
    return _ambush(system, "worker-after-commit")


def kill_api(system: System, rng: Random) -> Details | None:
    return _signal(system, system.part("api"), signal.SIGKILL)


def kill_api_between_commit_and_bell(system: System, rng: Random) -> Details | None:
    return _ambush(system, "api-between-commit-and-bell")


def kill_broker(system: System, rng: Random) -> Details | None:
    return _signal(system, system.part("server"), signal.SIGKILL)


def flush_broker(system: System, rng: Random) -> Details | None:
    with suppress(redis.RedisError), closing(redis.Redis.from_url(system.broker_url)) as broker:
        broker.flushall()
        return {}
    return None


def restart_database(system: System, rng: Random) -> Details | None:
    """As after a crash: nothing is written down, connections are cut. Of SQLite, whose database is a file: somebody
    else holds its lock.
    """
    down_s = rng.uniform(0.2, 2.5)
    if system.postgres:
        system.postgres.stop("immediate")
        time.sleep(down_s)
        system.postgres.start()
    else:
        with closing(sqlite3.connect(system.data / "tracksweep.db", timeout=10, isolation_level=None)) as database:
            try:
                database.execute("BEGIN EXCLUSIVE")
            except sqlite3.OperationalError:  # who holds it was stopped, or the disk is full
                return None
            time.sleep(down_s)
            database.execute("ROLLBACK")
    return {"down_s": round(down_s, 3)}


def fill_disk(system: System, rng: Random) -> Details | None:
    """Nothing can be written any more; where no disk may be mounted, by one of the workers."""
    full_s = rng.uniform(0.5, 3)
    if system.disk:
        _fill(system.disk / "ballast")
        time.sleep(full_s)
        (system.disk / "ballast").unlink()
        return {"full_s": round(full_s, 3)}
    worker = _some_worker(system, rng)
    with suppress(psutil.NoSuchProcess, AttributeError):
        worker.rlimit(psutil.RLIMIT_FSIZE, (0, psutil.RLIM_INFINITY))
        time.sleep(full_s)
        worker.rlimit(psutil.RLIMIT_FSIZE, (psutil.RLIM_INFINITY, psutil.RLIM_INFINITY))
        return {"pid": worker.pid, "full_s": round(full_s, 3)}
    return None


def slow_disk(system: System, rng: Random) -> Details | None:
    """Every transaction and every object takes half a second longer."""
    slow_s = rng.uniform(1, 3)
    (system.control / "slow").touch()
    time.sleep(slow_s)
    (system.control / "slow").unlink()
    return {"slow_s": round(slow_s, 3)}


def jump_clock(system: System, rng: Random) -> Details | None:
    """The clock of one worker by ten minutes, for a while. With SQLite all that share the file share a machine, and so
    its clock.
    """
    if not system.library:
        return None
    worker = _some_worker(system, rng)
    if worker is None:
        return None
    jump_s, ahead_s = rng.choice((-600, 600)), rng.uniform(1.5, 4)  # longer than a process believes in the time it read
    clock = system.control / system.environment["CHAOS_CLOCK"].format(pid=worker.pid)
    _set(clock, f"{jump_s:+d}")
    time.sleep(ahead_s)
    _set(clock, "+0")
    return {"jump_s": jump_s, "ahead_s": round(ahead_s, 3)}


def cut_off_host(system: System, rng: Random) -> Details | None:
    """Pull the plug of a worker's host for longer than a lease, sometimes for longer than PostgreSQL keeps silent
    connections. What runs there runs on.
    """
    worker = _some_worker(system, rng)
    if worker is None or not isinstance(system.service, Apart):
        return None
    cut_s = LEASE_S + rng.uniform(0.5, 2) if rng.random() < 0.7 else SILENCE_MS / 1000 + rng.uniform(2, 6)
    try:
        host = system.service.host_of(worker)
    except psutil.NoSuchProcess:
        return None
    host.cut_off()
    details = _silenced(system, worker.pid)
    time.sleep(cut_s)
    host.reconnect()
    return details | {"cut_s": round(cut_s, 3)}


# How often each comes up among the others.
FAULTS: dict[Fault, int] = {
    kill_worker: 3,
    kill_idle_or_starting_worker: 1,
    stop_worker_longer_than_its_lease: 3,
    terminate_worker: 1,
    kill_worker_after_claim: 1,
    kill_worker_between_object_and_commit: 2,
    kill_worker_after_commit: 1,
    kill_api: 1,
    kill_api_between_commit_and_bell: 2,
    kill_broker: 1,
    flush_broker: 1,
    restart_database: 2,
    fill_disk: 1,
    slow_disk: 1,
    jump_clock: 2,
    cut_off_host: 4,
}


def possible(system: System) -> list[Fault]:
    """Which of them can come about, each as often as it weighs."""
    there = {jump_clock: bool(system.library), cut_off_host: bool(system.hosts)}
    return [fault for fault, weight in FAULTS.items() for _ in range(weight) if there.get(fault, True)]


def _some_worker(system: System, rng: Random) -> psutil.Process | None:
    """One that holds cases, if there is one: whoever is idle has nothing to lose."""
    workers = system.workers()
    busy = [each for each in workers if worker_name(each.pid) in set(system.follower.holders.values())]
    return rng.choice(busy or workers or [None])


def _signal(system: System, process: psutil.Process | None, number: signal.Signals) -> Details | None:
    if process is None:
        return None
    try:
        process.send_signal(number)
    except psutil.NoSuchProcess:
        return None
    return _silenced(system, process.pid)


def _silenced(system: System, pid: int) -> Details:
    return {"pid": pid, "silences": worker_name(pid), "began": system.record.now()}


def _ambush(system: System, point: str) -> Details | None:
    """Have whoever comes by a named point first die there."""
    request = system.control / point
    request.touch()
    deadline = time.monotonic() + REACHED_S
    while request.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    with suppress(FileNotFoundError):
        request.unlink()
        return None
    (hit,) = system.control.glob(f"{point}.*")
    hit.unlink()
    return _silenced(system, int(hit.suffix[1:]))


def _fill(ballast: Path) -> None:
    with ballast.open("wb", buffering=0) as file, suppress(OSError):
        for size in (2**20, 2**12):
            with suppress(OSError):
                while True:
                    file.write(bytes(size))


def _set(clock: Path, offset: str) -> None:
    draft = clock.with_suffix(".draft")
    draft.write_text(offset)
    draft.replace(clock)
