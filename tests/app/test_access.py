"""Who may do what, on both databases. The workers here only claim and finish."""

import io
import json
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager, ExitStack
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import httpx
import pyarrow.parquet as pq
import pytest
from sqlalchemy import func, select, update
from typer.testing import CliRunner

from app.access import keys
from app.access.caller import keys_required
from app.access.rates import Rates
from app.db.models import ApiKey, Case, Peak
from app.db.session import Database
from app.settings import Settings
from tests.app.conftest import TLS
from tests.outcomes import succeed
from worker.claim import Claim, claim
from worker.cli import program

Check = Callable[..., dict[str, Any]]
Body = dict[str, Any]
STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
PEAK = {"quantity": "pad_force", "position": "middle", "unit": "N"} | dict.fromkeys(STATISTICS, 1.0)
PROFILE = "x_m,eta_mm\n" + "\n".join(f"{n / 4},{0.1 * (n % 5)}" for n in range(200))
CSV = {"Content-Type": "text/csv"}


@pytest.fixture
def settings(settings: Settings) -> Settings:
    return settings.model_copy(update={"require_keys": "always"})


@pytest.fixture
def make(database: Database, client: httpx.Client) -> Iterator[Callable[..., httpx.Client]]:
    """Makes a key, and gives a client that sends it."""
    clients = []

    def create(name: str, scope: Any = "write", queued: int | None = None, cpu_s: float | None = None) -> httpx.Client:
        with database.write() as session:
            _, secret = keys.create(session, name, scope, queued, cpu_s)
        clients.append(
            httpx.Client(base_url=client.base_url, headers=bearer(secret), trust_env=False, timeout=30, verify=TLS)
        )
        return clients[-1]

    yield create
    for each in clients:
        each.close()


@pytest.fixture
def anna(make: Callable[..., httpx.Client]) -> httpx.Client:
    return make("anna")


@pytest.fixture
def ben(make: Callable[..., httpx.Client]) -> httpx.Client:
    return make("ben")


def bearer(secret: str) -> dict[str, str]:
    return {"Authorization": f"Bearer {secret}"}


def take(database: Database, lanes: int = 1) -> list[Claim]:
    with database.write() as session:
        return claim(session, "test", 15.0, lanes)


def finish(database: Database, cases: int, history: bool = False) -> None:
    for _ in range(cases):
        (held,) = take(database)
        kept = {"key": f"{held.case_id}.npz", "digest": "d" * 64, "size_bytes": 1} if history else None
        with database.write() as session:
            assert succeed(session, held, peaks=[PEAK], processing={}, history=kept, cpu_s=10.0)


def post(client: httpx.Client, study: Body, *speeds: float, **more: Any) -> str:
    answer = client.post("/v1/studies", json=study | {"sweep": study["sweep"] | {"speed_kmh": list(speeds)}} | more)
    assert answer.status_code == 201, answer.text
    return answer.headers["location"]


def speeds_of(database: Database, batch: list[Claim]) -> list[float]:
    with database.read() as session:
        return list(session.scalars(select(Case.speed_kmh).where(Case.id.in_([held.case_id for held in batch]))))


# --- keys and scopes


def test_nobody_comes_in_without_a_valid_key(
    client: httpx.Client, anna: httpx.Client, database: Database, study: Body, problem: Check, capfd: Any
) -> None:
    key_id, secret = anna.headers["authorization"].removeprefix("Bearer ts_").split("_", 1)
    for path in ("/v1/studies", "/v1/peaks", "/v1/limits", "/v1/cases/1", "/v1/studies/x"):
        answer = client.get(path)
        problem(answer, 401, "key-missing")
        assert answer.headers["www-authenticate"] == 'Bearer realm="tracksweep"'
        assert anna.get(path).status_code in (200, 404)
    problem(client.post("/v1/studies", json=study), 401)
    wrong = ("ts_", f"ts_{key_id}_{secret[:-1]}", f"ts_{key_id}_{secret}x", f"ts_{int(key_id) + 1}_{secret}")
    for sent in (*wrong, secret, f"ts_{'9' * 30}_{secret}"):
        answer = client.get("/v1/studies", headers=bearer(sent))
        problem(answer, 401)
        assert answer.headers["www-authenticate"].startswith("Bearer")
    problem(client.get("/v1/studies", headers={"Authorization": "Bearer"}), 401, "key-invalid")
    with database.write() as session:
        keys.revoke(session, "anna")
    problem(anna.get("/v1/studies"), 401, "key-invalid")
    for path in ("/healthz", "/readyz", "/openapi.json"):
        assert client.get(path).status_code == 200
    with database.write() as session:
        _, renewed = keys.renew(session, "anna")
    problem(anna.get("/v1/studies"), 401, "key-invalid")
    assert client.get("/v1/studies", headers=bearer(renewed)).status_code == 200
    with database.read() as session:
        key = session.scalars(select(ApiKey)).one()
        assert key.last_used_at is not None
        assert secret not in str(vars(key))
    logged = "".join(capfd.readouterr())
    assert secret not in logged
    assert renewed not in logged


def test_who_may_no_longer_watch_is_told_nothing_more(
    settings: Settings, serve: Any, database: Database, study: Body, problem: Check
) -> None:
    """A stream that is open when a key is revoked or renewed, or a study shared no more, ends by itself."""
    with serve(settings.model_copy(update={"watch_keep_alive_s": 0.2})) as client:
        with database.write() as session:
            secrets = {name: keys.create(session, name, "write", None, None)[1] for name in ("anna", "ben", "carl")}
        url = client.post("/v1/studies", json=study, headers=bearer(secrets["anna"])).headers["location"]
        for friend in ("ben", "carl"):
            client.put(f"{url}/shares/{friend}", headers=bearer(secrets["anna"]))
        with ExitStack() as stack:
            sent = {name: {"headers": bearer(secret)} for name, secret in secrets.items()}
            streams = {
                name: stack.enter_context(client.stream("GET", f"{url}/events", **each)) for name, each in sent.items()
            }
            lines = {name: stream.iter_lines() for name, stream in streams.items()}
            assert [next(each) for each in lines.values()] == ["event: progress"] * 3
            client.delete(f"{url}/shares/ben", headers=bearer(secrets["anna"]))
            list(lines["ben"])
            with database.write() as session:
                keys.revoke(session, "carl")
            list(lines["carl"])
            with database.write() as session:
                keys.renew(session, "anna")
            list(lines["anna"])
        problem(client.get(f"{url}/events", headers=bearer(secrets["carl"])), 401, "key-invalid")


def test_scopes(make: Callable[..., httpx.Client], study: Body, problem: Check) -> None:
    reader, writer, admin = (make(scope, scope) for scope in ("read", "write", "admin"))
    assert reader.get("/v1/studies").status_code == 200
    problem(reader.post("/v1/studies", json=study), 403, "scope-insufficient")
    url = post(writer, study, 250)
    problem(reader.delete(url), 403, "scope-insufficient")
    problem(writer.post("/v1/studies", json=study | {"priority": 1}), 403, "priority-needs-admin")
    problem(writer.patch(url, json={"priority": 1}, headers={"If-Match": "*"}), 403, "priority-needs-admin")
    assert writer.patch(url, json={"priority": -1}, headers={"If-Match": "*"}).status_code == 200
    assert admin.patch(url, json={"priority": 1}, headers={"If-Match": "*"}).status_code == 200
    assert admin.post(f"{url}/cancel").json()["state"] == "cancelled"
    assert admin.delete(url).status_code == 204


def test_where_no_key_is_required_one_is_honoured_all_the_same(
    settings: Settings, serve: Any, database: Database, study: Body, problem: Check
) -> None:
    with database.write() as session:
        _, secret = keys.create(session, "anna", "read", None, None)
    with serve(settings.model_copy(update={"require_keys": "auto"})) as client:
        url = post(client, study, 250)
        assert client.get(url).status_code == 200
        problem(client.get(url, headers=bearer("ts_1_wrong")), 401, "key-invalid")
        problem(client.get(url, headers=bearer(secret)), 404)
        assert client.get(url, headers={"Authorization": "Basic eA=="}).status_code == 200


@pytest.mark.parametrize(
    ("host", "came_in_by", "required"),
    [
        ("127.0.0.1", "127.0.0.1", False),
        ("localhost", "::1", False),
        ("127.0.0.1", "192.0.2.7", True),  # another server runs the application
        ("0.0.0.0", "127.0.0.1", True),
        ("::", "::1", True),
        ("192.0.2.7", "192.0.2.7", True),
        ("127.0.0.1", "/run/socket", True),
    ],
)
def test_keys_are_required_beyond_the_loopback(host: str, came_in_by: str, required: bool) -> None:
    request: Any = SimpleNamespace(scope={"server": (came_in_by, 80)})
    assert keys_required(Settings(host=host), request) is required
    assert keys_required(Settings(host=host, require_keys="always"), request)
    assert not keys_required(Settings(host=host, require_keys="never"), request)


def test_a_service_without_keys_says_what_to_do(
    settings: Settings, serve: Any, database: Database, capfd: pytest.CaptureFixture[str]
) -> None:
    with serve(settings):
        pass
    assert "tracksweep keys create" in capfd.readouterr().err
    with database.write() as session:
        keys.create(session, "anna", "read", None, None)
    with serve(settings):
        pass
    assert "tracksweep keys create" not in capfd.readouterr().err


# --- what is seen


@pytest.fixture
def annas(anna: httpx.Client, database: Database, study: Body) -> dict[str, Any]:
    """A study over a profile, computed and verified; the parameters of paths."""
    profile_id = anna.post("/v1/profiles", content=PROFILE, headers=CSV).json()["id"]
    measured = {
        "kind": "product",
        "speed_kmh": [250, 300],
        "irregularity": {"kind": "measured", "profile_id": profile_id},
    }
    url = anna.post("/v1/studies", json=study | {"sweep": measured, "keep_history": True}).headers["location"]
    finish(database, 2, history=True)
    case_id = anna.get(f"{url}/cases").json()["items"][0]["id"]
    assert anna.post(f"/v1/cases/{case_id}/verification").status_code == 202
    return {"study_id": url.rpartition("/")[2], "case_id": case_id, "profile_id": profile_id}


def reads(client: httpx.Client, values: dict[str, Any]) -> Iterator[tuple[str, bool]]:
    """Every GET operation, and whether it is about something."""
    for path, operations in client.get("/openapi.json").json()["paths"].items():
        if "get" in operations:
            yield path.format(**values), "{" in path


CATALOGUE = {f"/v1/{name}" for name in ("quantities", "spectra", "tracks", "vehicles", "presets", "limits")}
QUEUE = "/v1/queue"


def test_others_see_nothing_whatever_they_read(
    anna: httpx.Client, ben: httpx.Client, annas: dict[str, Any], problem: Check
) -> None:
    looked_at = 0
    for path, about_something in reads(anna, annas):
        own, others = anna.get(path), ben.get(path)
        assert own.status_code not in (401, 403, 404, 500), path
        looked_at += about_something
        if about_something:
            assert problem(others, 404, "not-found")["detail"].startswith("There is no such"), path
        elif path.endswith(".csv"):
            assert own.text.count("\n") == 3
            assert others.text.count("\n") == 1
        elif path.endswith(".parquet"):
            assert pq.read_table(io.BytesIO(own.content)).num_rows == 2
            assert pq.read_table(io.BytesIO(others.content)).num_rows == 0
        elif path == QUEUE:
            assert not any(worker["cases"] for worker in others.json()["workers"])
        elif path not in CATALOGUE:
            assert own.json()["items"], path
            assert others.json() == {"items": [], "next_cursor": None}, path
    assert looked_at >= 12
    query = {"study_id": annas["study_id"]}
    assert ben.get("/v1/peaks", params=query).json()["items"] == []
    assert ben.get("/v1/studies", params={"state": "succeeded"}).json()["items"] == []
    limits = ben.get("/v1/limits").json()["caller"]
    assert (limits["key"], limits["queued_cases"], limits["cpu_s_last_day"]) == ("ben", 0, 0)
    assert anna.get("/v1/limits").json()["caller"]["cpu_s_last_day"] == 20


def test_others_change_nothing(anna: httpx.Client, ben: httpx.Client, annas: dict[str, Any], problem: Check) -> None:
    bodies = {"patch": {"name": "mine"}}
    for path, operations in anna.get("/openapi.json").json()["paths"].items():
        for method in operations.keys() - {"get"}:
            if "{" in path:
                url = path.format(**annas, key_name="ben")
                problem(ben.request(method, url, json=bodies.get(method), headers={"If-Match": "*"}), 404)
    assert anna.get(f"/v1/studies/{annas['study_id']}").json()["name"] == "A study"


def test_a_study_is_shared_to_be_read(
    anna: httpx.Client, ben: httpx.Client, make: Callable[..., httpx.Client], annas: dict[str, Any], problem: Check
) -> None:
    url = f"/v1/studies/{annas['study_id']}"
    problem(anna.put(f"{url}/shares/nobody"), 404)
    for _ in range(2):
        assert anna.put(f"{url}/shares/ben").status_code == 204
    assert anna.get(f"{url}/shares").json() == {"items": [{"key": "ben"}]}
    assert ben.get(url).json()["owner"] == ben.get("/v1/studies").json()["items"][0]["owner"] == "anna"
    for path, _ in reads(anna, annas):
        if path == f"{url}/shares":
            problem(ben.get(path), 403, "not-owner")
        elif path not in CATALOGUE:
            assert ben.get(path).status_code == anna.get(path).status_code, path
    assert ben.get("/v1/peaks").json() == anna.get("/v1/peaks").json()
    problem(ben.delete(url), 403, "not-owner")
    problem(ben.put(f"{url}/shares/ben"), 403, "not-owner")
    problem(make("carl").get(url), 404)
    for _ in range(2):
        assert anna.delete(f"{url}/shares/ben").status_code == 204
    problem(ben.get(url), 404)


def test_studies_without_an_owner_are_the_administrators(
    settings: Settings, serve: Any, make: Callable[..., httpx.Client], ben: httpx.Client, study: Body, problem: Check
) -> None:
    with serve(settings.model_copy(update={"require_keys": "never"})) as open_client:
        url = post(open_client, study, 250)
    problem(ben.get(url), 404)
    admin = make("admin", "admin")
    assert admin.put(f"{url}/shares/ben").status_code == 204
    assert ben.get(url).status_code == 200


def test_overlapping_studies_share_cases_and_nothing_else(
    anna: httpx.Client, ben: httpx.Client, database: Database, study: Body, problem: Check
) -> None:
    with ThreadPoolExecutor(2) as pool:  # at once
        sent = pool.submit(post, anna, study, 250, 300, keep_history=True), pool.submit(post, ben, study, 300, 350)
    first, second = (each.result() for each in sent)
    finish(database, 6, history=True)  # of eight that were asked for
    assert take(database) == []
    cases = {each.get(url).json()["cases"]["succeeded"] for each, url in ((anna, first), (ben, second))}
    assert cases == {4}
    assert {row["speed_kmh"] for row in anna.get("/v1/peaks").json()["items"]} == {250, 300}
    before = ben.get("/v1/peaks").json()
    assert {row["speed_kmh"] for row in before["items"]} == {300, 350}
    assert anna.delete(first).status_code == 204
    assert anna.get("/v1/peaks").json()["items"] == []
    assert ben.get("/v1/peaks").json() == before
    assert ben.get(second).json()["state"] == "succeeded"
    known = ben.post("/v1/study-estimates", json=study).json()["cases"]
    assert (known["computed"], known["new"]) == (4, 0)  # also those of the study that was another's
    third = ben.get(post(ben, study, 250)).json()
    assert (third["state"], third["cases_reused"]) == ("succeeded", 2)
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Peak)) == 6


def test_two_may_use_one_idempotency_key(anna: httpx.Client, ben: httpx.Client, study: Body, problem: Check) -> None:
    headers = {"Idempotency-Key": "monday"}
    first, again = (anna.post("/v1/studies", json=study, headers=headers).json() for _ in range(2))
    other = ben.post("/v1/studies", json=study | {"name": "another"}, headers=headers)
    assert first["id"] == again["id"]
    assert other.status_code == 201
    problem(anna.get(other.headers["location"]), 404)


def test_profiles(
    anna: httpx.Client, ben: httpx.Client, annas: dict[str, Any], database: Database, study: Body, problem: Check
) -> None:
    profile = f"/v1/profiles/{annas['profile_id']}"
    over_it = {
        "kind": "product",
        "speed_kmh": [250],
        "irregularity": {"kind": "measured", "profile_id": annas["profile_id"]},
    }
    problem(ben.post("/v1/studies", json=study | {"sweep": over_it}), 422)
    problem(ben.post("/v1/study-estimates", json=study | {"sweep": over_it}), 422)
    assert ben.post("/v1/profiles", content=PROFILE, headers=CSV).status_code == 201
    assert ben.get(profile).status_code == 200
    assert ben.delete(profile).status_code == 204  # which is in use by another, and ben is not told
    problem(ben.get(profile), 404)
    assert anna.get(profile).status_code == 200
    problem(anna.delete(profile), 409)
    assert anna.delete(f"/v1/studies/{annas['study_id']}").status_code == 204
    assert anna.delete(profile).status_code == 204
    assert ben.post("/v1/profiles", content=PROFILE, headers=CSV).status_code == 201


# --- how much


def test_queued_cases_have_a_quota(
    make: Callable[..., httpx.Client], ben: httpx.Client, database: Database, study: Body, problem: Check
) -> None:
    small = make("small", queued=4)
    post(ben, study, 100, 150)  # of others, which counts for them also when shared
    url = post(small, study, 100, 200)
    assert small.get("/v1/limits").json()["caller"]["queued_cases"] == 2
    answer = small.post("/v1/studies", json=study | {"sweep": study["sweep"] | {"speed_kmh": [300, 350]}})
    assert "it may have 4" in problem(answer, 429, "quota-exceeded")["detail"]
    assert int(answer.headers["retry-after"]) > 0
    assert len(small.get("/v1/studies").json()["items"]) == 1
    post(small, study, 300)
    assert small.get("/v1/limits").json()["caller"]["queued_cases"] == 4
    post(small, study, 200, 300)  # nothing new
    small.post(f"{url}/cancel")
    with database.write() as session:
        session.execute(update(ApiKey).where(ApiKey.name == "small").values(max_queued_cases=1))
    for each in small.get("/v1/studies").json()["items"]:
        small.post(f"/v1/studies/{each['id']}/cancel")
    problem(small.post(f"{url}/retry"), 429, "quota-exceeded")
    assert small.get(url).json()["state"] == "cancelled"


def test_processor_time_has_a_quota(
    make: Callable[..., httpx.Client], ben: httpx.Client, database: Database, study: Body, problem: Check
) -> None:
    frugal = make("frugal", cpu_s=35.0)
    url = post(frugal, study, 250, 300)
    post(ben, study, 250, 300, 350)
    finish(database, 6)
    assert frugal.get("/v1/limits").json()["caller"]["cpu_s_last_day"] == 40
    assert ben.get("/v1/limits").json()["caller"]["cpu_s_last_day"] == 20
    answer = frugal.post("/v1/studies", json=study | {"sweep": study["sweep"] | {"speed_kmh": [400]}})
    problem(answer, 429, "quota-exceeded")
    assert 86_000 < int(answer.headers["retry-after"]) <= 86_400
    case_id = frugal.get(f"{url}/cases").json()["items"][0]["id"]
    problem(frugal.post(f"/v1/cases/{case_id}/verification"), 429, "quota-exceeded")
    post(frugal, study, 350)  # is computed already
    assert frugal.delete(url).status_code == 204
    assert frugal.get("/v1/limits").json()["caller"]["cpu_s_last_day"] == 40
    yesterday = update(Case).where(Case.speed_kmh == 250).values(finished_at=Case.finished_at - 86_400)
    with database.write() as session:
        session.execute(yesterday)
    assert frugal.get("/v1/limits").json()["caller"]["cpu_s_last_day"] == 20
    post(frugal, study, 400)


def test_requests_are_counted(settings: Settings, serve: Any, database: Database, study: Body, problem: Check) -> None:
    with database.write() as session:
        secrets = [keys.create(session, name, "write", None, None)[1] for name in ("anna", "ben")]
    limited = settings.model_copy(update={"reads_per_minute": 3, "writes_per_minute": 1})
    with serve(limited) as client:
        for left in (2, 1, 0):
            answer = client.get("/v1/peaks.csv", headers=bearer(secrets[0]))
            assert answer.status_code == 200
            assert answer.headers["ratelimit-policy"] == '"reads";q=3;w=60'
            policy, remaining, reset = answer.headers["ratelimit"].split(";")
            assert (policy, remaining) == ('"reads"', f"r={left}")
            assert 1 <= int(reset.removeprefix("t=")) <= 60
        answer = client.head("/v1/studies", headers=bearer(secrets[0]))
        assert answer.status_code == 429
        answer = client.get("/v1/studies", headers=bearer(secrets[0]))
        problem(answer, 429, "rate-limited")
        assert 1 <= int(answer.headers["retry-after"]) <= 60
        assert client.get("/v1/studies", headers=bearer(secrets[1])).status_code == 200
        assert client.post("/v1/studies", json=study, headers=bearer(secrets[0])).status_code == 201
        problem(client.post("/v1/studies", json=study, headers=bearer(secrets[0])), 429)
        codes = [client.get("/v1/studies", headers=bearer("ts_1_guess")).status_code for _ in range(4)]
        assert codes == [401, 401, 401, 429]
        assert [client.get("/healthz").status_code for _ in range(5)] == [200] * 5


def test_requests_are_counted_across_processes_and_without_a_broker(tmp_path: Path, broker_tcp: str) -> None:
    settings = Settings(data_dir=tmp_path, broker_url=broker_tcp, reads_per_minute=2)
    one, other = Rates(settings), Rates(settings)
    rates = [each.hit("reads", "key 1") for each in (one, other, one)]
    assert [rate and (rate.left, rate.allowed) for rate in rates] == [(1, True), (0, True), (0, False)]
    away = Rates(settings.model_copy(update={"broker_url": "redis://127.0.0.1:1/0"}))
    rates = [away.hit("reads", "key 1") for _ in range(3)]
    assert [rate and rate.allowed for rate in rates] == [True, True, False]


# --- turns


def test_a_newcomer_is_next_though_another_queued_many(
    anna: httpx.Client, ben: httpx.Client, database: Database, study: Body
) -> None:
    one = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.1]}
    study = study | {"sweep": study["sweep"] | {"irregularity": one}}
    for n in range(4):  # many studies give nobody more turns
        post(anna, study, *range(100 + 10 * n, 110 + 10 * n))
    assert [speeds_of(database, take(database)) for _ in range(3)] == [[100], [101], [102]]
    post(ben, study, 300, 301)
    assert [speeds_of(database, take(database)) for _ in range(5)] == [[300], [301], [103], [104], [105]]
    post(ben, study, 302, 303, 304)
    turns = [speeds_of(database, take(database))[0] for _ in range(6)]
    assert sorted(turns) == [106, 107, 108, 302, 303, 304]


def test_who_comes_back_again_and_again_does_not_starve_others(
    anna: httpx.Client, ben: httpx.Client, make: Callable[..., httpx.Client], database: Database, study: Body
) -> None:
    one = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.1]}
    study = study | {"sweep": study["sweep"] | {"irregularity": one}}
    carl = make("carl")
    post(anna, study, *range(100, 120))
    finish(database, 1)
    post(ben, study, 200)
    annas = 0
    for n in range(1, 13):
        (held,) = take(database)
        post(carl if n % 2 else ben, study, 200 + n)  # while the other's case runs
        annas += speeds_of(database, [held])[0] < 200
        with database.write() as session:
            assert succeed(session, held, peaks=[PEAK], processing={}, history=None, cpu_s=1.0)
    assert annas >= 3


def test_keys_made_at_once(database: Database) -> None:
    def create(n: int) -> str:
        with database.write() as session:
            return keys.create(session, f"key-{n}", "read", None, None)[1]

    with ThreadPoolExecutor(4) as pool:
        secrets = list(pool.map(create, range(8)))
    assert len(set(secrets)) == 8
    found = [keys.authenticate(database, secret) for secret in secrets]
    assert [each and each.name for each in found] == [f"key-{n}" for n in range(8)]


# --- the command line


def test_the_commands(
    settings: Settings, database: Database, serve: Callable[..., AbstractContextManager[Any]]
) -> None:
    environment = {"TRACKSWEEP_DATABASE_URL": settings.database_url, "COLUMNS": "200"}

    def run(*arguments: str, code: int = 0) -> str:
        result = CliRunner().invoke(program, ["keys", *arguments], env=environment)
        assert result.exit_code == code, result.output
        return result.stdout

    created = run("create", "anna", "--scope", "write", "--max-queued-cases", "10").strip()
    assert created.startswith("ts_")
    with serve(settings) as client:
        assert client.get("/v1/limits", headers=bearer(created)).json()["caller"]["max_queued_cases"] == 10
        renewed = json.loads(run("renew", "anna", "--json"))["key"]
        assert client.get("/v1/studies", headers=bearer(created)).status_code == 401
        assert client.get("/v1/studies", headers=bearer(renewed)).status_code == 200
        run("revoke", "anna")
        assert client.get("/v1/studies", headers=bearer(renewed)).status_code == 401
    (listed,) = json.loads(run("list", "--json"))
    assert (listed["name"], listed["scope"], listed["max_queued_cases"]) == ("anna", "write", 10)
    assert listed["revoked_at"] is not None
    assert "anna" in run("list")
    assert renewed not in run("list") + run("list", "--json")
    run("create", "anna", "--scope", "read", code=2)
    run("create", "no spaces", "--scope", "read", code=2)
    run("create", "ben", "--scope", "everything", code=2)
    run("revoke", "ben", code=2)
