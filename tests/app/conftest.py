"""The application behind a real HTTP server."""

import ssl
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import httpx
import pytest
import uvicorn

import migrations
from app.main import create_app
from app.settings import Settings

STUDY: dict[str, Any] = {
    "name": "A study",
    "sweep": {
        "kind": "product",
        "speed_kmh": [250, 300],
        "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.1, 0.3]},
    },
}
# Of no use here, but every client would make one, which takes longer than most tests.
TLS = ssl.create_default_context()


@contextmanager
def serving(settings: Settings) -> Iterator[httpx.Client]:
    server = uvicorn.Server(uvicorn.Config(create_app(settings), port=0, ws="none", log_level="warning"))
    thread = threading.Thread(target=server.run)
    thread.start()
    while not server.started:
        assert thread.is_alive()
    port = server.servers[0].sockets[0].getsockname()[1]
    try:
        with httpx.Client(base_url=f"http://127.0.0.1:{port}", trust_env=False, timeout=30, verify=TLS) as client:
            yield client
    finally:
        server.should_exit = True
        thread.join()


@pytest.fixture
def serve() -> Callable[[Settings], AbstractContextManager[httpx.Client]]:
    """The function above, for tests with settings of their own."""
    return serving


@pytest.fixture
def settings(tmp_path: Path, database_url: str) -> Settings:
    """No broker listens: nothing below depends on one."""
    broker_url = f"redis+socket://{tmp_path}/nobody"
    return Settings(data_dir=tmp_path, database_url=database_url, broker_url=broker_url, max_page_size=50)


@pytest.fixture
def client(settings: Settings) -> Iterator[httpx.Client]:
    with serving(settings) as client:
        yield client


@pytest.fixture(scope="module")
def lenient_client(tmp_path_factory: pytest.TempPathFactory) -> Iterator[httpx.Client]:
    """On SQLite, shared by the tests of a module: for requests that store nothing."""
    folder = tmp_path_factory.mktemp("shared")
    settings = Settings(data_dir=folder, broker_url=f"redis+socket://{folder}/nobody", max_cases_per_study=1000)
    migrations.upgrade(settings.resolved_database_url)
    with serving(settings) as client:
        yield client


@pytest.fixture
def study() -> dict[str, Any]:
    """A valid study of four cases, to be spoilt."""
    return {**STUDY, "sweep": {**STUDY["sweep"], "irregularity": {**STUDY["sweep"]["irregularity"]}}}


@pytest.fixture
def problem() -> Callable[..., dict[str, Any]]:
    """Asserts that a response is a problem as the contract has it, and returns it."""

    def check(response: httpx.Response, status: int, code: str | None = None) -> dict[str, Any]:
        assert response.status_code == status, response.text
        assert response.headers["content-type"] == "application/problem+json"
        details: dict[str, Any] = response.json()
        assert set(details) == {"type", "title", "status", "detail", "instance", "code", "request_id", "errors"}
        assert details["status"] == status
        assert details["instance"].isascii()
        assert unquote(details["instance"]) == response.request.url.path
        assert details["request_id"] == response.headers["x-request-id"]
        assert code is None or details["code"] == code
        return details

    return check
