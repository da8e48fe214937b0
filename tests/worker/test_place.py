"""Places for those who add peaks, of which there are only so many."""

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest
from sqlalchemy import func, select, text
from sqlalchemy.orm import Session
from structlog.testing import capture_logs

from app.db.models import STATISTICS, Peak
from app.db.session import Database
from tests.e2e.conftest import until
from tests.outcomes import succeed
from tests.worker.conftest import Submit
from worker import place
from worker.claim import claim

pytestmark = pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
WAITING = text("SELECT COUNT(*) FROM pg_locks WHERE locktype = 'advisory' AND NOT granted")
PATIENCE = text("SHOW lock_timeout")
PEAK = dict.fromkeys(STATISTICS, 0.0)


@pytest.fixture
def taken(database: Database) -> Iterator[Session]:
    """The transaction that has the only place."""
    with database.write() as session:
        place.take(session, 1)
        yield session


def take(database: Database, places: int) -> None:
    """Take a place and give it back; other locks are waited for as long as before."""
    with database.write() as session:
        patience = session.scalar(PATIENCE)
        place.take(session, places)
        assert session.scalar(PATIENCE) == patience


def test_who_finds_all_places_taken_waits_for_one(
    database: Database, taken: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(place, "PATIENCE_MS", 60_000)
    with ThreadPoolExecutor(1) as pool, capture_logs() as logged:
        following = pool.submit(take, database, 1)
        until(lambda: following.done() or taken.scalar(WAITING))
        assert not following.done()
        taken.commit()
        following.result()
    assert logged == []


@pytest.mark.usefixtures("taken")
def test_who_finds_one_free_takes_it(database: Database, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(place.secrets, "randbelow", lambda places: places - 1)
    with capture_logs() as logged:
        take(database, 2)
    assert logged == []


@pytest.mark.usefixtures("taken")
def test_who_waits_in_vain_writes_all_the_same(
    database: Database, submit: Submit, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(place, "PATIENCE_MS", 50)
    submit(300)
    with database.write() as session:
        (held,) = claim(session, "test", 15.0)
    peak = PEAK | {"quantity": "wheel_rail_force", "position": "wheelset_1", "unit": "N"}
    with capture_logs() as logged, database.write() as session:
        assert succeed(session, held, peaks=[peak], processing={}, history=None, cpu_s=1.0)
    take(database, 1)
    assert "all places taken for long" in [line["event"] for line in logged]
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Peak)) == 1
