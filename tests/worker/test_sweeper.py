"""Bells and orphans."""

import os
import time
from collections.abc import Callable
from pathlib import Path

import redis

from app.context import Context
from app.queue import QUEUE, Doorbell
from app.settings import Settings
from app.studies.schemas import StudyDetail
from worker import lease
from worker.claim import claim
from worker.sweeper import ORPHANED_AFTER_S, Sweeper, collect_orphans

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


def test_orphans_are_collected(context: Context, submit: Submit, tmp_path: Path) -> None:
    submit(300, keep_history=True)
    store = context.histories
    for key in ("told/1-a.npz", "orphan/1-b.npz", "fresh/1-c.npz"):
        store.put(key, b"history")
    long_ago = time.time() - ORPHANED_AFTER_S - 60
    for key in ("told/1-a.npz", "orphan/1-b.npz"):
        os.utime(tmp_path / "histories" / key, (long_ago, long_ago))
    with context.database.write() as session:
        (held,) = claim(session, "test", 15.0)
        history = {"key": "told/1-a.npz", "digest": "d" * 64, "size_bytes": 7}
        assert lease.succeed(session, held, peaks=[], processing={}, history=history, cpu_s=0.0)
    with context.database.read() as session:
        assert collect_orphans(session, store) == 1
    assert sorted(store.keys_older_than(-60)) == ["fresh/1-c.npz", "told/1-a.npz"]
