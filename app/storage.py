"""The history store: immutable objects in a folder or a bucket."""

import errno
import os
import sqlite3
import time
from collections.abc import Iterator
from contextlib import suppress
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from obstore import sign
from obstore.exceptions import BaseError
from obstore.store import AzureStore, GCSStore, LocalStore, ObjectStore, S3Store, from_url

STORE_ERRORS = (OSError, BaseError)

PROBE = "probe"  # the name of an object that is deleted at once

_FULL = (errno.ENOSPC, errno.EDQUOT)
_FULL_SQLSTATE = "53100"  # PostgreSQL's


def is_full(error: BaseException) -> bool:
    """Whether an error of a store, a file or a database means that its disk is full."""
    reason = getattr(error, "orig", None) or error
    return (
        getattr(reason, "errno", None) in _FULL
        or getattr(reason, "sqlite_errorcode", None) == sqlite3.SQLITE_FULL
        or getattr(reason, "sqlstate", None) == _FULL_SQLSTATE
        or any(os.strerror(number) in str(reason) for number in _FULL)
    )


def _bucket(url: str, silence: str, retries: int) -> ObjectStore:
    """A bucket that may be read as slowly as a client takes what it holds, but is away when it is silent for long.

    Its endpoint says whether it speaks TLS. Retries are few: callers wait for what is away, and say so in the log.
    """
    options: Any = {"allow_http": True, "timeout": "1h", "read_timeout": silence}
    return from_url(
        url, client_options=options, retry_config={"max_retries": retries, "retry_timeout": timedelta(seconds=10)}
    )


def attachment(filename: str) -> str:
    """The Content-Disposition of a file that is to be kept."""
    return f'attachment; filename="{filename}"'


def filename(case_id: int) -> str:
    """What the history of a case is called when it is downloaded as it is stored."""
    return f"case-{case_id}.npz"


class HistoryStore:
    """Objects below a URL: ``file:///FOLDER`` (created when missing) or ``s3://BUCKET/PREFIX``.

    Attributes
    ----------
    folder : Path or None
        Where it is one.
    """

    def __init__(self, url: str) -> None:
        parts = urlsplit(url)
        self.folder = Path(unquote(parts.path)) if parts.scheme == "file" else None
        self._store: ObjectStore
        self._store = LocalStore.from_url(url, mkdir=True) if self.folder else _bucket(url, "30s", retries=3)
        self._probed = self._store if self.folder else _bucket(url, "2s", retries=0)

    def put(self, key: str, content: bytes, filename: str = "") -> None:
        """Write an object, whole or not at all.

        Parameters
        ----------
        key : str
        content : bytes
        filename : str, optional
            What browsers are to call it that have it from a link.
        """
        named = {"Content-Disposition": attachment(filename)} if filename and not self.folder else None
        self._store.put(key, content, attributes=named)

    def link(self, key: str, life_s: int) -> str | None:
        """A URL by which an object can be read for some time, by whoever has it; None where there is no such thing."""
        if not isinstance(self._store, S3Store | GCSStore | AzureStore):
            return None
        return sign(self._store, "GET", key, timedelta(seconds=life_s))

    def read(self, key: str, part: range | None = None) -> Iterator[bytes]:
        """An object, or some of its bytes, in chunks.

        Raises
        ------
        obstore.exceptions.NotFoundError
            There is no such object.
        """
        found = self._store.get(key, options=None if part is None else {"range": (part.start, part.stop)})
        return (bytes(chunk) for chunk in found.stream())

    def delete(self, key: str) -> None:
        """Remove an object, unless somebody did."""
        with suppress(FileNotFoundError):
            self._store.delete(key)

    def probe(self) -> None:
        """Find out within seconds whether objects can be written."""
        self._probed.put(PROBE, b"")
        with suppress(FileNotFoundError):  # several may probe at once
            self._probed.delete(PROBE)

    def keys_older_than(self, age_s: float) -> Iterator[str]:
        """Keys of objects written longer ago, give or take how much its clock differs from ours."""
        before = datetime.now(UTC) - timedelta(seconds=age_s)
        return (each["path"] for batch in self._store.list() for each in batch if each["last_modified"] < before)

    def remove_pieces_older_than(self, age_s: float) -> None:
        """Delete what writers that were killed have left in a folder: ``KEY#1`` and the like, which are no objects."""
        if self.folder is None:
            return
        for piece in self.folder.rglob("*#*"):
            with suppress(FileNotFoundError):  # it is an object by now
                if piece.stat().st_mtime < time.time() - age_s:
                    piece.unlink()
