"""How many cases per second database and broker sustain, from workers on four hosts whose solver sleeps.

python -m benchmarks.scale [--seconds S] [--postgresql OPTIONS]

With huge pages, if the machine has some to give: `sysctl -w vm.nr_hugepages=2400`.
"""

import argparse
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import psutil
from sqlalchemy import func, select, text

from app.db.models import Case
from app.db.session import Database
from app.settings import Settings
from benchmarks.results import Result, publish
from tests.cluster import Cluster, cluster

POSTGRESQL = "-c shared_buffers=4GB -c max_wal_size=8GB -c huge_pages=try"  # as docs/deploy.md advises
HOSTS = 4
WORKERS = (4, 8, 12, 16, 24)
WRITERS = (1024, Settings().writers)  # that add peaks at once: all, and as many as they are by themselves
SLEEP_S = 0.5  # of a batch
LONG_S = 60.0  # as above, so that workers do nothing but say that they are there
LANES = 8
SPEEDS, AMPLITUDES, WAVELENGTHS = 25, 80, 5  # 10 000 cases: as many as a study may have
CALM_S = 5.0  # after a change of workers

HOW = """API, PostgreSQL (durable; `{options}`, huge pages: {huge}) and broker on one host, workers on {hosts}
others, each in a network namespace of one machine of {cores} cores, which they share. Workers claim, extend leases, and
write what a case has, {peaks} peaks under all indexes; only the solver is replaced by a sleep of {sleep} s per batch of
{lanes}. *Offered* is what the sleeps allow. *Writers* may add peaks at once (`TRACKSWEEP_WRITERS`; {all}: all), each
number beginning with an empty database. Processor times per case are those of all of PostgreSQL and of all
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


def alive_ms(postgresql: str, seconds: float) -> float:
    """Processor time that PostgreSQL takes each second for a worker that computes a batch for long, ms."""
    count = WORKERS[-1]
    with cluster(HOSTS, postgresql) as made:
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


@dataclass(frozen=True, kw_only=True)
class Growth:
    """What more and more workers did, and what they left."""

    rows: list[list[str]]
    best: tuple[float, float]  # cases per second, and processor time of PostgreSQL per case, ms
    peaks: float  # per case
    size: float  # of the database per case, bytes
    huge: str


def grow(postgresql: str, writers: int, seconds: float) -> Growth:
    """Start more and more workers."""
    rows, found, studies = [], [], 0
    with cluster(HOSTS, postgresql, TRACKSWEEP_WRITERS=str(writers)) as made:
        database = Database(made.local_url)
        for count in WORKERS:
            queued = 10_000 * studies - finished(database)
            while queued < 400 * (seconds + CALM_S):
                made.http.post("/v1/studies", json=study(studies), timeout=300).raise_for_status()
                studies, queued = studies + 1, queued + 10_000
            start_workers(made, count, SLEEP_S)
            time.sleep(CALM_S)
            rate, server_ms, worker_ms = measure(made, database, seconds)
            found.append((rate, server_ms))
            measured = count * LANES / SLEEP_S, rate, server_ms, worker_ms
            rows.append([str(writers), str(count), *(f"{value:.1f}" for value in measured)])
            print(rows[-1], flush=True)
        with database.read() as session:
            size = int(session.scalar(text("SELECT pg_database_size(current_database())")) or 0)
            peaks = int(session.scalar(text("SELECT COUNT(*) FROM peak")) or 0)
            huge = str(session.scalar(text("SHOW huge_pages_status")))
        cases = finished(database)
        database.close()
    return Growth(rows=rows, best=max(found), peaks=peaks / cases, size=size / cases, huge=huge)


def run(postgresql: str, seconds: float) -> Result:
    """Measure all."""
    idle_ms = alive_ms(postgresql, seconds)
    grown = [grow(postgresql, writers, seconds) for writers in WRITERS]
    all_at_once, usual = grown
    how = HOW.format(
        options=postgresql,
        huge=usual.huge,
        hosts=HOSTS,
        cores=psutil.cpu_count(),
        peaks=round(usual.peaks),
        sleep=SLEEP_S,
        lanes=LANES,
        all=WRITERS[0],
    )
    return Result(
        title="Cases per second that the queue sustains",
        how=how,
        command="python -m benchmarks.scale",
        values={
            "cases_per_s": usual.best[0],
            "cases_per_s_all_at_once": all_at_once.best[0],
            "postgresql_ms_per_case": usual.best[1],
            "postgresql_ms_per_worker_and_s": idle_ms,
            "database_kb_per_case": usual.size / 1e3,
        },
        table=[
            ["writers", "workers", "offered, cases/s", "cases/s", "PostgreSQL, ms/case", "workers, ms/case"],
            *(row for each in grown for row in each.rows),
        ],
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--seconds", type=float, default=20.0, help="at every number of workers")
    parser.add_argument("--postgresql", default=POSTGRESQL, help="its options")
    options = parser.parse_args()
    publish("scale", run(options.postgresql, options.seconds))


if __name__ == "__main__":
    main()
