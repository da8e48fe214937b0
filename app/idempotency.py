"""Requests that may be repeated: the first answer is kept under the client's key and given again."""

import hashlib
from typing import Annotated, Any

from fastapi import Header
from sqlalchemy.orm import Session

from app.db.models import IdempotencyKey
from app.problems import invalid

KEPT_S = 24 * 3600.0  # after this a key may be used anew

IdempotencyKeyHeader = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=255,
        pattern=r"^[\x20-\x7e]+$",
        description="Any unique text. A repeated request with the same key and body gets the first answer again, "
        "for 24 hours; one that comes while the first is still in progress waits for it.",
    ),
]


def key_of(owner_id: int | None, key: str) -> str:
    """The key under which an answer is kept: two owners may send the same one."""
    return key if owner_id is None else hashlib.sha256(f"{owner_id} {key}".encode()).hexdigest()


def recall(session: Session, key: str, request_digest: str) -> dict[str, Any] | None:
    """The first answer under a key, if there is one.

    Raises
    ------
    Problem
        422 if that was the answer to another request.
    """
    kept = session.get(IdempotencyKey, key)
    if kept is None:
        return None
    if kept.request_digest != request_digest:
        detail = "The key was used for another request before."
        raise invalid("/header/Idempotency-Key", "idempotency-key-reused", detail)
    return kept.response


def remember(session: Session, key: str, request_digest: str, response: dict[str, Any]) -> None:
    """Keep an answer, in the transaction whose outcome it tells."""
    session.add(IdempotencyKey(key=key, request_digest=request_digest, response=response))
