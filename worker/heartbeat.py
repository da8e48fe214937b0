"""What a worker says while it computes: that it lives, and how far it is."""

import threading
from collections.abc import Callable, Sequence
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
    """Extends the leases of a batch from a thread of its own for as long as the block runs.

    Parameters
    ----------
    database : Database
    batch : sequence of Lease
        The cases, in the order in which to lock them.
    lease_s : float
        How long a lease is to last from each beat, s.
    stopping : threading.Event
        Set when the worker is to stop.
    extend : callable
        Extends one lease; says whether it held.
    """

    def __init__(
        self,
        database: Database,
        batch: Sequence[lease.Lease],
        lease_s: float,
        stopping: threading.Event,
        extend: Callable[..., bool] = lease.extend,
    ) -> None:
        self._extend = extend
        self._database, self._lease_s, self._stopping = database, lease_s, stopping
        self._held = {held.case_id: held for held in batch}
        self._fractions = dict.fromkeys(self._held, 0.0)
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._run, name="heartbeat", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, traceback: TracebackType | None
    ) -> None:
        self._over.set()
        self._thread.join()

    def holds(self, held: lease.Lease) -> bool:
        """Whether the case was still this worker's at the last beat."""
        return held.case_id in self._held

    def progress(self, batch: Sequence[lease.Lease], fraction: float) -> None:
        """What the solver calls while it computes some of the cases.

        Raises
        ------
        LeaseLostError
            If other workers have all of them by now, or they were cancelled.
        StoppedError
            If this worker is to stop.
        """
        self._fractions.update((held.case_id, fraction) for held in batch)
        if not any(map(self.holds, batch)):
            raise lease.LeaseLostError
        if self._stopping.is_set():
            raise StoppedError

    def _run(self) -> None:
        while self._held and not self._over.wait(min(self._lease_s / 3, LONGEST_SILENCE_S)):
            try:
                lost = self._beat()
            except SQLAlchemyError as error:  # the database will say, once it is back, which leases held
                log.warning("heartbeat failed", case_ids=list(self._held), error=str(error))
                continue
            for case_id in lost:
                del self._held[case_id]

    def _beat(self) -> list[int]:
        """Extend what is held; the cases whose leases are lost, among them those whose outcome is written down."""
        with self._database.write() as session:
            return [
                case_id
                for case_id, held in self._held.items()
                if not self._extend(session, held, self._lease_s, self._fractions[case_id])
            ]
