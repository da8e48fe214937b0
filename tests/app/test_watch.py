"""Streams of events, on both databases, cut and resumed over real connections."""

import json
import random
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import pytest
from sqlalchemy import func, select, text
from sqlalchemy.exc import OperationalError
from sqlalchemy.orm import Session

from app.db.models import Event
from app.db.session import Database
from app.settings import Settings
from app.studies import watch
from tests.outcomes import succeed
from worker.claim import claim

Check = Callable[..., dict[str, Any]]
Message = dict[str, Any]


def messages(lines: Iterator[str]) -> Iterator[Message]:
    """What a client makes of a stream; a comment is a message without an event."""
    message: Message = {}
    for line in lines:
        if not line:
            yield message
            message = {}
            continue
        field, _, value = line.partition(": ")
        message[field] = json.loads(value) if field == "data" else value


def follow(client: httpx.Client, url: str, after: int | None = None) -> Iterator[Message]:
    headers = {} if after is None else {"Last-Event-ID": str(after)}
    with client.stream("GET", f"{url}/events", headers=headers) as response:
        assert response.status_code == 200
        assert response.headers["content-type"].startswith("text/event-stream")
        yield from messages(response.iter_lines())


def drain(database: Database, permits: threading.Semaphore | None = None) -> None:
    """Four workers that claim and finish until nothing is queued; with a permit for each batch, if any are given."""

    def work(_: int) -> None:
        while True:
            if permits is not None:
                permits.acquire()
            with database.write() as session:
                batch = claim(session, "test", 15.0, lanes=2)
            if not batch:
                return
            for held in batch:
                with database.write() as session:
                    assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=1.0)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(work, range(4)))


def post(client: httpx.Client, study: dict[str, Any], cases: int = 4) -> str:
    amplitudes = [round(0.01 * n, 4) for n in range(1, cases // 2 + 1)]
    study["sweep"]["irregularity"]["amplitude_mm"] = amplitudes
    return str(client.post("/v1/studies", json=study).headers["location"])


def stored(database: Database, url: str) -> list[int]:
    with database.read() as session:
        return list(session.scalars(select(Event.id).where(Event.study_id == url[-32:]).order_by(Event.id)))


def test_a_study_is_watched_to_its_end(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    url = post(client, study)
    stream = follow(client, url)
    first = next(stream)
    assert (first["event"], first["data"]["state"], first["data"]["cases"]["queued"]) == ("progress", "queued", 4)
    assert "id" not in first
    worker = threading.Thread(target=drain, args=[database])
    worker.start()
    seen = list(stream)
    worker.join()
    told = [message for message in seen if message["event"] != "progress"]
    assert [message["event"] for message in told] == ["state", "state", *4 * ["case"], "state", "done"]
    assert [message["data"]["state"] for message in told[-2:]] == ["succeeded"] * 2
    assert [int(message["id"]) for message in told] == stored(database, url)
    assert [m["data"] for m in seen if m["event"] == "progress"][-1]["progress"] == 1
    assert [m for m in follow(client, url) if m["event"] != "progress"] == told  # a finished one replays


def test_where_nothing_is_to_come_nothing_is_sent(
    client: httpx.Client, database: Database, study: dict[str, Any], problem: Check
) -> None:
    url = post(client, study)
    client.post(f"{url}/cancel")
    *_, last = stored(database, url)
    assert client.get(f"{url}/events", headers={"Last-Event-ID": str(last)}).status_code == 204
    assert client.get(f"{url}/events", params={"last_event_id": 10**12}).status_code == 204
    rest = client.get(f"{url}/events", params={"last_event_id": last - 1}).text
    assert rest.count("id:") == 1
    problem(client.get(f"{url}/events", headers={"Last-Event-ID": "x"}), 422)
    problem(client.get(f"/v1/studies/{'0' * 32}/events"), 404)


def test_a_retried_study_is_watched_beyond_its_first_end(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    url = post(client, study)
    client.post(f"{url}/cancel")
    client.post(f"{url}/retry")
    drain(database)
    assert [m["event"] for m in follow(client, url)].count("done") == 2


def test_cut_fifty_times_no_event_is_lost_or_repeated(
    client: httpx.Client, database: Database, study: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(watch, "POLL_S", 0.01)  # to be done sooner
    url = post(client, study, cases=160)
    chance = random.Random(1)
    permits = threading.Semaphore(0)
    worker = threading.Thread(target=drain, args=[database, permits])
    worker.start()
    seen: list[int] = []
    for _ in range(50):
        permits.release(2)  # two cases more, claimed and finished whenever the workers come to it
        patience = chance.randint(0, 2)  # there is a progress at first, and then two events at least
        for n, message in enumerate(follow(client, url, seen[-1] if seen else None)):
            if "id" in message:
                seen.append(int(message["id"]))
            if n == patience:
                break
    permits.release(160)
    seen += [int(message["id"]) for message in follow(client, url, seen[-1]) if "id" in message]
    worker.join()
    assert seen == stored(database, url)
    assert len(seen) == 160 + 4


def test_events_of_a_study_are_committed_in_order(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    """Nobody gets a number for an event while a lower one is not committed. (SQLite has one writer anyway.)"""
    post(client, study)
    with database.write() as session:
        first, second = (claim(session, "test", 15.0, lanes=1)[0] for _ in range(2))
        postgresql = session.get_bind().dialect.name == "postgresql"
    outcome: dict[str, Any] = {"peaks": [], "processing": {}, "history": None, "cpu_s": 1.0}
    with database.write() as session:
        assert succeed(session, first, **outcome)
        if postgresql:
            with Session(database.engine) as other:
                other.execute(text("SET LOCAL lock_timeout = '50ms'"))
                with pytest.raises(OperationalError, match="lock timeout"):
                    succeed(other, second, **outcome)
    with database.write() as session:
        assert succeed(session, second, **outcome)


@pytest.fixture
def few_seats(serve: Any, settings: Settings) -> Iterator[httpx.Client]:
    with serve(settings.model_copy(update={"max_watchers": 1, "watch_keep_alive_s": 0.1})) as client:
        yield client


def test_seats_are_few_and_free_again(few_seats: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    url = post(few_seats, study)
    stream = follow(few_seats, url)
    kept_alive = (message for message in stream if "event" not in message)
    assert next(kept_alive) == {"": "ping"}
    refused = few_seats.get(f"{url}/events")
    problem(refused, 503, "too-many-watchers")
    assert int(refused.headers["retry-after"]) > 0
    stream.close()
    while True:
        with few_seats.stream("GET", f"{url}/events") as response:
            if response.status_code == 200:
                return


def test_a_watcher_holds_no_connection(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    """Else twenty of them would exhaust PostgreSQL's pool of fifteen."""
    url = post(client, study)
    streams = [follow(client, url) for _ in range(20)]
    for stream in streams:
        assert next(stream)["event"] == "progress"
    assert client.get(url).status_code == 200
    client.post(f"{url}/cancel")
    for stream in streams:
        assert [m["event"] for m in stream][-1] == "done"
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Event)) == 3
