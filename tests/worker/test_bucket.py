"""A worker that keeps histories in a bucket, which may be away."""

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import select

from app.context import Context
from app.db.models import Case, History
from app.db.session import Database
from app.queue import Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from tests.app.conftest import serving
from tests.bucket import Bucket, bucket
from tests.worker.conftest import Submit
from tests.worker.test_processes import state, until
from worker import sweeper
from worker.compute import Worker

pytestmark = pytest.mark.parametrize("database_url", ["sqlite"], indirect=True)

__all__ = ["bucket"]


@pytest.fixture
def context(tmp_path: Path, database_url: str, database: Database, bucket: Bucket) -> Context:
    broker_url = f"redis+socket://{tmp_path}/nobody"
    settings = Settings(data_dir=tmp_path, database_url=database_url, broker_url=broker_url, storage_url=bucket.url)
    return Context(settings, database, Doorbell(settings), HistoryStore(bucket.url))


@contextmanager
def working(settings: Settings) -> Iterator[None]:
    """A worker in a thread."""
    worker = Worker(settings, stopping := threading.Event())
    thread = threading.Thread(target=worker.work)
    thread.start()
    try:
        yield
    finally:
        stopping.set()
        thread.join()
        worker.database.close()


def test_a_worker_waits_for_the_bucket(
    context: Context, submit: Submit, bucket: Bucket, capfd: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    bucket.kill()
    study = submit(300, keep_history=True)
    plain = submit(310)
    with working(context.settings):
        until(lambda: "history store unavailable" in "".join(capfd.readouterr()))
        assert state(context, study) == "running"
        with context.database.read() as session:
            assert session.scalars(select(History)).all() == []
        bucket.start()
        until(lambda: state(context, study) == state(context, plain) == "succeeded")
    with context.database.read() as session:
        assert set(session.scalars(select(Case.attempt))) == {1}
        history = session.scalars(select(History)).one()
    assert not (context.settings.data_dir / "histories").exists()

    with serving(context.settings) as client:
        url = f"/v1/cases/{history.case_id}/history"
        stored = bucket.get(history.key)
        assert stored.headers["content-disposition"] == f'attachment; filename="case-{history.case_id}.npz"'
        assert client.get(f"{url}.npz").content == stored.content
        drawn = client.get(url, params={"max_points": 10}).json()
        assert drawn["samples"] > max(len(channel["values"]) for channel in drawn["channels"])

        assert client.delete(f"/v1/studies/{study.id}").status_code == 204
        assert client.get(f"{url}.npz").status_code == 404
    monkeypatch.setattr(sweeper, "ORPHANED_AFTER_S", -60.0)
    assert sweeper.collect_orphans(context.database, context.histories) == 1
    assert bucket.get(history.key).status_code == 404
