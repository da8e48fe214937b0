"""Files over HTTP (RFC 9110): whole, in parts, or not again."""

import re
from collections.abc import Callable, Iterator
from typing import Any

from fastapi import Request, Response
from fastapi.responses import StreamingResponse

from app.conditional import NOT_CHANGED
from app.problems import Problem
from app.storage import attachment

PARQUET = "application/vnd.apache.parquet"

# What a route documents that answers ranges of bytes.
RANGES = NOT_CHANGED | {206: {"description": "The range of bytes asked for"}, 416: {"description": "No such range"}}


def binary(media_type: str) -> dict[int | str, dict[str, Any]]:
    """What a route documents that answers with bytes."""
    return {200: {"content": {media_type: {"schema": {"type": "string", "format": "binary"}}}}}


def download(
    request: Request, etag: str, size: int, read: Callable[[range], Iterator[bytes]], media_type: str, filename: str
) -> Response:
    """A file in chunks, or as much of it as the client asks for.

    Parameters
    ----------
    request : Request
    etag : str
        Changes when any byte does.
    size : int
        Bytes of the file.
    read : callable
        Some of them.
    media_type, filename : str

    Raises
    ------
    Problem
        416 for a range beyond the end.
    """
    whole = range(size)
    part = _asked_for(request, etag, size) or whole
    headers = {
        "ETag": etag,
        "Cache-Control": "no-cache",
        "Accept-Ranges": "bytes",
        "Content-Length": str(len(part)),
        "Content-Disposition": attachment(filename),
    }
    if part != whole:
        headers["Content-Range"] = f"bytes {part.start}-{part.stop - 1}/{size}"
    return StreamingResponse(read(part), 200 if part == whole else 206, headers, media_type)


def _asked_for(request: Request, etag: str, size: int) -> range | None:
    """The one range that is asked for. Several may be answered by the whole, and so may what is no range."""
    asked = re.fullmatch(r"bytes=(\d{0,18})-(\d{0,18})", request.headers.get("range", ""), re.ASCII)
    if asked is None or request.headers.get("if-range", etag) != etag:
        return None
    first, last = (int(digits) if digits else None for digits in asked.groups())
    if first is None:
        part = range(size) if last is None else range(max(0, size - last), size)
    else:
        part = range(first, size if last is None else min(last + 1, size))
    if (first is None and last is None) or (first is not None and last is not None and last < first):
        return None
    if not part:
        raise Problem(416, f"There are {size} bytes.", headers={"Content-Range": f"bytes */{size}"})
    return part
