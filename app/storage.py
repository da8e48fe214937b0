"""The history store: immutable objects in a folder or a bucket."""

from collections.abc import Iterator
from datetime import UTC, datetime, timedelta
from urllib.parse import urlsplit

from obstore.exceptions import BaseError
from obstore.store import LocalStore, ObjectStore, from_url

STORE_ERRORS = (OSError, BaseError)


class HistoryStore:
    """Objects below a URL: ``file:///FOLDER`` (created when missing) or ``s3://BUCKET/PREFIX``."""

    def __init__(self, url: str) -> None:
        local = urlsplit(url).scheme == "file"
        self._store: ObjectStore = LocalStore.from_url(url, mkdir=True) if local else from_url(url)

    def put(self, key: str, content: bytes) -> None:
        """Write an object, whole or not at all."""
        self._store.put(key, content)

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
        """Remove an object."""
        self._store.delete(key)

    def keys_older_than(self, age_s: float) -> Iterator[str]:
        """Keys of objects written longer ago, give or take how much its clock differs from ours."""
        before = datetime.now(UTC) - timedelta(seconds=age_s)
        return (each["path"] for batch in self._store.list() for each in batch if each["last_modified"] < before)
