"""What operators are shown: metrics, health and the log of requests."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import pytest
import yaml
from prometheus_client.parser import text_string_to_metric_families
from sqlalchemy import text, update

import migrations
from app.access import keys
from app.db import tally
from app.db.models import SCHEMA, Case
from app.db.session import Database
from app.db.types import Clock
from app.settings import Settings
from tests.conftest import free_port
from tests.outcomes import succeed
from worker import lease, presence
from worker.claim import claim

ROOT = Path(__file__).parents[2]

Check = Callable[..., dict[str, Any]]


def scrape(client: httpx.Client, **headers: str) -> dict[tuple[str, ...], float]:
    """Samples by name and label values."""
    answer = client.get("/metrics", headers=headers)
    assert answer.status_code == 200
    assert answer.headers["content-type"].startswith("text/plain; version=")
    families = list(text_string_to_metric_families(answer.text))
    assert len({family.name for family in families}) == len(families)
    return {
        (sample.name.removeprefix("tracksweep_"), *sample.labels.values()): sample.value
        for family in families
        for sample in family.samples
    }


def test_the_life_of_cases_is_counted(client: httpx.Client, study: dict[str, Any], database: Database) -> None:
    before = scrape(client)
    assert before["cases", "queued"] == before["cases_ended_total", "succeeded"] == before["workers",] == 0
    first = client.post("/v1/studies", json=study).json()["id"]
    with database.write() as session:
        presence.announce(session, "here:1", 60.0)
        done, slow, silent = (claim(session, "here:1", 60.0, lanes=1)[0] for _ in range(3))
    with database.write() as session:
        assert succeed(session, done, peaks=[], processing={}, history=None, cpu_s=1.5, simulated_s=4.0)
        assert lease.give_up(session, slow, 1, "it took too long", "time-limit")
        session.execute(update(Case).where(Case.id == silent.case_id).values(heartbeat_at=Clock() - 100))
    found = scrape(client)
    assert (found["cases", "queued"], found["cases", "running"], found["workers",]) == (1, 1, 1)
    assert (found["cases_ended_total", "succeeded"], found["cases_ended_total", "failed"]) == (1, 1)
    assert found["attempts_given_up_total", "time-limit"] == 1
    assert (found["solver_cpu_seconds_total",], found["simulated_seconds_total",]) == (1.5, 4.0)
    assert (found["lanes_total", "yes"], found["lanes_total", "no"]) == (3, 0)
    assert 100 <= found["lease_age_seconds",] < 200
    client.post(f"/v1/studies/{first}/cancel")
    client.post("/v1/studies", json=study)
    found = scrape(client)
    assert found["cases_ended_total", "cancelled"] == 2
    assert (found["cases_requested_total", "queued"], found["cases_requested_total", "reused"]) == (6, 1)
    assert 0 < found["queue_oldest_seconds",] < 600
    assert abs(found["clock_offset_seconds",]) < 60
    assert 0 < found["disk_free_bytes", "data"] < found["disk_size_bytes", "data"]


def test_what_is_not_committed_is_not_counted(database: Database) -> None:
    def fail() -> None:
        with database.write() as session:
            tally.count(session, "lanes", "yes", 3)
            raise RuntimeError

    with pytest.raises(RuntimeError):
        fail()
    for _ in range(2):
        with database.write() as session:
            tally.count(session, "lanes", "yes", 2)
            tally.count(session, "lanes", "no")
            tally.count(session, "lanes", "yes")
    with database.read() as session:
        assert tally.read(session) == {("lanes", "yes"): 6.0, ("lanes", "no"): 2.0}


def test_requests_are_counted_by_route(client: httpx.Client) -> None:
    for path in ("/v1/studies", f"/v1/studies/{'0' * 32}", f"/v1/studies/{'1' * 32}", "/nothing", "/../etc", "/v1"):
        client.get(path)
    client.request("BREW", "/v1/studies")
    found = scrape(client)
    assert found["http_requests_total", "GET", "/v1/studies", "200"] == 1
    assert found["http_requests_total", "GET", "/v1/studies/{study_id}", "404"] == 2
    assert found["http_requests_total", "GET", "none", "404"] == 3
    assert {name[1] for name in found if name[0] == "http_requests_total"} == {"GET", "other"}
    assert found["http_request_seconds_count", "GET", "/v1/studies/{study_id}"] == 2


def test_metrics_take_a_key_where_one_is_needed(
    settings: Settings, serve: Any, database: Database, problem: Check
) -> None:
    with database.write() as session:
        key = keys.create(session, "prometheus", "read", None, None)[1]
    with serve(settings.model_copy(update={"require_keys": "always"})) as client:
        problem(client.get("/metrics"), 401, "key-missing")
        assert scrape(client, authorization=f"Bearer {key}")["workers",] == 0


def test_the_database_away_is_told_too(client: httpx.Client, tmp_path: Path, serve: Any) -> None:
    settings = Settings(data_dir=tmp_path, database_url=f"sqlite:///{tmp_path}/missing/folder.db")
    with serve(settings) as client:
        found = scrape(client)
    assert found["up", "database"] == 0
    assert ("workers",) not in found


def test_an_answer_in_the_other_format(client: httpx.Client) -> None:
    answer = client.get("/metrics", headers={"Accept": "application/openmetrics-text; version=1.0.0"})
    assert answer.headers["content-type"].startswith("application/openmetrics-text")
    assert answer.text.count("# EOF") == 1
    assert answer.text.endswith("# EOF\n")


def test_ready_means_that_requests_can_be_served(client: httpx.Client, settings: Settings, database: Database) -> None:
    assert client.get("/readyz").json() == {"status": "ok"}
    assert scrape(client)["up", "histories"] == 1
    folder = settings.data_dir / "histories"
    assert not list(folder.iterdir())
    folder.rmdir()
    folder.touch()  # nothing can be written there
    assert scrape(client)["up", "histories"] == 0
    for revision, status in (("0009", 503), ("9999", 200)):
        with database.write() as session:
            session.execute(text("UPDATE alembic_version SET version_num = :it"), {"it": revision})
        try:
            answer = client.get("/readyz")
        finally:
            with database.write() as session:
                session.execute(text("UPDATE alembic_version SET version_num = :it"), {"it": SCHEMA})
        assert answer.status_code == status
    assert client.get("/healthz").json() == {"status": "ok"}


@pytest.mark.parametrize("database_url", ["sqlite"], indirect=True)
def test_a_broker_that_answers(settings: Settings, serve: Any, broker_url: str) -> None:
    with serve(settings.model_copy(update={"broker_url": broker_url})) as client:
        assert scrape(client)["up", "broker"] == 1


def test_the_schema_that_is_expected_is_the_newest(database: Database) -> None:
    newest = max(path.name[:4] for path in (ROOT / "migrations/versions").glob("0*.py"))
    with database.read() as session:
        assert session.scalar(text("SELECT version_num FROM alembic_version")) == newest == SCHEMA


def test_processes_behind_one_port_count_together(tmp_path: Path) -> None:
    port = free_port()
    own = {"TRACKSWEEP_DATA_DIR": str(tmp_path), "TRACKSWEEP_API_PROCESSES": "2", "TRACKSWEEP_PORT": str(port)}
    own |= {"TRACKSWEEP_BROKER_URL": f"redis+socket://{tmp_path}/nobody"}
    migrations.upgrade(f"sqlite:///{tmp_path}/tracksweep.db")
    log = tmp_path / "log"
    with log.open("w") as output:
        command = [sys.executable, "-m", "worker.cli", "api"]
        api = subprocess.Popen(command, env=os.environ | own, stdout=output, stderr=output)
    try:
        deadline = time.monotonic() + 60
        while log.read_text().count("Application startup complete") < 2:
            assert time.monotonic() < deadline, log.read_text()
            time.sleep(0.05)
        for n in range(1, 9):  # each on a connection of its own, which either may take
            assert httpx.get(f"http://127.0.0.1:{port}/healthz", trust_env=False, timeout=30).is_success
            with httpx.Client(base_url=f"http://127.0.0.1:{port}", trust_env=False, timeout=30) as client:
                assert scrape(client)["http_requests_total", "GET", "/healthz", "200"] == n
    finally:
        api.send_signal(signal.SIGTERM)
        assert api.wait(timeout=30) == 0


def alerts() -> list[dict[str, Any]]:
    (group,) = yaml.safe_load((ROOT / "deploy/prometheus/rules.yml").read_text())["groups"]
    return list(group["rules"])


def test_every_alert_has_a_runbook() -> None:
    page = (ROOT / "docs/operations.md").read_text()
    alerting = page.partition("\n## Alerts\n")[2].partition("\n## ")[0]
    headings = {heading.lower().replace(" ", "-") for heading in re.findall(r"^### (.+)$", alerting, re.MULTILINE)}
    named = Counter(alert["annotations"]["runbook"].partition("#") for alert in alerts())
    assert {document for document, _, _ in named} == {"docs/operations.md"}
    assert {heading for _, _, heading in named} == headings
    assert len({alert["alert"] for alert in alerts()}) == len(alerts()) >= 6


def test_what_rules_dashboards_and_documents_name_is_exposed(client: httpx.Client) -> None:
    client.get("/healthz")
    exposed = {f"tracksweep_{name[0]}" for name in scrape(client)}
    documented = set()
    for path in ("deploy/prometheus/rules.yml", "deploy/grafana/dashboard.json", "docs/operations.md"):
        named = set(re.findall(r"\btracksweep_[a-z_]+\b", (ROOT / path).read_text()))
        assert {name for name in named if name not in exposed and f"{name}_count" not in exposed} == set(), path
        documented |= named
    assert {name for name in exposed if re.sub("_(bucket|count|sum)$", "", name) not in documented} == set()


def test_requests_are_logged(client: httpx.Client, study: dict[str, Any], capsys: pytest.CaptureFixture[str]) -> None:
    answer = client.post("/v1/studies", json=study)
    client.get(f"/v1/studies/{answer.json()['id']}/cases?state=queued")
    client.get("/healthz")
    entries = [json.loads(line) for line in capsys.readouterr().err.splitlines()]
    created, listed = [entry for entry in entries if entry["event"] == "request"]
    assert (created["method"], created["path"], created["status"]) == ("POST", "/v1/studies", 201)
    assert created["request_id"] == answer.headers["x-request-id"]
    assert listed["study_id"] == answer.json()["id"]
    assert "?" not in listed["path"]
