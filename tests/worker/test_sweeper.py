"""Bells and orphans."""

import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import redis
from sqlalchemy import select

from app.context import Context
from app.db.models import Worker
from app.db.session import Database
from app.queue import QUEUE, Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from app.studies.schemas import StudyDetail
from tests.outcomes import succeed
from worker import lease, presence
from worker.claim import claim
from worker.sweeper import ON_DUTY, ORPHANED_AFTER_S, Sweeper, collect_orphans

Submit = Callable[..., StudyDetail]


def bells(broker_url: str) -> int:
    with redis.Redis(unix_socket_path=broker_url.removeprefix("redis+socket://")) as client:
        return int(client.llen(QUEUE))


def test_one_bell_is_enough(tmp_path: Path, broker_url: str) -> None:
    doorbell = Doorbell(Settings(data_dir=tmp_path, broker_url=broker_url))
    for _ in range(5):
        assert doorbell.ring()
    assert bells(broker_url) == 1


def test_a_bell_is_rung_once_the_broker_is_back(
    context: Context, submit: Submit, tmp_path: Path, broker_url: str
) -> None:
    submit(300)  # while no broker listens
    settings = context.settings.model_copy(update={"broker_url": broker_url})
    sweeper = Sweeper(Settings(**settings.model_dump()))
    sweeper.start()
    while bells(broker_url) == 0:
        time.sleep(0.05)
    sweeper.stop()


def test_of_many_workers_some_sweep(context: Context, submit: Submit, tmp_path: Path, broker_url: str) -> None:
    """Those whose names come first, so that others follow when they are gone."""
    submit(300)
    settings = context.settings.model_copy(update={"broker_url": broker_url, "lease_s": 0.9})
    database = context.database
    first, last = [f"0000:{n}" for n in range(1, ON_DUTY + 1)], "zzzz:1"
    with database.write() as session:
        for name in (*first[1:], last):
            presence.announce(session, name, 600.0)
        presence.announce(session, first[0], 3.0)
        for name, sweeps in ((first[0], True), (first[-1], True), ("a host", False), (last, False)):
            assert presence.is_among_the_first(session, name, ON_DUTY) is sweeps
    sweeper = Sweeper(Settings(**settings.model_dump()))
    sweeper.start()
    while presence.own_name() not in presence_of(database):
        time.sleep(0.05)
    while bells(broker_url) == 0:  # until one of the first is gone
        time.sleep(0.05)
    sweeper.stop()
    assert presence_of(database) == {*first[1:], last, presence.own_name()}


def presence_of(database: Database) -> set[str]:
    with database.read() as session:
        return set(session.scalars(select(Worker.name)))


def test_orphans_are_collected(context: Context, submit: Submit, tmp_path: Path) -> None:
    submit(300, 310, keep_history=True)
    with context.database.write() as session:
        told, untold = claim(session, "test", 15.0), claim(session, "test", 15.0)
        history = {"key": "told/1-a.npz", "digest": "d" * 64, "size_bytes": 7}
        assert succeed(session, told[0], peaks=[], processing={}, history=history, cpu_s=0.0)
    waiting = f"waiting/1-{untold[0].token}.npz"  # of a worker that has waited for the database
    old = ["told/1-a.npz", waiting, "orphan/1-b.npz"]
    store = context.histories
    for key in (*old, "fresh/1-c.npz"):
        store.put(key, b"history")
    pieces = ["orphan/1-d.npz#1", "orphan/1-d.npz#2"]  # of writers that were killed
    long_ago = time.time() - ORPHANED_AFTER_S - 60
    for piece in pieces:
        (tmp_path / "histories" / piece).touch()
    for key in (*old, pieces[0]):
        os.utime(tmp_path / "histories" / key, (long_ago, long_ago))

    store.remove_pieces_older_than(ORPHANED_AFTER_S)
    assert collect_orphans(context.database, store) == 1
    left = [file.relative_to(tmp_path / "histories") for file in (tmp_path / "histories").rglob("*.npz*")]
    assert sorted(map(str, left)) == ["fresh/1-c.npz", pieces[1], "told/1-a.npz", waiting]
    with context.database.write() as session:
        lease.release(session, untold[0])
    assert collect_orphans(context.database, store) == 1
    store.delete(waiting)  # as another sweeper may have done meanwhile


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_no_transaction_waits_for_the_store(
    context: Context, database_url: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    listed = HistoryStore.keys_older_than

    def slowly(store: HistoryStore, age_s: float) -> list[str]:
        time.sleep(0.5)
        return list(listed(store, age_s))

    monkeypatch.setattr(HistoryStore, "keys_older_than", slowly)
    database = Database(database_url, pause_s=0.2)
    assert collect_orphans(database, context.histories) == 0
    database.close()
