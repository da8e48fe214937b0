"""Conditional requests (RFC 9110): what the client already has is not sent again."""

import hashlib

from fastapi import Request, Response


def is_known(request: Request, etag: str) -> bool:
    """Whether the client says, by If-None-Match, that it has this version."""
    known = {tag.strip().removeprefix("W/") for tag in request.headers.get("if-none-match", "").split(",")}
    return bool(known & {etag, "*"})


def respond(request: Request, content: bytes, media_type: str) -> Response:
    """The content with its digest as ETag, or 304."""
    etag = f'"{hashlib.sha256(content).hexdigest()}"'
    headers = {"ETag": etag, "Cache-Control": "no-cache"}
    if is_known(request, etag):
        return Response(status_code=304, headers=headers)
    return Response(content, media_type=media_type, headers=headers)
