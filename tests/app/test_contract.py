"""The OpenAPI document, as the client generator needs it, and what importing the application costs."""

import re
import subprocess
import sys
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any
from urllib.parse import urljoin, urlsplit

import httpx
import pytest
from fastapi import routing

from app.main import create_app
from app.openapi import NEW
from app.settings import Settings

Serve = Callable[[Settings], AbstractContextManager[httpx.Client]]
OPERATIONS = {
    "create_study": ("post", "/v1/studies"),
    "list_studies": ("get", "/v1/studies"),
    "get_study": ("get", "/v1/studies/{study_id}"),
    "list_cases": ("get", "/v1/studies/{study_id}/cases"),
    "get_case": ("get", "/v1/cases/{case_id}"),
    "get_history": ("get", "/v1/cases/{case_id}/history"),
    "download_history": ("get", "/v1/cases/{case_id}/history.npz"),
    "download_history_parquet": ("get", "/v1/cases/{case_id}/history.parquet"),
    "compare_study": ("get", "/v1/studies/{study_id}/comparison"),
    "summarise_study": ("get", "/v1/studies/{study_id}/statistics"),
    "list_peaks": ("get", "/v1/peaks"),
    "export_peaks_csv": ("get", "/v1/peaks.csv"),
    "export_peaks_parquet": ("get", "/v1/peaks.parquet"),
    "list_quantities": ("get", "/v1/quantities"),
    "list_spectra": ("get", "/v1/spectra"),
    "list_tracks": ("get", "/v1/tracks"),
    "list_vehicles": ("get", "/v1/vehicles"),
    "list_presets": ("get", "/v1/presets"),
    "get_limits": ("get", "/v1/limits"),
    "get_queue": ("get", "/v1/queue"),
    "create_profile": ("post", "/v1/profiles"),
    "list_profiles": ("get", "/v1/profiles"),
    "get_profile": ("get", "/v1/profiles/{profile_id}"),
    "download_profile": ("get", "/v1/profiles/{profile_id}/profile.csv"),
    "delete_profile": ("delete", "/v1/profiles/{profile_id}"),
}


@pytest.fixture(scope="module")
def document(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return create_app(Settings(data_dir=tmp_path_factory.mktemp("document"))).openapi()


def test_no_request_waits_for_its_route_to_be_prepared(
    settings: Settings, serve: Serve, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It would keep the event loop, and what FastAPI does to the process's warnings meanwhile is not for threads."""
    with serve(settings) as client:
        monkeypatch.setattr(routing, "_populate_api_route_state", None)
        assert client.get("/v1/studies").status_code == 200


def operations(document: dict[str, Any]) -> dict[str, dict[str, Any]]:
    found = {}
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            found[operation["operationId"]] = {**operation, "at": (method, path)}
    return found


def test_operations_are_named_after_their_functions(document: dict[str, Any]) -> None:
    assert document["openapi"].startswith("3.1")
    found = operations(document)
    assert {name: found[name]["at"] for name in OPERATIONS} == OPERATIONS
    assert all(len(operation["tags"]) == 1 for operation in found.values())


def test_errors_are_problems(document: dict[str, Any]) -> None:
    for operation in operations(document).values():
        errors = {status: response for status, response in operation["responses"].items() if status >= "400"}
        assert {"422", "503"} <= set(errors)
        for response in errors.values():
            assert response["content"] == {
                "application/problem+json": {"schema": {"$ref": "#/components/schemas/ProblemDetails"}}
            }


def test_no_answer_has_defaults(document: dict[str, Any]) -> None:
    """The generated client would make such a field optional."""
    for name in (
        "StudyDetail",
        "StudySummary",
        "CaseDetail",
        "CaseSummary",
        "PeakRow",
        "ProblemDetails",
        "PeakPage",
        "HistoryView",
        "HistoryChannel",
    ):
        schema = document["components"]["schemas"][name]
        assert set(schema["required"]) | NEW.get(name, set()) == set(schema["properties"])


def test_every_reference_leads_somewhere(document: dict[str, Any]) -> None:
    def check(node: Any) -> None:
        if isinstance(node, dict):
            if isinstance(node.get("$ref"), str):
                assert node["$ref"].rpartition("/")[2] in document["components"]["schemas"]
            node = list(node.values())
        if isinstance(node, list):
            for each in node:
                check(each)

    check(document["paths"])
    check(document["components"])


def test_the_service_loads_no_numerics() -> None:
    """Workers compute; the service keeps books, and starts quickly."""
    heavy = {"numpy", "scipy", "numba", "llvmlite", "matplotlib", "pyarrow", "solver.simulate"}
    code = f"import sys, app.main; print(*{heavy} & set(sys.modules))"
    output = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True, timeout=60)
    assert output.stdout.strip() == ""


def test_the_database_away(tmp_path: Path, serve: Any, problem: Any) -> None:
    """A database that does not answer is 503 everywhere but where the process says that it lives."""
    for url in (f"sqlite:///{tmp_path}/missing/folder.db", f"postgresql+psycopg://nobody@/nothing?host={tmp_path}"):
        settings = Settings(data_dir=tmp_path, database_url=url, broker_url=f"redis+socket://{tmp_path}/nobody")
        with serve(settings) as client:
            assert client.get("/healthz").status_code == 200
            for path in ("/readyz", "/v1/studies", "/v1/peaks", "/v1/cases/1"):
                response = client.get(path)
                problem(response, 503, "unavailable")
                assert int(response.headers["retry-after"]) > 0


@pytest.mark.parametrize("path", ["/docs", "/redoc"])
def test_the_pages_of_the_api_need_nothing_from_elsewhere(path: str, lenient_client: httpx.Client) -> None:
    assets = re.findall(r"""(?:src|href)=["']([^"'>]+)["']""", lenient_client.get(path).text)
    assert len(assets) >= 2
    for asset in assets:
        assert not urlsplit(asset).netloc
        assert lenient_client.get(urljoin(path, asset)).is_success
