"""The OpenAPI document: FastAPI's, with errors as they really are."""

from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from app import examples
from app.problems import MEDIA_TYPE, ProblemDetails
from app.requests import with_integers

REFERENCE = "#/components/schemas/{model}"
ALWAYS = {
    "401": "A valid API key is needed, or the one sent is not valid",
    "403": "The API key's scope does not suffice",
    "422": "Invalid",
    "429": "Too many requests, or a quota is used up",
    "503": "Database or disk away",
}
KEY = {"type": "http", "scheme": "bearer", "description": "An API key, ts_…, that `tracksweep keys create` printed."}
WITH_BODY = {"400": "Unparsable", "413": "Body too large", "415": "Body of another type"}
WITH_PATH = {"404": "Not found"}

# Where the identifiers in paths come from: an operation, its success, and the place in its answer.
SOURCES = {
    "study_id": ("create_study", "201", "$response.body#/id"),
    "case_id": ("list_cases", "200", "$response.body#/items/0/id"),
    "profile_id": ("create_profile", "201", "$response.body#/id"),
}

# Fields of answers that a service of the minor version before does not send: not required, for the client's sake.
NEW = {
    "CaseDetail": {"processing"},
    "PeakRow": {"parameters"},
    "ParameterInfo": {"default"},
    "StudySummary": {"owner"},
    "StudyDetail": {"owner"},
}


def document(app: FastAPI) -> dict[str, Any]:
    """The document, made once."""
    if app.openapi_schema is None:
        made = get_openapi(title=app.title, version=app.version, description=app.description, routes=app.routes)
        schema = with_integers(made)  # of bounds it makes floats, which cannot tell 2^63 from its neighbours
        schemas = schema["components"]["schemas"]
        for name in ("HTTPValidationError", "ValidationError"):
            schemas.pop(name, None)
        problem = ProblemDetails.model_json_schema(ref_template=REFERENCE)
        schemas |= problem.pop("$defs") | {"ProblemDetails": problem}
        for name, fields in NEW.items():
            schemas[name]["required"] = [field for field in schemas[name]["required"] if field not in fields]
        # Optional, as whether a key is needed depends on where the service listens.
        schema["security"] = [{}, {"key": []}]
        schema["components"]["securitySchemes"] = {"key": KEY}
        for path, operations in schema["paths"].items():
            for operation in operations.values():
                _document_problems(path, operation)
                _document_parameters(operation)
                _give_example(operation)
        _link(schema["paths"])
        app.openapi_schema = schema
    return app.openapi_schema


def _document_problems(path: str, operation: dict[str, Any]) -> None:
    declared = {status: each["description"] for status, each in operation["responses"].items() if status >= "400"}
    problems = (
        ALWAYS | declared | (WITH_BODY if "requestBody" in operation else {}) | (WITH_PATH if "{" in path else {})
    )
    content = {MEDIA_TYPE: {"schema": {"$ref": REFERENCE.format(model="ProblemDetails")}}}
    responses = operation["responses"] | {
        status: {"description": reason, "content": content} for status, reason in problems.items()
    }
    operation["responses"] = dict(sorted(responses.items()))


def _document_parameters(operation: dict[str, Any]) -> None:
    """What FastAPI documents as `null` is left out: neither a query nor a header can say it."""
    for parameter in operation.get("parameters", ()):
        schema = parameter["schema"]
        given = [each for each in schema.pop("anyOf", ()) if each != {"type": "null"}]
        schema |= given[0] if len(given) == 1 else {"anyOf": given} if given else {}
        parameter["required"] |= parameter["name"] == "If-Match"  # without it the answer is 428, not 422


def _give_example(operation: dict[str, Any]) -> None:
    name = operation["operationId"]
    values = examples.PATHS | examples.PARAMETERS.get(name, {})
    for parameter in operation.get("parameters", ()):
        if parameter["name"] in values:
            parameter["example"] = values[parameter["name"]]
    if name in examples.BODIES:
        for content in operation["requestBody"]["content"].values():
            content["example"] = examples.BODIES[name]


def _link(paths: dict[str, Any]) -> None:
    """Say which operations take the identifier that another one gives (OpenAPI links)."""
    operations = {each["operationId"]: each for methods in paths.values() for each in methods.values()}
    for name, operation in operations.items():
        for parameter in operation.get("parameters", ()):
            if parameter["name"] in SOURCES and parameter["in"] == "path":
                source, status, place = SOURCES[parameter["name"]]
                links = operations[source]["responses"][status].setdefault("links", {})
                links[name] = {"operationId": name, "parameters": {parameter["name"]: place}}
