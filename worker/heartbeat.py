"""What a worker says while it computes: that it lives, how far it is, and that a case takes too long."""

import faulthandler
import math
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import copy_context
from types import ModuleType, TracebackType
from typing import Self

from sqlalchemy.exc import SQLAlchemyError

from app import log
from app.db.session import Database
from app.settings import Settings
from worker import lease

LONGEST_SILENCE_S = 1.0  # a client sees progress at least this often
SPARINGLY = 10  # times as long as a beat takes, a worker waits: many can keep a database busy with nothing else
HANGS_AFTER_S = 300.0  # without a report of progress, which takes seconds on the largest mesh
STANDARD_ERROR = 2  # the file descriptor, whatever stands in for it in Python
TOGETHER = 3  # times as long as one case take those side by side, however many


class StoppedError(Exception):
    """The worker is to stop."""


class Heartbeat:
    """Extends the leases of a batch from a thread of its own for as long as the block runs.

    Parameters
    ----------
    database : Database
    batch : sequence of Lease
        The cases, in the order in which to lock them.
    settings : Settings
    stopping : threading.Event
        Set when the worker is to stop.
    ledger : module
        Where it is written down: ``lease`` or ``verification``.
    """

    def __init__(
        self,
        database: Database,
        batch: Sequence[lease.Lease],
        settings: Settings,
        stopping: threading.Event,
        ledger: ModuleType = lease,
    ) -> None:
        self._database, self._settings, self._stopping, self._ledger = database, settings, stopping, ledger
        self._pause_s = min(settings.lease_s / 3, LONGEST_SILENCE_S)
        self._held = {held.case_id: held for held in batch}
        self._fractions = dict.fromkeys(self._held, 0.0)
        self._deadline = self._leash_s = math.inf
        self._over = threading.Event()
        context = copy_context()  # what the thread logs tells of the same cases
        self._thread = threading.Thread(target=context.run, args=[self._run], name="heartbeat", daemon=True)

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
        self._watch()
        if not any(map(self.holds, batch)):
            raise lease.LeaseLostError
        if self._stopping.is_set():
            raise StoppedError

    @contextmanager
    def limited(self, cases: int) -> Iterator[None]:
        """While so many cases are computed: those that take too long are given up, and if the solver hangs, so that it
        does not hear of that, the process is ended.
        """
        limit_s = min(cases, TOGETHER) * self._settings.case_time_limit_s
        self._deadline = time.monotonic() + limit_s
        self._leash_s = min(limit_s + self._settings.lease_s, HANGS_AFTER_S)
        self._watch()
        try:
            yield
        finally:
            self._deadline = self._leash_s = math.inf
            faulthandler.cancel_dump_traceback_later()

    def _watch(self) -> None:
        """Let the process end, and its log tell where it hung, unless this is called again in time. The watchdog does
        not wait for Python's lock, which compiled code may hold.
        """
        if self._leash_s < math.inf:
            faulthandler.dump_traceback_later(self._leash_s, exit=True, file=STANDARD_ERROR)

    def _run(self) -> None:
        pause_s = self._pause_s
        while self._held and not self._over.wait(pause_s):
            began = time.monotonic()
            try:
                lost = self._beat() if began < self._deadline else self._give_up()
            except (SQLAlchemyError, MemoryError) as error:  # the database will say, once it is back, which leases held
                log.unavailable("database", error)
                continue
            for case_id in lost:
                del self._held[case_id]
            took_s = time.monotonic() - began
            pause_s = min(max(self._pause_s, SPARINGLY * took_s), self._settings.lease_s / 3)

    def _beat(self) -> list[int]:
        """Extend what is held; the cases whose leases are lost, among them those whose outcome is written down."""
        with self._database.write() as session:
            leases, lease_s = list(self._held.values()), self._settings.lease_s
            holding = self._ledger.extend(session, leases, lease_s, dict(self._fractions))
        return [case_id for case_id in self._held if case_id not in holding]

    def _give_up(self) -> list[int]:
        """End the attempts at what is held."""
        attempts, reason = self._settings.max_attempts, f"it took longer than {self._settings.case_time_limit_s:g} s"
        with self._database.write() as session:
            for held in self._held.values():
                self._ledger.give_up(session, held, attempts, reason, "time-limit")
        return list(self._held)
