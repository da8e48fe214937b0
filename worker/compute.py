"""A worker: claims cases until none is queued, computes them and writes down what came of each."""

import hashlib
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from types import ModuleType
from typing import Any, TypeVar

import structlog
from sqlalchemy.exc import InterfaceError, InternalError, OperationalError
from sqlalchemy.orm import Session
from structlog.contextvars import bound_contextvars

from app import log as logs
from app.db.session import Database
from app.profiles.repository import UnknownProfileError, samples
from app.queue import Doorbell
from app.settings import Settings
from app.storage import STORE_ERRORS, HistoryStore, filename
from solver.case import Case
from solver.errors import SolverError
from solver.peaks import peaks
from solver.processing import processing
from solver.railhead import Samples
from solver.simd import MAX_LANES
from solver.simulate import Response, solve
from worker import lease, presence, verification
from worker.claim import Claim, claim
from worker.heartbeat import Heartbeat, StoppedError
from worker.history import archive
from worker.peak import peak_at_boundary
from worker.success import Success, wanting_history, write_down

AWAY = (OperationalError, InterfaceError, InternalError)  # what the database's being away ends in
PAUSE_S = 1.0  # between two looks whether what is away is back
BLAMELESS = (StoppedError, lease.LeaseLostError, *AWAY)  # what ends an attempt at a case that is not to blame

T = TypeVar("T")
Ending = Callable[[Session], bool]  # writes itself down, and says whether the lease still held
Outcome = Success | Ending

log = structlog.get_logger()


def _lost(session: Session) -> bool:
    """The outcome of a case that is no longer this worker's."""
    return False


class Worker:
    """One worker with connections of its own: made in the process that uses it.

    Parameters
    ----------
    settings : Settings
    stopping : threading.Event
        Set when the worker is to stop; the cases at hand are put back.
    draining : threading.Event, optional
        Set when the worker is to end once the cases at hand are finished.
    """

    def __init__(self, settings: Settings, stopping: threading.Event, draining: threading.Event | None = None) -> None:
        self.settings = settings
        self.stopping, self.draining = stopping, draining or threading.Event()
        self.database = Database(settings.resolved_database_url, settings.lease_s)
        self.doorbell = Doorbell(settings)
        self.histories = HistoryStore(settings.resolved_storage_url)
        self.name = presence.own_name()
        self.profiles = lru_cache(maxsize=4)(self._read_profile)  # cases of a study share them

    def work(self) -> int:
        """Compute cases until none is queued, the worker is to end or the database is away. Returns how many."""
        computed = 0
        try:
            while not (self.stopping.is_set() or self.draining.is_set()):
                if batch := self._claim():
                    if not computed:
                        self.doorbell.ring()  # where one case is queued there may be more: wake the next worker
                    self.compute(batch)
                    computed += len(batch)
                elif not self._verify():
                    break
        except AWAY as error:  # once it is back, the sweeper rings
            logs.unavailable("database", error)
        return computed

    def compute(self, batch: Sequence[Claim]) -> None:
        """Compute cases side by side and write down the outcome of each."""
        studies = sorted({study_id for held in batch for study_id in held.study_ids})
        with (
            bound_contextvars(case_ids=[held.case_id for held in batch], study_ids=studies),
            Heartbeat(self.database, batch, self.settings, self.stopping) as heartbeat,
        ):
            log.info("cases begun")
            outcomes = list(self._attempt(batch, heartbeat))
            successes = [outcome for _, outcome in outcomes if isinstance(outcome, Success)]
            written = self._write_together(successes, heartbeat) if successes else set()
            for held, outcome in outcomes:
                if isinstance(outcome, Success):
                    continue
                try:
                    if self._write(outcome, held, heartbeat):
                        written.add(held.case_id)
                except Exception:  # as above
                    log.exception("outcome not written", **held.logged())
        for held in batch:
            if held.case_id not in written:
                log.warning("nothing written, as the lease is lost or will be", **held.logged())

    def _write_together(self, successes: Sequence[Success], heartbeat: Heartbeat) -> set[int]:
        """Write successes down. Returns the cases of which that was done."""

        def write() -> set[int]:
            with self.database.write() as session:
                return write_down(session, successes, self.settings.writers)

        try:
            return self._patiently(write, [each.held for each in successes], heartbeat)
        except lease.LeaseLostError:
            return set()
        except Exception:  # one's lease will run out; its neighbours' outcomes are still to be written
            if len(successes) == 1:
                log.exception("outcome not written", **successes[0].held.logged())
                return set()
        return set().union(*(self._write_together([each], heartbeat) for each in successes))

    def _verify(self) -> bool:
        """Compute a stored case once more, if one is to be verified. Returns whether there was one."""
        with self.database.write() as session:
            held = verification.claim(session, self.settings.lease_s, self.settings.max_attempts)
        if held is None:
            return False
        with (
            bound_contextvars(case_id=held.case_id),
            suppress(StoppedError),
            Heartbeat(self.database, [held], self.settings, self.stopping, verification) as heartbeat,
        ):
            self._write(self._verified(held, heartbeat), held, heartbeat)
        return True

    def _verified(self, held: verification.Claim, heartbeat: Heartbeat) -> Ending:
        try:
            with heartbeat.limited(1):
                (result,) = solve([Case.from_dict(held.inputs, self.profiles)], partial(heartbeat.progress, [held]))
            if isinstance(result, SolverError):
                return partial(verification.fail, held=held, code=result.code, detail=str(result))
            return partial(verification.compare, held=held, computed=[peak_at_boundary(peak) for peak in peaks(result)])
        except Exception as error:
            return self._broken_off(held, error, verification)

    def _claim(self) -> list[Claim]:
        # Where one attempt is all a case has, none may lose it to a neighbour that kills the worker.
        lanes = MAX_LANES if self.settings.max_attempts > 1 else 1
        with self.database.write() as session:
            return claim(session, self.name, self.settings.lease_s, lanes)

    def _attempt(self, batch: Sequence[Claim], heartbeat: Heartbeat) -> Iterator[tuple[Claim, Outcome]]:
        """Compute cases side by side or, if that breaks, one by one, so that only the one to blame is charged."""
        began = time.process_time()
        try:
            heartbeat.progress(batch, 0.0)
            with heartbeat.limited(len(batch)):
                cases = [Case.from_dict(held.inputs, self.profiles) for held in batch]
                results = solve(cases, partial(heartbeat.progress, batch))
            kept = self._patiently(partial(self._wanting_history, batch), batch, heartbeat)
        except Exception as error:
            if len(batch) == 1 or isinstance(error, BLAMELESS):
                yield from ((held, self._broken_off(held, error)) for held in batch)
                return
            log.exception("attempt failed")
            results = []  # and on out of here: the exception keeps the memory of what it broke
        if not results:
            for held in batch:
                yield from self._attempt([held], heartbeat)
            return
        cpu_s = (time.process_time() - began) / len(batch)
        for held, result in zip(batch, results, strict=True):
            keeps = held.case_id in kept
            yield held, self._outcome(held, result, cpu_s, keeps, heartbeat) if heartbeat.holds(held) else _lost

    def _read_profile(self, profile_id: str) -> Samples:
        with self.database.read() as session:
            return samples(session, profile_id)

    def _outcome(
        self, held: Claim, result: Response | SolverError, cpu_s: float, keeps: bool, heartbeat: Heartbeat
    ) -> Outcome:
        """What came of a case, which took some processor time so far, and of which the history is kept or not."""
        if isinstance(result, SolverError):  # the same again, however often it were tried
            return partial(lease.fail, held=held, code=result.code, detail=str(result))
        began = time.process_time()
        try:
            rows = [peak_at_boundary(peak) for peak in peaks(result)]
            history = self._keep_history(held, result, heartbeat) if keeps else None
            record = processing(result)
        except Exception as error:
            return self._broken_off(held, error)
        cpu_s += time.process_time() - began
        ran_s = result.case.numerics.settle + result.case.numerics.window
        return Success(held=held, peaks=rows, processing=record, history=history, cpu_s=cpu_s, simulated_s=ran_s)

    def _broken_off(self, held: lease.Lease, error: Exception, ledger: ModuleType = lease) -> Ending:
        """The outcome of an attempt that an exception ended."""
        if isinstance(error, lease.LeaseLostError):
            return _lost
        if isinstance(error, BLAMELESS):
            return partial(ledger.release, held=held)
        if isinstance(error, UnknownProfileError):  # however often it were tried
            return partial(ledger.fail, held=held, code="profile-deleted", detail=str(error))
        log.error("attempt failed", **held.logged(), exc_info=error)
        code, reason = (
            "memory-limit" if isinstance(error, MemoryError) else "poison",
            f"{type(error).__name__}: {error}",
        )
        return partial(ledger.give_up, held=held, max_attempts=self.settings.max_attempts, reason=reason, code=code)

    def _wanting_history(self, batch: Sequence[Claim]) -> set[int]:
        with self.database.read() as session:
            return wanting_history(session, [held.case_id for held in batch])

    def _keep_history(self, held: Claim, response: Response, heartbeat: Heartbeat) -> dict[str, Any]:
        """Store the history before the transaction that tells of it. Should that never come, the object is an orphan,
        which the sweeper collects.
        """
        content = archive(response)
        key = f"{held.digest}/{held.attempt}-{held.token}.npz"
        self._patiently(partial(self.histories.put, key, content, filename(held.case_id)), [held], heartbeat)
        return {"key": key, "digest": hashlib.sha256(content).hexdigest(), "size_bytes": len(content)}

    def _write(self, outcome: Ending, held: lease.Lease, heartbeat: Heartbeat) -> bool:
        """Write an outcome down. False if the lease is lost."""

        def write() -> bool:
            with self.database.write() as session:
                return outcome(session)

        try:
            return self._patiently(write, [held], heartbeat)
        except lease.LeaseLostError:
            return False

    def _patiently(self, step: Callable[[], T], batch: Sequence[lease.Lease], heartbeat: Heartbeat) -> T:
        """What a step gives. While the database or the store is away, wait rather than lose what was computed.

        Raises
        ------
        LeaseLostError, StoppedError
            If there is nothing to wait for any more.
        """
        while True:
            try:
                return step()
            except AWAY as error:
                logs.unavailable("database", error)
            except STORE_ERRORS as error:
                logs.unavailable("history store", error)
            heartbeat.progress(batch, 1.0)
            self.stopping.wait(PAUSE_S)
