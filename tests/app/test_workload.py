"""The queue over HTTP: what waits, what runs where, and how fast cases are done."""

from typing import Any

import httpx
from sqlalchemy import insert, update

from app.access import keys
from app.db.models import Case, Worker
from app.db.session import Database
from app.db.types import Clock
from app.settings import Settings


def test_an_empty_queue(client: httpx.Client) -> None:
    assert client.get("/v1/queue").json() == {
        "queued": 0,
        "running": 0,
        "oldest_queued_at": None,
        "throughput": {"last_minute": 0, "last_hour": 0, "cpu_s_last_hour": 0.0},
        "workers": [],
    }


def begin(database: Database, *names: str) -> None:
    with database.write() as session:
        session.execute(
            insert(Worker), [{"name": name, "expires": 1e12, "draining": name == "there:2"} for name in names]
        )
        session.execute(insert(Worker), {"name": "gone", "expires": 1.0})


def set_case(database: Database, case_id: int, **values: Any) -> None:
    with database.write() as session:
        session.execute(update(Case).where(Case.id == case_id).values(values))


def test_what_waits_and_what_runs_where(client: httpx.Client, study: dict[str, Any], database: Database) -> None:
    created = client.post("/v1/studies", json=study).json()
    ids = [case["id"] for case in client.get(f"/v1/studies/{created['id']}/cases").json()["items"]]
    begin(database, "here:1", "there:2")
    set_case(database, ids[0], state="running", worker="here:1", progress=0.25, attempt=1, started_at=Clock())
    set_case(database, ids[1], state="succeeded", finished_at=Clock() - 30, cpu_s=2.0)
    set_case(database, ids[2], state="failed", finished_at=Clock() - 600, cpu_s=None)
    found = client.get("/v1/queue").json()
    assert (found["queued"], found["running"]) == (1, 1)
    oldest = client.get(f"/v1/cases/{ids[3]}").json()["created_at"]
    assert found["oldest_queued_at"] == oldest
    assert found["throughput"] == {"last_minute": 1, "last_hour": 2, "cpu_s_last_hour": 2.0}
    here, there = found["workers"]
    assert (here["name"], here["running"], there) == (
        "here:1",
        1,
        {"name": "there:2", "draining": True, "running": 0, "cases": []},
    )
    (case,) = here["cases"]
    assert (case["id"], case["progress"], case["speed_kmh"], case["attempt"]) == (ids[0], 0.25, 250.0, 1)


def test_others_see_that_a_worker_is_busy_not_with_what(
    settings: Settings, serve: Any, study: dict[str, Any], database: Database
) -> None:
    with database.write() as session:
        headers = [{"Authorization": f"Bearer {keys.create(session, n, 'write', None, None)[1]}"} for n in ("a", "b")]
    with serve(settings) as client:
        study_id = client.post("/v1/studies", json=study, headers=headers[0]).json()["id"]
        case = client.get(f"/v1/studies/{study_id}/cases", headers=headers[0]).json()["items"][0]["id"]
        begin(database, "here:1")
        set_case(database, case, state="running", worker="here:1")
        (own,), (of_other,) = (client.get("/v1/queue", headers=each).json()["workers"] for each in headers)
    assert [own["running"], len(own["cases"])] == [1, 1]
    assert [of_other["running"], len(of_other["cases"])] == [1, 0]
