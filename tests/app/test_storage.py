"""Histories in a bucket: whatever holds of a folder, and what a bucket can do besides that."""

import re
from collections.abc import Iterator
from typing import Any
from urllib.parse import parse_qs, urlsplit

import httpx
import pytest

from app.access import keys
from app.db.session import Database
from app.settings import Settings
from app.storage import HistoryStore
from tests.app.test_histories import (
    KEY,
    content,
    histories,
    path,
    test_a_part_is_drawn_in_full,
    test_a_store_that_lost_a_history,
    test_all_channels_are_drawn,
    test_downloads_hold_everything,
    test_parts_of_a_download,
    test_what_is_known_is_not_sent_again,
)
from tests.bucket import Bucket, bucket
from tests.outcomes import succeed
from tracksweep_client import connect
from tracksweep_client.generated.api.histories import download_history
from tracksweep_client.generated.types import File
from worker.claim import claim

pytestmark = pytest.mark.parametrize("database_url", ["sqlite"], indirect=True)

__all__ = [
    "bucket",
    "content",
    "histories",
    "path",
    "test_a_part_is_drawn_in_full",
    "test_a_store_that_lost_a_history",
    "test_all_channels_are_drawn",
    "test_downloads_hold_everything",
    "test_parts_of_a_download",
    "test_what_is_known_is_not_sent_again",
]


@pytest.fixture
def settings(settings: Settings, bucket: Bucket) -> Settings:
    return settings.model_copy(update={"storage_url": bucket.url})


def can_be_stored(client: httpx.Client) -> bool:
    found = re.search(r'^tracksweep_up{part="histories"} (\S+)$', client.get("/metrics").text, re.MULTILINE)
    assert found is not None
    return float(found[1]) == 1


def test_objects_lie_below_the_prefix(histories: HistoryStore, bucket: Bucket) -> None:
    histories.put(KEY, b"0123456789")
    assert bucket.get(KEY).content == b"".join(histories.read(KEY)) == b"0123456789"
    assert b"".join(histories.read(KEY, range(2, 5))) == b"234"
    assert KEY in histories.keys_older_than(-60)
    assert KEY not in histories.keys_older_than(60)
    histories.delete(KEY)
    histories.delete(KEY)  # as somebody else may have done
    assert bucket.get(KEY).status_code == 404
    with pytest.raises(FileNotFoundError):
        histories.read(KEY)


def test_a_bucket_that_is_away(
    client: httpx.Client, path: str, bucket: Bucket, histories: HistoryStore, content: bytes, problem: Any, capfd: Any
) -> None:
    assert can_be_stored(client)
    bucket.kill()
    assert not can_be_stored(client)
    (line,) = (line for line in capfd.readouterr().err.splitlines() if "history store unavailable" in line)
    assert f"{bucket.endpoint}/tracksweep/histories/probe" in line
    assert "RetryErrorImpl" not in line
    for suffix in ("", ".npz", ".parquet"):
        assert problem(client.get(path + suffix), 503, "unavailable")["detail"].startswith("The history store")
    assert client.get("/readyz").status_code == client.get("/v1/peaks").status_code == 200
    bucket.start()
    histories.put(KEY, content)
    assert can_be_stored(client)
    assert client.get(f"{path}.npz").content == content


def test_a_bucket_that_is_not_there(settings: Settings, serve: Any) -> None:
    with serve(settings.model_copy(update={"storage_url": "s3://another"})) as client:
        assert not can_be_stored(client)


LIFE = {"presigned_s": 60}


@pytest.fixture
def links(settings: Settings, serve: Any, path: str, histories: HistoryStore, content: bytes) -> Iterator[httpx.Client]:
    """A service that answers with links, and the history at ``path`` as a worker stores it."""
    histories.put(KEY, content, "case-1.npz")
    with serve(settings.model_copy(update=LIFE)) as client:
        yield client


def test_a_link_into_the_bucket(links: httpx.Client, path: str, bucket: Bucket, content: bytes) -> None:
    answer = links.get(f"{path}.npz")
    assert (answer.status_code, answer.content, answer.headers["cache-control"]) == (307, b"", "no-store")
    link = answer.headers["location"]
    assert link.startswith(f"{bucket.endpoint}/tracksweep/histories/{KEY}?")
    assert parse_qs(urlsplit(link).query)["X-Amz-Expires"] == ["60"]
    found = links.get(link)
    assert found.content == content
    assert found.headers["content-disposition"] == 'attachment; filename="case-1.npz"'
    part = links.get(f"{path}.npz", headers={"Range": "bytes=10-19"}, follow_redirects=True)
    assert (part.status_code, part.content) == (206, content[10:20])
    assert httpx.get(link.partition("?")[0], trust_env=False).status_code == 403


def test_what_the_service_answers_itself(links: httpx.Client, path: str, content: bytes) -> None:
    itself = links.get(f"{path}.npz", params={"through": "service"})
    assert itself.content == content
    head = links.head(f"{path}.npz")
    assert (head.status_code, int(head.headers["content-length"])) == (200, len(content))
    assert links.get(f"{path}.npz", headers={"If-None-Match": itself.headers["etag"]}).status_code == 304
    assert links.get(f"{path}.parquet").status_code == links.get(path).status_code == 200


def test_a_folder_has_no_links(settings: Settings, serve: Any, path: str, content: bytes) -> None:
    folder = (settings.data_dir / "folder").as_uri()
    HistoryStore(folder).put(KEY, content, "case-1.npz")
    with serve(Settings(**settings.model_dump() | LIFE | {"storage_url": folder})) as client:
        assert client.get(f"{path}.npz").content == content


def test_who_may_follow(
    settings: Settings, serve: Any, database: Database, histories: HistoryStore, study: dict[str, Any], problem: Any
) -> None:
    """Whoever sees the case; and the key stays with the service."""
    with database.write() as session:
        anna, ben = (keys.create(session, name, "write", None, None)[1] for name in ("anna", "ben"))
    seen: list[httpx.Request] = []
    with serve(settings.model_copy(update=LIFE | {"require_keys": "always"})) as client:
        service = connect(str(client.base_url), anna)
        own = service.get_httpx_client()
        own.event_hooks = {"request": [seen.append]}
        own.post("/v1/studies", json=study | {"keep_history": True})
        histories.put(KEY, b"0123456789")
        with database.write() as session:
            (held,) = claim(session, "test", 15.0, lanes=1)
            stored = {"key": KEY, "digest": "d" * 64, "size_bytes": 10}
            assert succeed(session, held, peaks=[], processing={}, history=stored, cpu_s=1.0)
        url = f"/v1/cases/{held.case_id}/history.npz"
        problem(client.get(url), 401)
        problem(client.get(url, headers={"Authorization": f"Bearer {ben}"}), 404)
        found = download_history.sync(held.case_id, client=service)
        own.close()
    assert isinstance(found, File)
    assert found.payload.read() == b"0123456789"
    assert [("X-Amz-Signature" in str(each.url), "Authorization" in each.headers) for each in seen[-2:]] == [
        (False, True),
        (True, False),
    ]
