"""How requests are read: JSON strictly and within limits, each under an identifier of its own."""

import asyncio
from collections.abc import Callable, Coroutine
from email.message import Message
from typing import Any
from uuid import uuid4

from fastapi import Request, Response
from fastapi.routing import APIRoute
from pydantic_core import from_json
from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Receive, Scope, Send
from starlette.types import Message as AsgiMessage
from structlog.contextvars import bound_contextvars

from app.access.caller import identify
from app.pages import HEADERS
from app.problems import Problem

CSV = "text/csv"


class JsonRequest(Request):
    """A request whose body is limited, and is JSON as Pydantic reads it.

    The standard library's reader would let lone surrogates through and give up on deep nesting with a
    RecursionError. NaN and Infinity pass here so that validation can name the field that holds them. 5.0 is an
    integer, as in JSON Schema, though not for strict Pydantic.
    """

    async def body(self) -> bytes:
        """The body, once it is known to be of the right type and size."""
        if not hasattr(self, "_limited_body"):
            self._limited_body = await _read(self, self.app.state.context.settings.max_body_bytes)
            if self._limited_body and not _is_json(self.headers.get("content-type", "")):
                raise Problem(415, "The body must be application/json.", headers={"Accept": "application/json"})
        return self._limited_body

    async def json(self) -> Any:
        """The body as Python objects."""
        try:
            return with_integers(from_json(await self.body()))
        except ValueError as error:
            raise Problem(400, f"The body is not JSON: {error}.") from None


async def csv_text(request: Request) -> str:
    """The body of a request, as a dependency: CSV in UTF-8."""
    content = await _read(request, request.app.state.context.settings.max_profile_bytes)
    if _media_type(request.headers.get("content-type", "")).get_content_type() != CSV:
        raise Problem(415, f"The body must be {CSV}.", headers={"Accept": CSV})
    try:
        return content.decode()
    except UnicodeDecodeError as error:
        raise Problem(400, f"The body is not UTF-8: {error.reason} at byte {error.start}.") from None


async def _read(request: Request, limit: int) -> bytes:
    chunks, size = [], 0
    async for chunk in request.stream():
        size += len(chunk)
        if size > limit:
            raise Problem(413, f"The body is larger than {limit} bytes.")
        chunks.append(chunk)
    return b"".join(chunks)


def with_integers(value: Any) -> Any:
    """What JSON says, with integers for floats that are some."""
    if isinstance(value, dict):
        return {key: with_integers(each) for key, each in value.items()}
    if isinstance(value, list):
        return [with_integers(each) for each in value]
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _is_json(content_type: str) -> bool:
    header = _media_type(content_type)
    subtype = header.get_content_subtype()
    return header.get_content_maintype() == "application" and (subtype == "json" or subtype.endswith("+json"))


def _media_type(content_type: str) -> Message:
    header = Message()
    header["content-type"] = content_type
    return header


class JsonRoute(APIRoute):
    """A route that reads its body through :class:`JsonRequest`, once it is known whose it is."""

    def get_route_handler(self) -> Callable[[Request], Coroutine[Any, Any, Response]]:
        """The handler FastAPI calls."""
        handle = super().get_route_handler()

        async def handle_json(request: Request) -> Response:
            await identify(request, request.app.state.context)  # FastAPI reads bodies before it asks
            return await handle(JsonRequest(request.scope, request.receive))

        return handle_json


class HeadMiddleware:
    """Answer HEAD wherever GET is answered: the application sees a GET whose client leaves after the headers, and
    ``head`` in its scope.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection."""
        if scope["type"] != "http" or scope["method"] != "HEAD":
            await self.app(scope, receive, send)
            return
        answered = asyncio.Event()

        async def receive_disconnect() -> AsgiMessage:
            await answered.wait()
            return {"type": "http.disconnect"}

        async def send_headers(message: AsgiMessage) -> None:
            if message["type"] == "http.response.start":
                await send(message)
                await send({"type": "http.response.body"})
                answered.set()

        await self.app({**scope, "method": "GET", "head": True}, receive_disconnect, send_headers)


class RequestIdMiddleware:
    """Number every request: in its log lines, in its problem details and in the header ``X-Request-ID``.

    Whatever else is put in ``request.state.headers`` goes with the answer too, be it a success or a problem, and so do
    the headers that tell browsers to be careful with it.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection."""
        request_id = uuid4().hex
        headers = {"X-Request-ID": request_id}
        scope.setdefault("state", {}).update(request_id=request_id, headers=headers)

        async def send_numbered(message: AsgiMessage) -> None:
            if message["type"] == "http.response.start":
                answer = MutableHeaders(scope=message)
                answer.update(headers)
                for name, value in HEADERS.items():
                    answer.setdefault(name, value)
            await send(message)

        with bound_contextvars(request_id=request_id):
            await self.app(scope, receive, send_numbered)
