"""What docs/security.md promises of the API, request by request."""

import asyncio
import base64
import hashlib
import hmac
import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.access import keys
from app.db.session import Database
from app.main import create_app
from app.pages import HEADERS
from app.settings import Settings

Check = Callable[..., dict[str, Any]]
Body = dict[str, Any]
JSON = {"Content-Type": "application/json"}


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [
        ("GET", "/v1/limits", 200),
        ("HEAD", "/v1/limits", 200),
        ("GET", "/v1/peaks.csv", 200),
        ("GET", "/openapi.json", 200),
        ("GET", "/docs-assets/swagger-ui.css", 200),
        ("GET", "/healthz", 200),
        ("GET", "/docs", 200),
        ("GET", "/redoc", 200),
        ("GET", "/nothing", 404),
        ("POST", "/docs", 405),
        ("POST", "/v1/studies", 422),
    ],
)
def test_every_answer_tells_browsers_to_be_careful(
    method: str, path: str, status: int, lenient_client: httpx.Client
) -> None:
    answer = lenient_client.request(method, path)
    assert answer.status_code == status
    policy = answer.headers["content-security-policy"]
    assert {name: answer.headers[name] for name in HEADERS} == HEADERS | {"Content-Security-Policy": policy}
    assert "default-src 'none'" in policy
    assert "frame-ancestors 'none'" in policy


def test_a_fault_of_ours_does_too_and_shows_no_more(tmp_path: Path, sqlite_url: str) -> None:
    app = create_app(Settings(data_dir=tmp_path, database_url=sqlite_url))

    @app.get("/fault")
    def fault() -> None:
        raise RuntimeError("what only the log may say")

    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
            return await client.get("/fault")

    answer = asyncio.run(ask())
    assert (answer.status_code, answer.json()["code"]) == (500, "internal-error")
    assert answer.headers.items() >= {name.lower(): value for name, value in HEADERS.items()}.items()
    assert answer.headers["x-request-id"] == answer.json()["request_id"]
    assert "only the log" not in answer.text


@pytest.mark.parametrize("path", ["/docs", "/redoc"])
def test_pages_run_no_script_but_their_own(path: str, lenient_client: httpx.Client) -> None:
    page = lenient_client.get(path)
    policy = dict(part.split(" ", 1) for part in page.headers["content-security-policy"].split("; "))
    inline = re.findall(r"<script>(.*?)</script>", page.text, re.DOTALL)
    hashes = [base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() for script in inline]
    assert policy["script-src"] == " ".join(["'self'", *(f"'sha256-{found}'" for found in hashes)])
    assert policy["connect-src"] == "'self'"
    assert not re.search(r"""<[^>]* on\w+=""", page.text)


def test_other_sites_cannot_use_the_loopback(client: httpx.Client, study: Body, problem: Check) -> None:
    port = client.base_url.port
    for headers in (
        {"Host": "evil.example"},
        {"Host": f"127.0.0.1.evil.example:{port}"},
        {"Host": "["},
        {"Host": "evil.example:99999"},
        {"Origin": "https://evil.example"},
        {"Origin": "null"},
        {"Origin": f"http://evil.example:{port}"},
        {"Origin": f"http://localhost:{port + 1}"},
    ):
        for method, path in (("GET", "/v1/studies"), ("POST", "/v1/studies"), ("POST", "/v1/cases/1/verification")):
            answer = client.request(method, path, headers=headers, json=study if method == "POST" else None)
            problem(answer, 403, "cross-site")
    for host in (f"localhost:{port}", "localhost", f"127.0.0.1:{port}", f"127.8.8.8:{port}", f"[::1]:{port}"):
        assert client.get("/v1/studies", headers={"Host": host}).status_code == 200, host
        own_page = {"Host": host, "Origin": f"http://{host}"}
        assert client.post("/v1/study-estimates", headers=own_page, json=study).status_code == 200, host


def test_who_has_a_key_may_come_by_any_name(settings: Settings, serve: Any, database: Database) -> None:
    with database.write() as session:
        _, secret = keys.create(session, "anna", "read", None, None)
    with serve(settings) as client:
        headers = {"Host": "tracksweep.example", "Authorization": f"Bearer {secret}"}
        assert client.get("/v1/studies", headers=headers).status_code == 200


def test_who_has_no_key_has_nothing_read(settings: Settings, serve: Any, problem: Check) -> None:
    """Neither parsed nor, beyond what fits in buffers, received."""
    with serve(settings.model_copy(update={"require_keys": "always"})) as client:
        for path in ("/v1/studies", "/v1/study-estimates", "/v1/profiles"):
            for content in (b"{", b"[" * 1000):
                problem(client.post(path, content=content, headers=JSON), 401, "key-missing")
        problem(client.patch(f"/v1/studies/{'0' * 32}", content=b"{", headers=JSON), 401, "key-missing")


def test_a_request_is_counted_once(settings: Settings, serve: Any, study: Body) -> None:
    with serve(settings.model_copy(update={"writes_per_minute": 10})) as client:
        left = [client.post("/v1/study-estimates", json=study).headers["ratelimit"] for _ in range(3)]
    assert [re.search(r"r=(\d+)", each)[1] for each in left] == ["9", "8", "7"]  # type: ignore[index]


def test_a_key_is_compared_in_constant_time(database: Database, monkeypatch: pytest.MonkeyPatch) -> None:
    with database.write() as session:
        key, secret = keys.create(session, "anna", "read", None, None)
    compared = []

    def refuse(a: str, b: str) -> bool:
        compared.append({a, b})
        return False

    assert keys.authenticate(database, secret) is not None
    monkeypatch.setattr(hmac, "compare_digest", refuse)
    assert keys.authenticate(database, secret) is None, "something else decides"
    assert compared == [{key.hash}]


OPENED: list[str] = []


def _remember(event: str, arguments: tuple[Any, ...]) -> None:
    if event in ("open", "os.listdir", "os.scandir", "shutil.copyfile"):
        OPENED.append(str(arguments[0]))


def test_no_path_from_a_request_is_opened(lenient_client: httpx.Client, study: Body, tmp_path: Path) -> None:
    """Python tells of every file it opens; none may have a name that came in a request."""
    sys.addaudithook(_remember)
    secret = tmp_path / "marker-of-a-secret"
    secret.write_text("x_m,eta_mm\n" + "\n".join(f"{n},0" for n in range(99)))
    (tmp_path / "control").touch()
    (tmp_path / "control").read_bytes()
    assert str(tmp_path / "control") in OPENED
    OPENED.clear()
    up = "../" * 12
    for path in (str(secret), f"{up}{secret}", f"file://{secret}", f"{secret}\0", str(secret).replace("/", "\\")):
        for prefix in ("/", "/docs-assets/", "/docs-assets/..%2f..%2f", "/v1/profiles/", "/v1/studies/", "/v1/cases/"):
            assert lenient_client.get(prefix + path.replace("\0", "%00").replace("../", "%2e%2e/")).status_code == 404
        for place in spoilt(study, path):
            assert lenient_client.post("/v1/study-estimates", content=json.dumps(place), headers=JSON).status_code in (
                200,
                422,
            )
        for query in ("study_id", "quantity", "cursor", "sort", "slab", "name", "file"):
            lenient_client.get("/v1/peaks", params={query: path})
            lenient_client.get("/v1/studies", params={query: path})
        header = path.replace("\0", "")
        for name in (
            "Idempotency-Key",
            "If-Match",
            "Accept",
            "Content-Type",
            "Range",
            "Authorization",
            "X-Forwarded-For",
        ):
            lenient_client.get("/v1/studies", headers={name: header})
        lenient_client.post("/v1/profiles", content=path.encode(), headers={"Content-Type": "text/csv"})
        disposition = {"Content-Type": "text/csv", "Content-Disposition": f'attachment; filename="{header}"'}
        lenient_client.post("/v1/profiles", content=b"x", headers=disposition)
    assert not [name for name in OPENED if "marker-of-a-secret" in name]


def spoilt(node: Any, value: str) -> list[Any]:
    """A document once for every place in it, with the value there."""
    if isinstance(node, dict):
        inner = [node | {key: each} for key in node for each in spoilt(node[key], value)]
        return [value, node | {"file": value}, node | {value: value}, *inner]
    if isinstance(node, list):
        return [value, [*node, value]]
    return [value]
