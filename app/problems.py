"""Every error as problem details (RFC 9457), with a stable ``code`` and the fields it concerns."""

from collections.abc import Iterable, Mapping, Sequence
from http import HTTPStatus
from urllib.parse import quote

import structlog
from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel, Field
from sqlalchemy import exc as database_errors
from starlette.exceptions import HTTPException
from starlette.routing import Match

from app import log
from app.pages import HEADERS
from app.pointer import pointer_to
from app.storage import is_full

MEDIA_TYPE = "application/problem+json"
METHODS = ("DELETE", "GET", "HEAD", "OPTIONS", "PATCH", "POST", "PUT")
MAX_ERRORS = 100  # a body can hold more mistakes than anyone wants to read
RETRY_AFTER_S = 5

_CODES = {
    400: "unparsable",
    404: "not-found",
    405: "method-not-allowed",
    413: "body-too-large",
    415: "unsupported-media-type",
    416: "range-not-satisfiable",
    422: "invalid",
    500: "internal-error",
    503: "unavailable",
}

_log = structlog.get_logger()


class FieldProblem(BaseModel):
    """What is wrong with one field of a request."""

    pointer: str = Field(description="JSON Pointer into the body, or /line/N of CSV, /query/NAME or /header/NAME.")
    code: str = Field(description="Stable name of the reason.")
    detail: str = Field(description="The reason in words.")


class ProblemDetails(BaseModel):
    """An error."""

    type: str
    title: str
    status: int
    detail: str
    instance: str = Field(description="Path of the request.")
    code: str = Field(description="Stable name of the reason.")
    request_id: str = Field(description="Finds the request in the service's log.")
    errors: list[FieldProblem]


class Problem(HTTPException):
    """An answer other than success, raised from anywhere within a request."""

    def __init__(
        self,
        status: int,
        detail: str,
        *,
        code: str | None = None,
        errors: Sequence[FieldProblem] = (),
        headers: Mapping[str, str] | None = None,
    ) -> None:
        super().__init__(status, detail, headers)
        self.code = code
        self.errors = errors


def invalid(pointer: str, code: str, detail: str) -> Problem:
    """A 422 on account of one field."""
    return Problem(422, detail, errors=[FieldProblem(pointer=pointer, code=code, detail=detail)])


def not_found(what: str) -> Problem:
    """A 404."""
    return Problem(404, f"There is no such {what}.")


def unavailable(detail: str, error: BaseException) -> Problem:
    """A 503, on account of an error of the database, a disk or a store."""
    headers = {"Retry-After": str(RETRY_AFTER_S)}
    if is_full(error):
        return Problem(503, "The disk of the service is full.", code="storage-full", headers=headers)
    return Problem(503, detail, headers=headers)


def install(app: FastAPI) -> None:
    """Let every error of the application leave as problem details."""
    app.add_exception_handler(HTTPException, _answer_http_exception)
    app.add_exception_handler(RequestValidationError, _answer_invalid_request)
    for error in (
        database_errors.OperationalError,
        database_errors.InterfaceError,
        database_errors.InternalError,
        database_errors.TimeoutError,
    ):
        app.add_exception_handler(error, _answer_database_away)
    app.add_exception_handler(OSError, _answer_disk_away)
    app.add_exception_handler(Exception, _answer_bug)


def _respond(request: Request, problem: Problem) -> Response:
    details = ProblemDetails(
        type="about:blank",
        title=HTTPStatus(problem.status_code).phrase,
        status=problem.status_code,
        detail=problem.detail,
        instance=quote(request.url.path, safe="/:@!$&'()*+,;=~"),
        code=problem.code or _CODES.get(problem.status_code, "error"),
        request_id=request.state.request_id,
        errors=list(problem.errors),
    )
    return Response(details.model_dump_json(), problem.status_code, problem.headers, MEDIA_TYPE)


async def _answer_http_exception(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)  # noqa: S101 - the signature Starlette wants is wider than what it does
    if isinstance(error, Problem):
        return _respond(request, error)
    if error.status_code == HTTPStatus.METHOD_NOT_ALLOWED:
        allow = ", ".join(_allowed_methods(request))
        return _respond(request, Problem(405, f"Only {allow} can be used here.", headers={"Allow": allow}))
    detail = "There is nothing here." if error.status_code == HTTPStatus.NOT_FOUND else str(error.detail)
    return _respond(request, Problem(error.status_code, detail, headers=error.headers))


def _allowed_methods(request: Request) -> Iterable[str]:
    for method in METHODS:
        scope = {**request.scope, "method": "GET" if method == "HEAD" else method}
        if any(route.matches(scope)[0] is Match.FULL for route in request.app.router.routes):
            yield method


async def _answer_invalid_request(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)  # noqa: S101 - as above
    found = error.errors()
    if any(each["loc"][0] == "path" for each in found):
        return _respond(request, Problem(404, "There is nothing here."))
    errors = [
        FieldProblem(
            pointer=pointer_to(each["loc"], error.body), code=each["type"].replace("_", "-"), detail=each["msg"]
        )
        for each in found[:MAX_ERRORS]
    ]
    return _respond(request, Problem(422, "The request is not valid; errors says why.", errors=errors))


async def _answer_database_away(request: Request, error: Exception) -> Response:
    log.unavailable("database", error)
    return _respond(request, unavailable("The database does not answer. Try again later.", error))


async def _answer_disk_away(request: Request, error: Exception) -> Response:
    _log.error("request failed", exc_info=error)
    return _respond(request, unavailable("The service cannot use its disk. Try again later.", error))


async def _answer_bug(request: Request, error: Exception) -> Response:
    _log.error("request failed", exc_info=error)
    headers = request.state.headers | HEADERS  # this answer passes no middleware
    return _respond(request, Problem(500, "The service failed. Its log says more.", headers=headers))
