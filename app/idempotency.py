"""Requests that may be repeated: the first answer is kept under the client's key and given again."""

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock
from typing import Annotated, Any

from fastapi import Header
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.db.models import IdempotencyKey
from app.problems import Problem, invalid

KEPT_S = 24 * 3600.0  # after this a key may be used anew
RETRY_AFTER_S = 2

IdempotencyKeyHeader = Annotated[
    str | None,
    Header(
        alias="Idempotency-Key",
        min_length=1,
        max_length=255,
        pattern=r"^[\x20-\x7e]+$",
        description="Any unique text. A repeated request with the same key and body gets the first answer again, "
        "for 24 hours; one that comes while the first is still in progress is answered 409 and may be sent again.",
    ),
]


def key_of(owner_id: int | None, key: str) -> str:
    """The key under which an answer is kept: two owners may send the same one."""
    return key if owner_id is None else hashlib.sha256(f"{owner_id} {key}".encode()).hexdigest()


class InProgress:
    """The keys under which this process is answering requests."""

    def __init__(self) -> None:
        self._keys: set[str] = set()
        self._lock = Lock()

    @contextmanager
    def only(self, key: str) -> Iterator[None]:
        """Be the only one that answers a request under a key.

        Raises
        ------
        Problem
            409 if another one does.
        """
        with self._lock:
            if key in self._keys:
                raise _in_progress()
            self._keys.add(key)
        try:
            yield
        finally:
            self._keys.remove(key)


def _in_progress() -> Problem:
    detail = "The first request with this key is still in progress. Send it again to get its answer."
    return Problem(409, detail, code="idempotency-key-in-progress", headers={"Retry-After": str(RETRY_AFTER_S)})


def hold(session: Session, key: str) -> None:
    """Be the only process that answers, until the transaction ends. Only PostgreSQL serves several.

    Raises
    ------
    Problem
        409 if another one does.
    """
    if session.get_bind().dialect.name == "postgresql":
        number = int.from_bytes(hashlib.sha256(key.encode()).digest()[:8], signed=True)
        if not session.scalar(select(func.pg_try_advisory_xact_lock(number))):
            raise _in_progress()


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
