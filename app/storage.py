"""The history store: immutable objects in a folder or a bucket."""

from collections.abc import Iterator
from urllib.parse import urlsplit

from obstore.store import LocalStore, ObjectStore, from_url

HISTORY_MEDIA_TYPE = "application/octet-stream"


class HistoryStore:
    """Objects below a URL: ``file:///FOLDER`` (created when missing) or ``s3://BUCKET/PREFIX``."""

    def __init__(self, url: str) -> None:
        local = urlsplit(url).scheme == "file"
        self._store: ObjectStore = LocalStore.from_url(url, mkdir=True) if local else from_url(url)

    def put(self, key: str, content: bytes) -> None:
        """Write an object, whole or not at all."""
        self._store.put(key, content)

    def read(self, key: str) -> Iterator[bytes]:
        """An object in chunks.

        Raises
        ------
        FileNotFoundError
            There is no such object.
        """
        return (bytes(chunk) for chunk in self._store.get(key).stream())

    def delete(self, key: str) -> None:
        """Remove an object."""
        self._store.delete(key)
