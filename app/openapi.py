"""The OpenAPI document: FastAPI's, with errors as they really are."""

from collections.abc import Iterable
from typing import Any

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi

from app.problems import MEDIA_TYPE, ProblemDetails

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


def document(app: FastAPI) -> dict[str, Any]:
    """The document, made once."""
    if app.openapi_schema is None:
        schema = get_openapi(title=app.title, version=app.version, description=app.description, routes=app.routes)
        schemas = schema["components"]["schemas"]
        for name in ("HTTPValidationError", "ValidationError"):
            schemas.pop(name, None)
        problem = ProblemDetails.model_json_schema(ref_template=REFERENCE)
        schemas |= problem.pop("$defs") | {"ProblemDetails": problem}
        # Optional, as whether a key is needed depends on where the service listens.
        schema["security"] = [{}, {"key": []}]
        schema["components"]["securitySchemes"] = {"key": KEY}
        for path, operations in schema["paths"].items():
            for operation in operations.values():
                _document_problems(path, operation)
                _without_null(operation.get("parameters", ()))
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


def _without_null(parameters: Iterable[dict[str, Any]]) -> None:
    """What FastAPI documents as `null` is left out: neither a query nor a header can say it."""
    for parameter in parameters:
        schema = parameter["schema"]
        given = [each for each in schema.pop("anyOf", ()) if each != {"type": "null"}]
        schema |= given[0] if len(given) == 1 else {"anyOf": given} if given else {}
