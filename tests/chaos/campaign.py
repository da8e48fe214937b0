"""One run: clients, faults by a seeded schedule, calm, and what is left."""

import itertools
import time
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from threading import Event, Lock
from types import MappingProxyType

from sqlalchemy import select

from app.db.models import Case
from app.storage import HistoryStore
from tests.chaos import remains
from tests.chaos.clients import Client
from tests.chaos.faults import FAULTS, Fault, possible
from tests.chaos.record import Record
from tests.chaos.system import LEASE_S, MAX_ATTEMPTS, SWEEP_S, System, system, until

CLIENTS = 4
WORKERS = {"sqlite": 2, "postgresql": 2, "hosts": 4}
PAUSE_S = 1.2  # between two faults, on average
CASES_PER_FAULT = 25  # or there is no telling what part of the work is done twice, least of all on a slow machine
PATIENCE_S = 120.0  # until a worker is there again
STANDSTILL_S = 20.0
HIT_S = 60.0  # until there is something for a fault to hit
VERIFIED = 10  # cases computed once more at the end
CALM_S = 90.0  # for everything to end once nothing breaks any more


def run(
    file: Path,
    database: str,
    faults: int,
    seed: int,
    control: str = "",
    calm_s: float = CALM_S,
    environment: Mapping[str, str] = MappingProxyType({}),
) -> None:
    """Write the record of a run, or of a control, whose environment takes something away."""
    record = Record(file)
    record.write(
        "settings",
        database=database,
        seed=seed,
        control=control,
        lease_s=LEASE_S,
        sweep_s=SWEEP_S,
        max_attempts=MAX_ATTEMPTS,
        workers=WORKERS[database],
        clients=CLIENTS,
        complete_set=remains.complete_set(),
    )
    workers = WORKERS[database]
    with system(database, record, workers + 1, **environment) as made, made.running(workers):
        stopping, over = Event(), Event()
        url = str(made.service.http.base_url)
        clients = [Client(url, record, f"client-{n}", seed, stopping, over) for n in range(CLIENTS)]
        for client in clients:
            client.start()
        try:
            inject(made, faults, seed)
        finally:
            record.write("calm")
            stopping.set()
            deadline = time.monotonic() + calm_s
            for client in clients:
                client.join(max(0.0, deadline - time.monotonic()))
            over.set()
        verify(made, seed)
        made.follower.close()
        store = HistoryStore((made.data / "histories").as_uri())
        record.write("remains", **remains.collect(made.follower.database, store))
    record.close()


def inject(made: System, count: int, seed: int) -> None:
    """Let faults happen at random instants, also at the same time, but of each kind one at a time."""
    rng = Random(seed)
    alone = {fault: Lock() for fault in FAULTS}
    with ThreadPoolExecutor(len(FAULTS)) as pool:
        enough = itertools.count(0, CASES_PER_FAULT)
        while count:
            happening = []
            for fault in deck(made, count, rng):
                time.sleep(rng.expovariate(1 / PAUSE_S))
                until(made.workers, PATIENCE_S)  # or nothing is done that could be broken
                let_work(made, next(enough))
                happening.append(pool.submit(happen, made, fault, Random(rng.random()), alone[fault]))
            count -= sum(future.result() for future in happening)


def let_work(made: System, enough: int) -> None:
    """Wait until so many cases are computed, but not for long: where a rule is off, all may stand still."""
    deadline = time.monotonic() + STANDSTILL_S
    while made.follower.succeeded < enough and time.monotonic() < deadline:
        time.sleep(0.05)


def deck(made: System, count: int, rng: Random) -> list[Fault]:
    """Which faults, in which order: each as often as it weighs, shuffled."""
    cards = possible(made)
    drawn: list[Fault] = []
    while len(drawn) < count:
        rng.shuffle(cards)
        drawn += cards
    return drawn[:count]


def happen(made: System, fault: Fault, rng: Random, alone: Lock) -> bool:
    """Try for a while, until there is something to hit."""
    with alone:
        deadline = time.monotonic() + HIT_S
        while time.monotonic() < deadline:
            began = made.record.now()
            if (details := fault(made, rng)) is not None:
                made.record.write("fault", **{"fault": fault.__name__, "began": began} | details)
                return True
            time.sleep(0.05)
    return False


def verify(made: System, seed: int) -> None:
    """Have some stored cases computed once more."""
    with made.follower.database.read() as session:
        succeeded = session.scalars(select(Case.id).where(Case.state == "succeeded").order_by(Case.id)).all()
    http = made.service.http
    paths = [f"/v1/cases/{n}/verification" for n in Random(seed).sample(succeeded, min(VERIFIED, len(succeeded)))]
    for path in paths:
        http.post(path).raise_for_status()
    for path in paths:
        until(lambda path=path: made.service.get(path)["state"] in ("succeeded", "failed"))
