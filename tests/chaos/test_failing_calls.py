"""The n-th statement fails, or the n-th call of the history store, at every step in the life of a study."""

import threading
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from obstore.exceptions import GenericError
from sqlalchemy import text
from sqlalchemy.exc import SQLAlchemyError

import migrations
from app import log
from app.context import Context
from app.db.session import Database
from app.histories import service as histories
from app.queue import Doorbell
from app.settings import Settings
from app.storage import STORE_ERRORS, HistoryStore
from app.studies import lifecycle, service
from app.studies.schemas import StudyRequest
from tests.chaos import changes, remains
from tests.chaos.checker import check
from tests.chaos.clients import NUMERICS
from worker import compute, sweeper
from worker.compute import Worker

WAVE = {"kind": "harmonic", "wavelength_m": [2.0], "amplitude_mm": [0.1]}
STUDY = {
    "name": "A life",
    "sweep": {"kind": "product", "speed_kmh": [300], "irregularity": WAVE},
    "numerics": NUMERICS | {"window_s": 0.05},
    "keep_history": True,
}
MAX_ATTEMPTS = 3
FAILURES = (SQLAlchemyError, *STORE_ERRORS)


class Trap:
    """Lets calls pass but one, which fails before or, as when an answer is lost, after it was carried out."""

    def __init__(self) -> None:
        self.set(0)

    def set(self, fatal: int, *, late: bool = False) -> None:
        self.passed, self.fatal, self.late = 0, fatal, late

    @property
    def sprung(self) -> bool:
        return self.passed >= self.fatal

    def around(self, call: Callable[..., Any], error: Exception, *, lasting: bool) -> Callable[..., Any]:
        """``lasting``: what the call does stays, so it matters whether it fails before or after."""

        def trapped(*args: Any, **kwargs: Any) -> Any:
            if self.late and not lasting:
                return call(*args, **kwargs)
            self.passed += 1
            if self.passed != self.fatal:
                return call(*args, **kwargs)
            if self.late:
                call(*args, **kwargs)
            raise error

        return trapped


class Life:
    """A study of one case, whose every step can be made to fail at every call."""

    def __init__(self, context: Context) -> None:
        self.context, self.trap = context, Trap()
        self.worker = Worker(context.settings, threading.Event())
        self.worker.histories = context.histories
        self.inspector = Database(context.settings.database_url)
        self.request = StudyRequest.model_validate(STUDY)

    def live(self) -> int:
        """From creation to deletion. Returns how many calls failed."""
        failed = self._endure(lambda: service.create(self.context, self.request, "key"))
        (study_id,) = self._values("SELECT id FROM study")
        failed += self._endure(lambda: lifecycle.cancel(self.context, study_id))
        failed += self._endure(lambda: lifecycle.retry(self.context, study_id))
        failed += self._compute()
        failed += self._endure(self._read_history)
        failed += self._endure(lambda: lifecycle.remove(self.context, study_id))
        failed += self._endure(self._collect)
        assert not list(self.context.histories.keys_older_than(-60))
        assert self._values('SELECT state FROM "case"') == ["succeeded"]
        return failed

    def _endure(self, step: Callable[[], object]) -> int:
        """Fail one call of a step after the other: whenever it fails it has done nothing."""
        before = self._state()
        for n in range(1, 1000):
            self.trap.set(n)
            try:
                step()
            except FAILURES:
                assert self._state() == before
            else:
                break
        assert not self.trap.sprung
        self.trap.set(0)
        return n - 1

    def _compute(self) -> int:
        """Fail one call of a worker after the other: whatever it leaves is sorted out, and the study ends well."""
        change, event = self._values("SELECT MAX(n) FROM chaos_change UNION ALL SELECT MAX(id) FROM event")
        failed = 0
        for late in (False, True):
            for n in range(1, 1000):
                self.trap.set(n, late=late)
                with_failures(self.worker.work)
                sprung = self.trap.sprung
                self.trap.set(0)
                self._recover()
                self._check()
                if not sprung:
                    break
                failed += 1
                self._rewind(change, event)
        return failed

    def _recover(self) -> None:
        """What other workers do, and the leases that run out meanwhile."""
        while self._values('SELECT state FROM "case"') != ["succeeded"]:
            self._execute("UPDATE \"case\" SET lease_expires = 0 WHERE state = 'running'")
            with self.context.database.write() as session:
                assert sweeper.sweep(session, MAX_ATTEMPTS)
            self.worker.work()

    def _rewind(self, change: int, event: int) -> None:
        """As if nothing had been computed yet."""
        self._execute("UPDATE \"case\" SET state = 'queued', attempt = 0, lease_token = NULL")
        self._execute("UPDATE study SET started_at = NULL, finished_at = NULL")
        self._execute("DELETE FROM peak", "DELETE FROM history", f"DELETE FROM event WHERE id > {event}")
        self._execute(f"DELETE FROM chaos_change WHERE n > {change}")

    def _check(self) -> None:
        with self.inspector.read() as session:
            rows = session.execute(text("SELECT * FROM chaos_change")).mappings().all()
        settings = {"lease_s": 0, "sweep_s": 0, "max_attempts": MAX_ATTEMPTS, "complete_set": remains.complete_set()}
        left = remains.collect(self.inspector, self.context.histories)
        lines = [{"kind": "settings"} | settings, *({"kind": "change", "t": 0} | dict(row) for row in rows)]
        violations = check([*lines, {"kind": "remains"} | left])
        assert not any(violations.values()), violations
        assert len(left["histories"]) == 1

    def _read_history(self) -> bytes:
        (case_id,) = self._values("SELECT case_id FROM history")
        with self.context.database.read() as session:
            stored = histories.find(session, case_id)
        return b"".join(self.context.histories.read(stored.history.key))

    def _collect(self) -> None:
        sweeper.collect_orphans(self.context.database, self.context.histories)

    def _state(self) -> list[Any]:
        tables = ("study", '"case"', "event", "peak", "history", "idempotency_key")
        return [self._rows(f"SELECT * FROM {table}") for table in tables]

    def _rows(self, query: str) -> list[Any]:
        with self.inspector.read() as session:
            return list(session.execute(text(query)).all())

    def _values(self, query: str) -> list[Any]:
        return [value for (value,) in self._rows(query)]

    def _execute(self, *statements: str) -> None:
        with self.inspector.write() as session:
            for statement in statements:
                session.execute(text(statement))


def with_failures(step: Callable[[], object]) -> None:
    try:
        step()
    except FAILURES:
        return


def remembering(function: Callable[..., Any]) -> Callable[..., Any]:
    """A pure function that computes each thing once."""
    found: dict[int, tuple[Any, Any]] = {}

    def remembered(argument: Any) -> Any:
        if id(argument) not in found:
            found[id(argument)] = argument, function(argument)
        return found[id(argument)][1]

    return remembered


@pytest.fixture
def life(tmp_path: Path, empty_url: str, monkeypatch: pytest.MonkeyPatch) -> Iterator[Life]:
    migrations.upgrade(empty_url)
    changes.install(empty_url)
    broker = f"redis+socket://{tmp_path}/nobody"
    settings = Settings(data_dir=tmp_path, database_url=empty_url, broker_url=broker, max_attempts=MAX_ATTEMPTS)
    context = Context(settings, Database(empty_url), Doorbell(settings), HistoryStore(settings.resolved_storage_url))

    solve = cache(compute.solve)
    monkeypatch.setattr(compute, "solve", lambda cases, _: solve(tuple(cases)))  # the same case again and again
    for name in ("peaks", "archive"):
        monkeypatch.setattr(compute, name, remembering(getattr(compute, name)))
    log.configure()  # in few words
    monkeypatch.setattr(compute, "PAUSE_S", 0.0)
    monkeypatch.setattr(sweeper, "ORPHANED_AFTER_S", -60.0)
    life = Life(context)
    yield life
    for database in (context.database, life.worker.database, life.inspector):
        database.close()


def test_any_statement_may_fail(life: Life) -> None:
    for database in (life.context.database, life.worker.database):
        dialect = database.engine.dialect
        error = dialect.loaded_dbapi.OperationalError("the connection is lost")
        for name in ("do_execute", "do_executemany", "do_commit"):
            trapped = life.trap.around(getattr(dialect, name), error, lasting=name == "do_commit")
            setattr(dialect, name, trapped)
    assert life.live() > 50


def test_any_call_of_the_store_may_fail(life: Life, monkeypatch: pytest.MonkeyPatch) -> None:
    store = life.context.histories
    for name in ("put", "read", "delete", "keys_older_than"):
        error = GenericError("the store is away")
        trapped = life.trap.around(getattr(store, name), error, lasting=name in ("put", "delete"))
        monkeypatch.setattr(store, name, trapped)
    assert life.live() >= 5
