"""How many cases per second database and broker sustain, from workers on four hosts whose solver sleeps.

python -m benchmarks.scale [--seconds S]
"""

import argparse
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import Any

import psutil
from sqlalchemy import func, select, text

from app.db.models import Case
from app.db.session import Database
from benchmarks.results import Result, publish
from tests.cluster import DURABLE, Cluster, cluster

HOSTS = 4
WORKERS = (4, 8, 12, 16, 24)
SLEEP_S = 0.5  # of a batch
LONG_S = 60.0  # as above, so that workers do nothing but say that they are there
LANES = 8
SPEEDS, AMPLITUDES, WAVELENGTHS = 25, 80, 5  # 10 000 cases: as many as a study may have
CALM_S = 5.0  # after a change of workers

HOW = """API, PostgreSQL (durable; {options}) and broker on one host, workers on {hosts}
others, each in a network namespace of one machine of {cores} cores, which they share. Workers claim, extend leases, and
write what a case has, {peaks} peaks under all indexes; only the solver is replaced by a sleep of {sleep} s per batch of
{lanes}. *Offered* is what the sleeps allow. Processor times per case are those of all of PostgreSQL and of all
workers. `postgresql_ms_per_worker_and_s` is what PostgreSQL takes for a worker that computes {lanes} cases for long."""


def study(number: int) -> dict[str, Any]:
    """Cases that nothing has computed yet."""
    wave = {
        "kind": "harmonic",
        "wavelength_m": [1.0 + 0.1 * n for n in range(WAVELENGTHS)],
        "amplitude_mm": [(1 + n) / 1000 for n in range(AMPLITUDES)],
    }
    speeds = [100.0 + 10 * number + n / 10 for n in range(SPEEDS)]
    return {"name": "many", "sweep": {"kind": "product", "speed_kmh": speeds, "irregularity": wave}}


def counted(database: Database, state: str) -> int:
    """Cases in a state."""
    with database.read() as session:
        return session.scalar(select(func.count()).where(Case.state == state)) or 0


def finished(database: Database) -> int:
    """Cases that have ended."""
    return counted(database, "succeeded")


def cpu_s(processes: Iterable[psutil.Process]) -> float:
    """Processor time so far, that of children that have ended included."""
    total = 0.0
    for each in processes:
        with suppress(psutil.NoSuchProcess):
            times = each.cpu_times()
            total += times.user + times.system + times.children_user + times.children_system
    return total


def of_postgres(made: Cluster) -> Iterator[psutil.Process]:
    """Its processes."""
    for each in psutil.process_iter():
        with suppress(psutil.Error):
            if each.name() == "postgres" and each.cwd().startswith(str(made.postgres.folder)):
                yield each


def measure(made: Cluster, database: Database, seconds: float) -> tuple[float, float, float]:
    """Cases per second, and processor time per case of PostgreSQL and of the workers, ms."""

    def used() -> tuple[float, float]:
        workers = (psutil.Process(each.pid) for each in made.running if each is not made.api)
        return cpu_s(of_postgres(made)), cpu_s(workers)

    done, began, before = finished(database), time.monotonic(), used()
    time.sleep(seconds)
    cases, took_s, after = finished(database) - done, time.monotonic() - began, used()
    if not cases:
        raise SystemExit("no case has ended: nothing is measured")
    return cases / took_s, 1e3 * (after[0] - before[0]) / cases, 1e3 * (after[1] - before[1]) / cases


def start_workers(made: Cluster, count: int, sleep_s: float) -> None:
    """Workers until there are so many."""
    while len(made.workers()) < count:
        started = sum(each is not made.api for each in made.running[1:])
        for n in range(started, count):
            made.start_worker(made.others[n % HOSTS], ("-m", "benchmarks.sleeper", str(sleep_s)))
        time.sleep(0.5)


def alive_ms(seconds: float) -> float:
    """Processor time that PostgreSQL takes each second for a worker that computes a batch for long, ms."""
    count = WORKERS[-1]
    with cluster(HOSTS) as made:
        database = Database(made.local_url)
        made.http.post("/v1/studies", json=study(0), timeout=300).raise_for_status()
        start_workers(made, count, LONG_S)
        while counted(database, "running") < count * LANES:
            time.sleep(0.5)
        before = cpu_s(of_postgres(made))
        time.sleep(seconds)
        taken_s = cpu_s(of_postgres(made)) - before
        database.close()
    return 1e3 * taken_s / seconds / count


def run(seconds: float) -> Result:
    """Start more and more workers."""
    table = [["workers", "offered, cases/s", "cases/s", "PostgreSQL, ms/case", "workers, ms/case"]]
    found, idle_ms = [], alive_ms(seconds)
    with cluster(HOSTS) as made:
        database = Database(made.local_url)
        studies = 0
        for count in WORKERS:
            queued = 10_000 * studies - finished(database)
            while queued < 400 * (seconds + CALM_S):
                made.http.post("/v1/studies", json=study(studies), timeout=300).raise_for_status()
                studies, queued = studies + 1, queued + 10_000
            start_workers(made, count, SLEEP_S)
            time.sleep(CALM_S)
            rate, server_ms, worker_ms = measure(made, database, seconds)
            found.append((rate, server_ms))
            offered = count * LANES / SLEEP_S
            table.append([str(count), *(f"{value:.1f}" for value in (offered, rate, server_ms, worker_ms))])
            print(table[-1], flush=True)
        with database.read() as session:
            size = int(session.scalar(text("SELECT pg_database_size(current_database())")) or 0)
            cases = finished(database)
            peaks = int(session.scalar(text("SELECT COUNT(*) FROM peak")) or 0) / cases
        database.close()
    saturated, server_ms = max(found)
    return Result(
        title="Cases per second that the queue sustains",
        how=HOW.format(
            options=DURABLE, hosts=HOSTS, cores=psutil.cpu_count(), peaks=round(peaks), sleep=SLEEP_S, lanes=LANES
        ),
        command="python -m benchmarks.scale",
        values={
            "cases_per_s": saturated,
            "postgresql_ms_per_case": server_ms,
            "postgresql_ms_per_worker_and_s": idle_ms,
            "database_kb_per_case": size / cases / 1e3,
        },
        table=table,
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seconds", type=float, default=20.0, help="at every number of workers")
    options = parser.parse_args()
    publish("scale", run(options.seconds))


if __name__ == "__main__":
    main()
