"""What a worker says while it computes: that it lives, and how far it is."""

import threading
from types import TracebackType
from typing import Self

import structlog
from sqlalchemy.exc import SQLAlchemyError

from app.db.session import Database
from worker import lease

LONGEST_SILENCE_S = 1.0  # a client sees progress at least this often

log = structlog.get_logger()


class StoppedError(Exception):
    """The worker is to stop."""


class Heartbeat:
    """Extends a lease from a thread of its own for as long as the block runs.

    Parameters
    ----------
    database : Database
    held : Claim
    lease_s : float
        How long the lease is to last from each beat, s.
    stopping : threading.Event
        Set when the worker is to stop.
    """

    def __init__(self, database: Database, held: lease.Claim, lease_s: float, stopping: threading.Event) -> None:
        self._database, self._held, self._lease_s, self._stopping = database, held, lease_s, stopping
        self._fraction = 0.0
        self._lost = False
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._beat, name=f"heartbeat of case {held.case_id}", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._over.set()
        self._thread.join()

    def progress(self, fraction: float) -> None:
        """What the solver calls while it computes.

        Raises
        ------
        LeaseLostError
            If another worker has the case by now, or it was cancelled.
        StoppedError
            If this worker is to stop.
        """
        self._fraction = fraction
        if self._lost:
            raise lease.LeaseLostError
        if self._stopping.is_set():
            raise StoppedError

    def _beat(self) -> None:
        while not self._over.wait(min(self._lease_s / 3, LONGEST_SILENCE_S)):
            try:
                with self._database.write() as session:
                    alive = lease.extend(session, self._held, self._lease_s, self._fraction)
            except SQLAlchemyError as error:  # the database will say, once it is back, whether the lease held
                log.warning("heartbeat failed", case_id=self._held.case_id, error=str(error))
                continue
            if not alive:
                self._lost = True
                return
