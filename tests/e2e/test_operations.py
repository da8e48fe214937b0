"""Every example of the OpenAPI document is sent, and succeeds."""

import json
from pathlib import Path
from typing import Any

import pytest

from app.examples import PATHS, PROFILE, STUDY
from tests.e2e.conftest import Served, tracksweep, until

DOCUMENT = json.loads((Path(__file__).parents[2] / "openapi.json").read_text())
OPERATIONS = {
    operation["operationId"]: (method, path, operation)
    for path, methods in DOCUMENT["paths"].items()
    for method, operation in methods.items()
}
# What an operation needs to succeed, where that is not the computed study and its cases.
BEFORE = {"delete_study": "ended_study", "delete_profile": "unused_profile"}


@pytest.fixture(scope="module")
def identifiers(service: Served) -> dict[str, Any]:
    study_id = service.submit(STUDY)
    assert service.ended(study_id)["state"] == "succeeded"
    cases = service.cases(study_id)
    profile = service.http.post("/v1/profiles", content=PROFILE, headers={"Content-Type": "text/csv"})
    verification = f"/v1/cases/{cases[0]['id']}/verification"
    service.http.post(verification).raise_for_status()
    until(lambda: service.get(verification)["state"] == "succeeded")
    tracksweep("keys", "create", PATHS["key_name"], "--scope", "read", TRACKSWEEP_DATA_DIR=service.data)
    service.http.put(f"/v1/studies/{study_id}/shares/{PATHS['key_name']}").raise_for_status()
    return PATHS | {"study_id": study_id, "case_id": cases[0]["id"], "profile_id": profile.json()["id"]}


@pytest.fixture
def ended_study(service: Served) -> dict[str, str]:
    study_id = service.submit(STUDY | {"name": "to be deleted", "keep_history": False})
    service.ended(study_id)
    return {"study_id": study_id}


@pytest.fixture
def unused_profile(service: Served) -> dict[str, str]:
    content = PROFILE.replace("0.1", "0.15")
    profile = service.http.post("/v1/profiles", content=content, headers={"Content-Type": "text/csv"})
    return {"profile_id": profile.json()["id"]}


def example(of: dict[str, Any], name: str) -> Any:
    assert "example" in of, f"app/examples.py has no example of {name}"
    return of["example"]


def requested(name: str, identifiers: dict[str, Any]) -> dict[str, Any]:
    """The example of an operation, with identifiers of what there is."""
    method, path, operation = OPERATIONS[name]
    request: dict[str, Any] = {"method": method, "params": {}, "headers": {}}
    has_example = False
    for parameter in operation.get("parameters", ()):
        given = parameter["name"]
        if parameter["in"] == "path":
            example(parameter, f"{name}: {given}")
        elif "example" in parameter:
            value = identifiers.get(given, parameter["example"])
            request["headers" if parameter["in"] == "header" else "params"][given] = (
                str(value) if parameter["in"] == "header" else value
            )
            has_example = True
    assert has_example or all(p["in"] == "path" for p in operation.get("parameters", ())), f"no example of {name}"
    for media_type, content in operation.get("requestBody", {"content": {}})["content"].items():
        body = example(content, name)
        request["content"] = body if isinstance(body, str) else json.dumps(body)
        request["headers"]["Content-Type"] = media_type
    return request | {"url": path.format(**identifiers)}


@pytest.mark.parametrize("name", OPERATIONS)
def test_example(name: str, service: Served, identifiers: dict[str, Any], request: pytest.FixtureRequest) -> None:
    there = identifiers | (request.getfixturevalue(BEFORE[name]) if name in BEFORE else {})
    response = service.http.request(**requested(name, there))
    documented = OPERATIONS[name][2]["responses"]
    (success,) = {status for status in documented if status.startswith("2")} - {"204", "206"} or {"204"}
    assert response.status_code == int(success), response.text
    media_type = response.headers.get("content-type", "").partition(";")[0]
    assert media_type == "".join(documented[success].get("content", ""))
    if media_type == "application/json" and "items" in response.json():
        assert response.json()["items"], "the example finds nothing"
