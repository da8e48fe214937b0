"""What a crash leaves behind: leases that ran out, bells that were lost, histories nobody tells of."""

import math
import threading
import time

import structlog
from sqlalchemy import delete, exists, select, update
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from app import log as logs
from app.db import tally
from app.db.models import Case, History, IdempotencyKey, Verification
from app.db.session import Database
from app.db.types import Clock
from app.idempotency import KEPT_S
from app.queue import Doorbell
from app.settings import Settings
from app.storage import STORE_ERRORS, HistoryStore
from worker import lease, presence, verification
from worker.adopt import adopt
from worker.retention import expire

LONGEST_PAUSE_S = 5.0
ON_DUTY = 8  # workers: where there are thousands, they would look for the same all the time
ORPHANED_AFTER_S = 3600.0
EXPIRE_EVERY_S = 3600.0
SET_BACK_S = 1.0  # a clock that differs by less is merely being adjusted

log = structlog.get_logger()


def sweep(session: Session, max_attempts: int, *, forbearing: bool = False) -> bool:
    """Queue again, or call poison, the cases of workers that fell silent. Returns whether there is work.

    Any number of sweepers may do this at once.

    Parameters
    ----------
    session : Session
        The transaction.
    max_attempts : int
        After how many attempts a case is called poison.
    forbearing : bool
        Whether to leave the silent alone for now: nobody could say that he lives.
    """
    _shorten(session)
    if not forbearing:
        _take_back(session, max_attempts)
    presence.forget(session)
    session.execute(delete(IdempotencyKey).where(IdempotencyKey.created_at < Clock() - KEPT_S))
    adopt(session)
    queued, due = select(Case.id).where(Case.state == "queued"), select(Verification.id).where(verification.due())
    return bool(session.scalar(select(exists(queued) | exists(due))))


def _shorten(session: Session) -> None:
    """A lease given before the database's clock was set back ends that much too late: let it begin anew."""
    ahead = Case.state == "running", Case.heartbeat_at > Clock() + SET_BACK_S
    anew = {"heartbeat_at": Clock(), "lease_expires": Clock() + Case.lease_expires - Case.heartbeat_at}
    session.execute(update(Case).where(*ahead).values(anew))


def _take_back(session: Session, max_attempts: int) -> None:
    silent = (
        select(Case.id, Case.lease_token, Case.attempt, Case.worker)
        .where(Case.state == "running", Case.lease_expires < Clock())
        .with_for_update(skip_locked=True, key_share=True)
    )
    rows = session.execute(silent).all()
    studies = lease.studies_of(session, [row.id for row in rows]) if rows else {}
    for row in rows:
        held = lease.Lease(case_id=row.id, token=row.lease_token, attempt=row.attempt, study_ids=studies[row.id])
        log.warning("lease expired", **held.logged(), worker=row.worker)
        tally.count(session, "leases_expired")
        lease.give_up(session, held, max_attempts, f"worker {row.worker} fell silent")


def collect_orphans(database: Database, histories: HistoryStore) -> int:
    """Delete old objects of the history store that no row tells of, and none will. Returns how many.

    None will once the lease is gone under which the object was written: a worker may have waited for the database.
    """
    with database.read() as session:  # and no longer: a store may take its time
        held = session.scalars(select(Case.lease_token).where(Case.state == "running")).all()
        told = set(session.scalars(select(History.key)))
    old = [key for key in histories.keys_older_than(ORPHANED_AFTER_S) if key not in told]
    orphans = [key for key in old if not any(str(token) in key for token in held)]
    for key in orphans:
        histories.delete(key)
    return len(orphans)


class Sweeper:
    """Says every few seconds that this worker is there, and sweeps, in a thread for as long as the process lives.

    Every worker has one, so that there is one wherever there is anybody to do the work; of many, a few sweep.

    Parameters
    ----------
    settings : Settings
    able : bool
        Whether the worker can compute.
    draining : threading.Event, optional
        Set when the worker takes no more cases.
    """

    def __init__(self, settings: Settings, *, able: bool = True, draining: threading.Event | None = None) -> None:
        self._settings, self._able, self._draining = settings, able, draining or threading.Event()
        self._database = Database(settings.resolved_database_url, settings.lease_s)
        self._doorbell = Doorbell(settings)
        self._pause_s = min(settings.lease_s / 3, LONGEST_PAUSE_S)
        self._collected_at = self._expired_at = -math.inf
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run, name="sweeper", daemon=True)

    def start(self) -> None:
        """Begin."""
        self._thread.start()

    def stop(self) -> None:
        """End, once the sweep at hand is done."""
        self._over.set()
        self._thread.join()
        self._database.close()

    def _run(self) -> None:
        was_away = True  # the database, maybe: once it is back, workers first need the time to say that they live
        while True:
            try:
                self._sweep(forbearing=was_away)
                was_away = False
            except SQLAlchemyError as error:
                was_away = True
                logs.unavailable("database", error)
            except STORE_ERRORS as error:
                logs.unavailable("history store", error)
            except Exception:  # whatever is wrong, the next sweep may do some good
                log.exception("sweep failed")
            if self._over.wait(self._pause_s):
                return

    def _sweep(self, *, forbearing: bool) -> None:
        name = presence.own_name()
        with self._database.write() as session:
            if self._able:
                presence.announce(session, name, 3 * self._pause_s, self._draining.is_set())
            if not presence.is_among_the_first(session, name, ON_DUTY):
                return
            queued = sweep(session, self._settings.max_attempts, forbearing=forbearing)
        if queued:
            self._doorbell.ring()
        if self._settings.retention_days and time.monotonic() - self._expired_at > EXPIRE_EVERY_S:
            with self._database.write() as session:
                if not expire(session, self._settings.retention_days):  # or the next sweep goes on
                    self._expired_at = time.monotonic()
        if time.monotonic() - self._collected_at > ORPHANED_AFTER_S:
            self._collected_at = time.monotonic()
            self._collect()

    def _collect(self) -> None:
        histories = HistoryStore(self._settings.resolved_storage_url)
        histories.remove_pieces_older_than(ORPHANED_AFTER_S)
        collect_orphans(self._database, histories)
