"""A worker: claims cases until none is queued, computes each and writes down what came of it."""

import hashlib
import os
import socket
import threading
import time
from collections.abc import Callable
from functools import partial
from typing import Any

import structlog
from sqlalchemy.exc import InterfaceError, OperationalError
from sqlalchemy.orm import Session

from app.db.session import Database
from app.queue import Doorbell
from app.settings import Settings
from app.storage import HistoryStore
from solver.case import Case
from solver.errors import SolverError
from solver.peaks import peaks
from solver.processing import processing
from solver.simulate import Progress, Response, solve
from worker import lease
from worker.heartbeat import Heartbeat, StoppedError
from worker.history import archive
from worker.peak import peak_at_boundary

PATIENCE_S = 60.0  # for a database that is away when there is an outcome to write down

Outcome = Callable[[Session], bool]  # writes itself down, and says whether the lease still held

log = structlog.get_logger()


class Worker:
    """One worker with connections of its own: made in the process that uses it.

    Parameters
    ----------
    settings : Settings
    stopping : threading.Event
        Set when the worker is to stop; the case at hand is put back.
    """

    def __init__(self, settings: Settings, stopping: threading.Event) -> None:
        self.settings = settings
        self.stopping = stopping
        self.database = Database(settings.resolved_database_url)
        self.doorbell = Doorbell(settings)
        self.histories = HistoryStore(settings.resolved_storage_url)
        self.name = f"{socket.gethostname()}:{os.getpid()}"

    def drain(self) -> int:
        """Compute cases until none is queued or the worker is to stop. Returns how many."""
        computed = 0
        while not self.stopping.is_set() and (held := self._claim()) is not None:
            if not computed:
                self.doorbell.ring()  # where one case is queued there may be more: wake the next worker
            self.compute(held)
            computed += 1
        return computed

    def compute(self, held: lease.Claim) -> None:
        """Compute one case and write down the outcome."""
        with Heartbeat(self.database, held, self.settings.lease_s, self.stopping) as heartbeat:
            outcome = self._attempt(held, heartbeat.progress)
            if not self._write(outcome):
                log.warning("lease lost", case_id=held.case_id, attempt=held.attempt)

    def _claim(self) -> lease.Claim | None:
        with self.database.write() as session:
            return lease.claim(session, self.name, self.settings.lease_s)

    def _attempt(self, held: lease.Claim, progress: Progress) -> Outcome:
        began = time.process_time()
        try:
            (result,) = solve([Case.from_dict(held.inputs)], progress)
            if isinstance(result, SolverError):  # the same again, however often it were tried
                return partial(lease.fail, held=held, code=result.code, detail=str(result))
            rows, history = [peak_at_boundary(peak) for peak in peaks(result)], self._keep_history(held, result)
            cpu_s, record = time.process_time() - began, processing(result)
            return partial(lease.succeed, held=held, peaks=rows, processing=record, history=history, cpu_s=cpu_s)
        except StoppedError:
            return partial(lease.release, held=held)
        except lease.LeaseLostError:
            return lambda session: False
        except Exception as error:
            log.exception("attempt failed", case_id=held.case_id, attempt=held.attempt)
            reason = f"{type(error).__name__}: {error}"
            return partial(lease.give_up, held=held, max_attempts=self.settings.max_attempts, reason=reason)

    def _keep_history(self, held: lease.Claim, response: Response) -> dict[str, Any] | None:
        """Store the history, if a study asks for it, before the transaction that tells of it. Should that never
        come, the object is an orphan, which the sweeper collects.
        """
        with self.database.read() as session:
            if not lease.wants_history(session, held.case_id):
                return None
        content = archive(response)
        key = f"{held.digest}/{held.attempt}-{held.token}.npz"
        self.histories.put(key, content)
        return {"key": key, "digest": hashlib.sha256(content).hexdigest(), "size_bytes": len(content)}

    def _write(self, outcome: Outcome) -> bool:
        """Write an outcome down; while the database is away, wait for it rather than lose what was computed."""
        deadline = time.monotonic() + PATIENCE_S
        while True:
            try:
                with self.database.write() as session:
                    return outcome(session)
            except (OperationalError, InterfaceError) as error:
                if time.monotonic() > deadline:
                    raise
                log.warning("database unavailable", error=str(error))
                time.sleep(0.5)
