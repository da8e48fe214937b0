"""Conditional requests (RFC 9110): what the client already has is not sent again, nor what it never saw changed.

The ETag of what can be edited has two parts, ``"EDITION-CONTENT"``. The first changes with an edit only, and is what
If-Match is held against: otherwise the progress of a running study would fail every edit. If-None-Match is held against
the whole.
"""

import hashlib
from typing import Annotated, Any

from fastapi import Header, Request, Response

from app.problems import Problem

IfMatchHeader = Annotated[
    str | None,
    Header(
        alias="If-Match",
        description="Required: the ETag of the version that is to be changed, or * for any. What changes by itself, "
        "such as progress, does not count.",
    ),
]
NOT_CHANGED: dict[int | str, dict[str, Any]] = {304: {"description": "Not changed"}}
CONDITIONAL_CHANGE: dict[int | str, dict[str, Any]] = {
    412: {"description": "Changed by somebody else"},
    428: {"description": "If-Match is missing"},
}


def is_known(request: Request, etag: str) -> bool:
    """Whether the client says, by If-None-Match, that it has this version."""
    known = {tag.strip().removeprefix("W/") for tag in request.headers.get("if-none-match", "").split(",")}
    return bool(known & {etag, "*"})


def edition(*editable: object) -> str:
    """Digest of what can be edited."""
    return hashlib.sha256(repr(editable).encode()).hexdigest()[:16]


def check_match(if_match: str | None, current: str) -> None:
    """Let a change pass only if the client means the current edition.

    Raises
    ------
    Problem
        412 if it means another one, 428 if it does not say which.
    """
    if if_match is None:
        raise Problem(428, "Send the ETag of what you change as If-Match, or * for any.", code="if-match-missing")
    tags = [tag.strip() for tag in if_match.split(",")]  # weak ones never match
    if not any(tag == "*" or tag.startswith(f'"{current}-') for tag in tags):
        raise Problem(412, "It was changed since you read it. Get it again.", code="changed-meanwhile")


def respond(request: Request, content: bytes, media_type: str, edition: str = "") -> Response:
    """The content with its digest, after that of its edition if it has one, as ETag, or 304."""
    etag = f'"{edition and edition + "-"}{hashlib.sha256(content).hexdigest()}"'
    headers = {"ETag": etag, "Cache-Control": "no-cache"}
    return not_changed(request, etag) or Response(content, media_type=media_type, headers=headers)


def not_changed(request: Request, etag: str) -> Response | None:
    """The 304 for a client that has this version."""
    if not is_known(request, etag):
        return None
    return Response(status_code=304, headers={"ETag": etag, "Cache-Control": "no-cache"})
