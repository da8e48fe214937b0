"""Studies changed, cancelled, retried and deleted, on both databases. The workers here only claim and finish."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import Any

import httpx
import pytest
from sqlalchemy import func, select

from app.cases import queue
from app.db.models import Case, Event, History, Peak, Study, StudyCase
from app.db.session import Database
from app.settings import Settings
from tests import outcomes
from worker import lease
from worker.claim import Claim, claim

Check = Callable[..., dict[str, Any]]
Body = dict[str, Any]
STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
PEAK = {"quantity": "pad_force", "position": "middle", "unit": "N"} | dict.fromkeys(STATISTICS, 1.0)


def take(database: Database, lanes: int = 1) -> list[Claim]:
    with database.write() as session:
        return claim(session, "test", 15.0, lanes)


def succeed(database: Database, held: Claim, history: bool = False) -> bool:
    kept = {"key": f"{held.case_id}.npz", "digest": "d" * 64, "size_bytes": 1} if history else None
    with database.write() as session:
        return outcomes.succeed(session, held, peaks=[PEAK], processing={}, history=kept, cpu_s=1.0)


def finish(database: Database, cases: int, *, fail: bool = False, history: bool = False) -> None:
    for _ in range(cases):
        (held,) = take(database)
        if not fail:
            assert succeed(database, held, history)
            continue
        with database.write() as session:
            assert lease.fail(session, held, "diverged", "beyond all bounds")


def counts(client: httpx.Client, url: str) -> dict[str, int]:
    return {state: n for state, n in client.get(url).json()["cases"].items() if n and state != "total"}


def events(database: Database, url: str) -> list[str]:
    with database.read() as session:
        of_study = select(Event).where(Event.study_id == url.rpartition("/")[2]).order_by(Event.id)
        return [e.payload["state"] if e.kind == "state" else e.kind for e in session.scalars(of_study)]


def post(client: httpx.Client, study: Body, *speeds: float, **more: Any) -> str:
    sweep = study["sweep"] | ({"speed_kmh": list(speeds)} if speeds else {})
    answer = client.post("/v1/studies", json=study | {"sweep": sweep} | more)
    assert answer.status_code == 201, answer.text
    return answer.headers["location"]


# --- cancel


def test_a_queued_study_is_cancelled_at_once_and_its_cases_are_never_computed(
    client: httpx.Client, database: Database, study: Body
) -> None:
    url = post(client, study)
    answers = [client.post(f"{url}/cancel") for _ in range(2)]
    assert [answer.status_code for answer in answers] == [200, 200]
    assert answers[0].json() == answers[1].json() == client.get(url).json()
    cancelled = answers[0].json()
    assert (cancelled["state"], cancelled["finish"]) == ("cancelled", None)
    assert cancelled["finished_at"] is not None
    assert counts(client, url) == {"cancelled": 4}
    assert take(database) == []
    assert events(database, url) == ["queued", "cancelled", "done"]


def test_a_running_case_loses_its_lease_and_its_worker_writes_nothing(
    client: httpx.Client, database: Database, study: Body
) -> None:
    url = post(client, study)
    (held,) = take(database)
    assert client.post(f"{url}/cancel").json()["state"] == "cancelled"
    with database.write() as session:
        assert not lease.extend(session, [held], 15.0, {held.case_id: 0.5})
        assert not lease.give_up(session, held, 3, "late")
        assert not lease.release(session, held)
    assert not succeed(database, held)
    assert counts(client, url) == {"cancelled": 4}
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Peak)) == 0
    assert events(database, url) == ["queued", "running", "cancelled", "done"]


def test_shared_cases_go_on_for_the_others(client: httpx.Client, database: Database, study: Body) -> None:
    urgent = post(client, study, 250, 300, priority=7)
    other = post(client, study, 300, 350)
    held = take(database)[0], take(database)[0], take(database)[0]  # the third is shared
    assert client.post(f"{urgent}/cancel").json()["state"] == "cancelled"
    assert counts(client, urgent) == {"running": 1, "queued": 1, "cancelled": 2}
    assert [succeed(database, each) for each in held] == [False, False, True]
    with database.read() as session:
        assert set(session.scalars(select(Case.priority).where(Case.state == "queued"))) == {0}
    finish(database, 3)
    assert client.get(other).json()["state"] == "succeeded"
    assert client.get(urgent).json()["state"] == "cancelled"
    assert events(database, urgent) == ["queued", "running", "cancelled", "done"]
    assert events(database, other) == ["queued", "running", *4 * ["case"], "succeeded", "done"]


def test_what_has_ended_is_not_cancelled(client: httpx.Client, database: Database, study: Body) -> None:
    url = post(client, study)
    finish(database, 4)
    ended = client.get(url).json()
    assert client.post(f"{url}/cancel").json() == ended
    assert ended["state"] == "succeeded"


def test_a_new_study_revives_what_another_cancelled(client: httpx.Client, database: Database, study: Body) -> None:
    first = post(client, study)
    client.post(f"{first}/cancel")
    second = post(client, study)
    finish(database, 4)
    assert [client.get(url).json()["state"] for url in (first, second)] == ["cancelled", "succeeded"]
    assert events(database, first)[-1] == "done"


def test_the_last_of_several_studies_takes_the_cases_along(
    client: httpx.Client, database: Database, study: Body
) -> None:
    urls = [post(client, study) for _ in range(2)]
    for url in urls:
        assert client.post(f"{url}/cancel").json()["state"] == "cancelled"
    assert counts(client, urls[0]) == {"cancelled": 4}
    assert take(database) == []


def test_cancelling_and_creating_at_once(client: httpx.Client, database: Database, study: Body) -> None:
    """Whoever comes first: the case is computed for the one that still wants it, and only then."""
    for n in range(8):
        first = post(client, study, 100 + n)
        with ThreadPoolExecutor(2) as pool:
            jobs = [
                pool.submit(client.post, f"{first}/cancel"),
                pool.submit(post, client, study, 100 + n, name="other"),
            ]
            second = jobs[1].result()
        assert jobs[0].result().json()["state"] == "cancelled"
        finish(database, 2)
        assert client.get(second).json()["state"] == "succeeded"
        assert take(database) == []


# --- retry


def test_failed_cases_are_tried_again(client: httpx.Client, database: Database, study: Body) -> None:
    url = post(client, study)
    finish(database, 1)
    finish(database, 3, fail=True)
    assert client.get(url).json()["state"] == "partially_failed"
    answers = [client.post(f"{url}/retry").json() | {"finish": None} for _ in range(2)]
    assert answers[0] == answers[1]
    assert (answers[0]["state"], answers[0]["finished_at"]) == ("running", None)
    assert counts(client, url) == {"succeeded": 1, "queued": 3}
    finish(database, 3)
    assert client.get(url).json()["state"] == "succeeded"
    end = ["partially_failed", "done", "running", *3 * ["case"], "succeeded", "done"]
    assert events(database, url) == ["queued", "running", *4 * ["case"], *end]
    assert client.post(f"{url}/retry").json()["state"] == "succeeded"
    assert events(database, url)[-8:] == end


def test_a_cancelled_study_lives_again(client: httpx.Client, database: Database, study: Body) -> None:
    url = post(client, study, priority=3)
    shared = post(client, study, 300)
    (late,) = take(database)
    finish(database, 1)
    client.post(f"{url}/cancel")
    retried = client.post(f"{url}/retry").json()
    assert retried["state"] == "running"
    assert not succeed(database, late)
    with database.read() as session:
        assert set(session.scalars(select(Case.priority))) == {3}
    finish(database, 3)
    assert [client.get(each).json()["state"] for each in (url, shared)] == ["succeeded"] * 2


def test_a_cancelled_study_of_which_others_computed_everything(
    client: httpx.Client, database: Database, study: Body
) -> None:
    url, _ = post(client, study), post(client, study)
    client.post(f"{url}/cancel")
    finish(database, 4)
    assert client.get(url).json()["state"] == "cancelled"
    assert client.post(f"{url}/retry").json()["state"] == "succeeded"
    assert events(database, url)[-2:] == ["succeeded", "done"]


# --- delete


@pytest.mark.parametrize("begun", [False, True])
def test_only_what_has_ended_can_be_deleted(
    client: httpx.Client, database: Database, study: Body, problem: Check, begun: bool
) -> None:
    url = post(client, study)
    if begun:
        take(database)
    problem(client.delete(url), 409, "study-not-ended")
    client.post(f"{url}/cancel")
    deleted = client.delete(url)
    assert (deleted.status_code, deleted.content) == (204, b"")
    problem(client.get(url), 404)
    problem(client.delete(url), 404)
    with database.read() as session:
        for table in (Study, StudyCase, Case, Event):
            assert session.scalar(select(func.count()).select_from(table)) == 0


def test_results_outlive_their_study_and_histories_do_not(
    client: httpx.Client, database: Database, study: Body
) -> None:
    url = post(client, study, 250, 300, keep_history=True)
    keeper = post(client, study, 300, keep_history=True)
    finish(database, 1, fail=True)
    finish(database, 3, history=True)
    assert client.delete(url).status_code == 204
    assert client.get(keeper).json()["state"] == "succeeded"
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(History)) == 2
        assert set(session.scalars(select(Case.state))) == {"succeeded"}
    assert len(client.get("/v1/peaks").json()["items"]) == 3
    again = client.post("/v1/studies", json=study).json()
    assert (again["cases_reused"], again["cases"]["queued"]) == (3, 1)


# --- change


def etag(client: httpx.Client, url: str) -> dict[str, str]:
    return {"If-Match": client.get(url).headers["etag"]}


def test_name_labels_and_priority_can_be_changed(client: httpx.Client, database: Database, study: Body) -> None:
    url = post(client, study, labels={"line": "A", "year": "2026"})
    known = etag(client, url)
    finish(database, 1)  # progress is no edit
    patch = {"name": "Another", "labels": {"line": None, "weather": "dry"}, "priority": 4}
    changed = client.patch(url, json=patch, headers=known | {"Content-Type": "application/merge-patch+json"})
    assert changed.status_code == 200
    stored = changed.json() | {"finish": None}
    assert stored == client.get(url).json() | {"finish": None}
    assert stored["name"] == "Another"
    assert stored["labels"] == {"year": "2026", "weather": "dry"}
    assert stored["priority"] == 4
    assert client.patch(url, json={}, headers={"If-Match": changed.headers["etag"]}).status_code == 200
    assert client.get(url).json() | {"finish": None} == stored


def test_nobody_overwrites_what_he_has_not_seen(client: httpx.Client, study: Body, problem: Check) -> None:
    url = post(client, study)
    known = etag(client, url)
    assert client.patch(url, json={"name": "First"}, headers=known).status_code == 200
    problem(client.patch(url, json={"name": "Second"}, headers=known), 412, "changed-meanwhile")
    weak = {"If-Match": f"W/{etag(client, url)['If-Match']}"}
    problem(client.patch(url, json={"name": "Second"}, headers=weak), 412)
    problem(client.patch(url, json={"name": "Second"}), 428, "if-match-missing")
    assert client.get(url).json()["name"] == "First"
    several = {"If-Match": f'"other", {etag(client, url)["If-Match"]}'}
    assert client.patch(url, json={"name": "Second"}, headers=several).status_code == 200
    assert client.patch(url, json={"name": "Third"}, headers={"If-Match": "*"}).status_code == 200
    problem(client.patch(f"/v1/studies/{'0' * 32}", json={}, headers={"If-Match": "*"}), 404)


@pytest.mark.parametrize(
    ("patch", "pointer"),
    [
        ({"name": None}, "/name"),
        ({"name": ""}, "/name"),
        ({"priority": 101}, "/priority"),
        ({"priority": "1"}, "/priority"),
        ({"labels": None}, "/labels"),
        ({"labels": {"": "x"}}, "/labels/"),
        ({"labels": {f"{n}": "x" for n in range(65)}}, "/labels"),
        ({"state": "cancelled"}, "/state"),
    ],
)
def test_wrong_changes(client: httpx.Client, study: Body, problem: Check, patch: Body, pointer: str) -> None:
    url = post(client, study)
    details = problem(client.patch(url, json=patch, headers={"If-Match": "*"}), 422)
    assert [error["pointer"] for error in details["errors"]] == [pointer]


def test_the_highest_priority_wins(client: httpx.Client, database: Database, study: Body) -> None:
    one, two = post(client, study, 250, 300, priority=1), post(client, study, 300, 350, priority=2)
    for url, priority, expected in [
        (one, 3, {250: 3, 300: 3, 350: 2}),
        (one, 0, {250: 0, 300: 2, 350: 2}),
        (two, -5, {250: 0, 300: 0, 350: -5}),
    ]:
        assert client.patch(url, json={"priority": priority}, headers={"If-Match": "*"}).status_code == 200
        with database.read() as session:
            assert {row.speed_kmh: row.priority for row in session.scalars(select(Case))} == expected


# --- verification


def test_a_verification_is_asked_for_and_read(
    client: httpx.Client, database: Database, study: Body, problem: Check
) -> None:
    post(client, study)
    problem(client.post("/v1/cases/1/verification"), 409, "case-not-succeeded")
    problem(client.post("/v1/cases/99/verification"), 404)
    problem(client.get("/v1/cases/1/verification"), 404)
    finish(database, 4)
    asked = client.post("/v1/cases/1/verification")
    assert asked.status_code == 202
    assert (asked.json()["state"], asked.json()["outcome"]) == ("queued", None)
    assert client.get("/v1/cases/1/verification").json() == asked.json()


# --- many at once


def create(client: httpx.Client, study: Body) -> httpx.Response:
    return client.post("/v1/studies", json=study, headers={"Idempotency-Key": "k"})


def test_fifty_requests_with_one_key_make_one_study(
    client: httpx.Client, database: Database, study: Body, problem: Check
) -> None:
    with ThreadPoolExecutor(50) as pool:
        answers = list(pool.map(lambda _: create(client, study), range(50)))
    (first,) = {answer.text for answer in answers if answer.status_code == 201}
    for answer in answers:
        assert answer.status_code == 201 or problem(answer, 409, "idempotency-key-in-progress")
    assert create(client, study).text == first
    problem(create(client, study | {"name": "Another"}), 422)
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Study)) == 1


def test_who_comes_while_the_first_is_in_progress_is_told_so(
    client: httpx.Client, settings: Settings, serve: Any, database: Database, study: Body, problem: Check
) -> None:
    """By another process, too, where the database serves several."""
    with serve(settings) as other, ThreadPoolExecutor(2) as pool:
        with database.write() as session:
            session.connection()  # on SQLite nobody else writes from here on, and on PostgreSQL from here:
            queue.one_at_a_time(session)
            servers = client, client if database.engine.name == "sqlite" else other
            sent = [pool.submit(create, each, study) for each in servers]
            refused = next(as_completed(sent)).result()
            problem(refused, 409, "idempotency-key-in-progress")
            assert int(refused.headers["Retry-After"]) > 0
        (first,) = {text for each in sent if (text := each.result().text) != refused.text}
    assert create(client, study).text == first
