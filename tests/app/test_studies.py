"""Studies from their acceptance to their end, on both databases. The workers here only claim and finish."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from datetime import datetime
from typing import Any

import httpx
import pytest
from sqlalchemy import func, select

from app.db.models import Case, Event, IdempotencyKey, Study
from app.db.session import Database
from app.settings import Settings
from tests.outcomes import succeed
from worker import lease, presence
from worker.claim import claim

Check = Callable[..., dict[str, Any]]


def finish(database: Database, *, fail: bool = False) -> int:
    """What a worker does for one case, without the computing. Returns the case."""
    with database.write() as session:
        (held,) = claim(session, "test", 15.0, lanes=1)
    with database.write() as session:
        if fail:
            assert lease.fail(session, held, "diverged", "beyond all bounds")
        else:
            assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=1.5)
    return held.case_id


def test_a_new_study_is_queued(client: httpx.Client, study: dict[str, Any]) -> None:
    response = client.post("/v1/studies", json=study | {"labels": {"line": "Köln–Rhein/Main"}, "priority": 3})
    assert response.status_code == 201
    created = response.json()
    assert response.headers["location"] == f"/v1/studies/{created['id']}"
    assert created["state"] == "queued"
    assert created["progress"] == 0
    assert created["cases"] == {"total": 4, "queued": 4, "running": 0, "succeeded": 0, "failed": 0, "cancelled": 0}
    assert created["labels"] == {"line": "Köln–Rhein/Main"}
    assert created["definition"]["sweep"] == study["sweep"]
    assert client.get(response.headers["location"]).json() == created


def test_its_definition_makes_the_same_study_again(client: httpx.Client, study: dict[str, Any]) -> None:
    definition = client.post("/v1/studies", json=study).json()["definition"]
    again = client.post("/v1/studies", json=definition).json()
    assert again["definition"] == definition
    cases = [client.get(f"/v1/studies/{each['id']}/cases").json() for each in client.get("/v1/studies").json()["items"]]
    assert cases[0]["items"] == cases[1]["items"]


def test_a_study_comes_to_its_end(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    url = client.post("/v1/studies", json=study).headers["location"]
    with database.write() as session:
        (held,) = claim(session, "test", 15.0, lanes=1)
    with database.write() as session:
        assert lease.extend(session, [held], 15.0, {held.case_id: 0.5})
    running = client.get(url).json()
    assert (running["state"], running["progress"]) == ("running", 0.125)
    assert running["finish"] is None  # for there is no worker
    with database.write() as session:
        presence.announce(session, "one", 600.0)
    with database.write() as session:
        assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=1.5)
    assert datetime.fromisoformat(client.get(url).json()["finish"]["expected"]).tzinfo is not None
    for _ in range(3):
        finish(database)
    ended = client.get(url).json()
    assert (ended["state"], ended["progress"], ended["finish"]) == ("succeeded", 1, None)
    assert ended["created_at"] <= ended["started_at"] <= ended["finished_at"]
    assert kinds(database) == ["state", "state", *["case"] * 4, "state", "done"]


@pytest.mark.parametrize(("failures", "state"), [(1, "partially_failed"), (4, "failed")])
def test_failed_cases(
    client: httpx.Client, database: Database, study: dict[str, Any], failures: int, state: str
) -> None:
    url = client.post("/v1/studies", json=study).headers["location"]
    failed = [finish(database, fail=n < failures) for n in range(4)][:failures]
    assert client.get(url).json()["state"] == state
    listed = client.get(f"{url}/cases", params={"state": "failed"}).json()["items"]
    assert sorted(case["id"] for case in listed) == sorted(failed)
    assert listed[0]["error"] == {"code": "diverged", "detail": "beyond all bounds"}


def test_cases_computed_before_are_reused(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    client.post("/v1/studies", json=study)
    for _ in range(4):
        finish(database)
    study["sweep"]["speed_kmh"] = [300, 350]
    created = client.post("/v1/studies", json=study).json()
    assert created["cases_reused"] == created["cases"]["succeeded"] == created["cases"]["queued"] == 2
    study["sweep"]["speed_kmh"] = [250]
    whole = client.post("/v1/studies", json=study).json()
    assert (whole["state"], whole["progress"], whole["cases_reused"]) == ("succeeded", 1, 2)
    assert whole["finished_at"] is not None


def test_cases_in_flight_are_shared(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    first = client.post("/v1/studies", json=study).headers["location"]
    with database.write() as session:
        (held,) = claim(session, "test", 15.0, lanes=1)
    second = client.post("/v1/studies", json=study).headers["location"]
    assert count(database, Case) == 4
    with database.write() as session:
        assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=1.0)
    for _ in range(3):
        finish(database)
    assert [client.get(url).json()["state"] for url in (first, second)] == ["succeeded"] * 2
    assert kinds(database).count("done") == 2


def test_studies_sent_at_once_share_their_cases(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda n: client.post("/v1/studies", json=study | {"name": f"{n}"}), range(8)))
    assert [answer.status_code for answer in answers] == [201] * 8
    assert (count(database, Study), count(database, Case)) == (8, 4)


def test_a_case_says_how_its_peaks_were_derived_once_it_has_some(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    client.post("/v1/studies", json=study)
    with database.write() as session:
        (held,) = claim(session, "test", 15.0, lanes=1)
    assert client.get(f"/v1/cases/{held.case_id}").json()["processing"] is None
    record = {"sampling_step_s": 1e-4, "sperling_index": {"band_hz": [0.5, 80.0]}}
    with database.write() as session:
        assert succeed(session, held, peaks=[], processing=record, history=None, cpu_s=1.0)
    assert client.get(f"/v1/cases/{held.case_id}").json()["processing"] == record
    client.post("/v1/studies", json=study | {"keep_history": True})  # to be computed once more
    assert client.get(f"/v1/cases/{held.case_id}").json()["processing"] is None


def test_a_study_that_wants_histories_has_its_cases_computed_once_more(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    client.post("/v1/studies", json=study)
    for _ in range(4):
        finish(database)
    created = client.post("/v1/studies", json=study | {"keep_history": True}).json()
    assert (created["cases"]["queued"], created["cases_reused"]) == (4, 0)


def test_a_higher_priority_is_lent_to_shared_cases(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    client.post("/v1/studies", json=study)
    study["sweep"]["speed_kmh"] = [300]
    urgent = client.post("/v1/studies", json=study | {"priority": 5}).headers["location"]
    finish(database), finish(database)
    assert client.get(urgent).json()["state"] == "succeeded"


def test_idempotency(client: httpx.Client, database: Database, study: dict[str, Any], problem: Check) -> None:
    headers = {"Idempotency-Key": "4 a.m."}
    first = client.post("/v1/studies", json=study, headers=headers)
    finish(database)
    again = client.post("/v1/studies", json=study, headers=headers)
    assert (again.status_code, again.text) == (201, first.text)
    assert again.headers["location"] == first.headers["location"]
    assert count(database, Study) == 1
    other = client.post("/v1/studies", json=study | {"name": "Another"}, headers=headers)
    assert problem(other, 422)["errors"][0]["code"] == "idempotency-key-reused"
    problem(client.post("/v1/studies", json=study, headers={"Idempotency-Key": "x" * 256}), 422)


def test_answers_of_the_version_before_are_recalled(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    headers = {"Idempotency-Key": "before"}
    first = client.post("/v1/studies", json=study, headers=headers)
    with database.write() as session:
        remembered = session.scalars(select(IdempotencyKey)).one()
        remembered.response = {name: value for name, value in remembered.response.items() if name != "owner"}
    assert client.post("/v1/studies", json=study, headers=headers).json() == first.json()


def test_conditional_get(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    url = client.post("/v1/studies", json=study).headers["location"]
    etag = client.get(url).headers["etag"]
    for known in (etag, f'"other", {etag}', f"W/{etag}", "*"):
        unchanged = client.get(url, headers={"If-None-Match": known})
        assert (unchanged.status_code, unchanged.content) == (304, b"")
    finish(database)
    assert client.get(url, headers={"If-None-Match": etag}).status_code == 200


def test_listing(client: httpx.Client, database: Database, study: dict[str, Any]) -> None:
    first = client.post("/v1/studies", json=study | {"name": "100 % Südring"}).json()
    for _ in range(4):
        finish(database)
    study["sweep"]["speed_kmh"] = [400]
    rest = [client.post("/v1/studies", json=study | {"name": name}).json() for name in ("b", "a", "c")]

    def listed(**query: str) -> list[str]:
        return [item["name"] for item in client.get("/v1/studies", params=query).json()["items"]]

    assert listed() == ["c", "a", "b", "100 % Südring"]
    assert listed(sort="name") == ["100 % Südring", "a", "b", "c"]
    assert listed(state="succeeded") == ["100 % Südring"]
    assert listed(state="queued", sort="-name") == ["c", "b", "a"]
    assert listed(name="SÜDRING") == listed(name="% s") == ["100 % Südring"] or database.engine.name == "sqlite"
    assert listed(name="%") == ["100 % Südring"]
    assert listed(created_after=first["created_at"], sort="created_at") == ["b", "a", "c"]
    assert listed(created_after=rest[-1]["created_at"]) == []


@pytest.mark.parametrize("sort", ["created_at", "-created_at", "priority", "-priority", "name"])
def test_pages_of_studies_hold_each_once(client: httpx.Client, study: dict[str, Any], sort: str) -> None:
    ids = [client.post("/v1/studies", json=study | {"priority": n % 2}).json()["id"] for n in range(7)]
    assert sorted(study["id"] for study in walk(client, "/v1/studies", sort=sort, page_size="2")) == sorted(ids)


def test_a_cursor_serves_only_its_own_query(client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    for _ in range(2):
        client.post("/v1/studies", json=study)
    cursor = client.get("/v1/studies?page_size=1").json()["next_cursor"]
    other = client.get("/v1/studies", params={"cursor": cursor, "state": "queued"})
    assert problem(other, 422)["errors"][0]["code"] == "cursor-of-other-query"


def test_cases_come_in_the_order_of_the_sweep(client: httpx.Client, study: dict[str, Any]) -> None:
    study["sweep"]["speed_kmh"] = [300, 250, 275.5]
    url = client.post("/v1/studies", json=study).headers["location"]
    cases = list(walk(client, f"{url}/cases", page_size="2"))
    assert [case["speed_kmh"] for case in cases] == [300, 300, 250, 250, 275.5, 275.5]
    assert [case["amplitude_mm"] for case in cases] == [0.1, 0.3] * 3
    by_speed = list(walk(client, f"{url}/cases", page_size="2", sort="-speed_kmh"))
    assert [case["speed_kmh"] for case in by_speed] == [300, 300, 275.5, 275.5, 250, 250]
    one = client.get(f"/v1/cases/{cases[4]['id']}").json()
    assert {name: one[name] for name in cases[4]} == cases[4]
    assert one["inputs"]["speed_kmh"] == 275.5
    assert one["inputs"]["track"]["pad_stiffness_n_per_m"] == 6e7


def test_health(client: httpx.Client, settings: Settings) -> None:
    assert client.get("/healthz").status_code == client.get("/readyz").status_code == 200


def walk(client: httpx.Client, url: str, **query: str) -> list[dict[str, Any]]:
    """Every item of a list, page by page."""
    items: list[dict[str, Any]] = []
    while True:
        page = client.get(url, params=query).json()
        assert len(page["items"]) <= int(query["page_size"])
        items += page["items"]
        if page["next_cursor"] is None:
            return items
        query["cursor"] = page["next_cursor"]


def count(database: Database, table: type[Study] | type[Case]) -> int:
    with database.read() as session:
        return session.scalar(select(func.count()).select_from(table)) or 0


def kinds(database: Database) -> list[str]:
    with database.read() as session:
        return list(session.scalars(select(Event.kind).order_by(Event.id)))
