"""The queue: rows of the table ``case``, claimed for a while by a worker that must keep saying it lives.

            claim                    succeed, fail
    queued ------> running (lease) ---------------> succeeded, failed
       ^              |
       +--------------+  release, give_up, lease expired

Either of the first two becomes cancelled when no live study wants it any more, and each of the last three can be
queued again (app/cases/queue.py). Where nobody can compute it, what is queued fails without having run (refuse).

Every claim has a token. Whoever writes to a running case must hold it; a worker that was given up on, and
comes back late, finds it changed and writes nothing.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import delete, exists, insert, select, update
from sqlalchemy.orm import Session

from app import events
from app.db.models import Case, CaseState, History, Peak, Study, StudyCase
from app.db.types import Clock


@dataclass(frozen=True, kw_only=True)
class Lease:
    """The right to write to a running case."""

    case_id: int
    token: str
    attempt: int


class LeaseLostError(Exception):
    """The case was given to another worker or cancelled."""


def extend(session: Session, held: Lease, lease_s: float, progress: float) -> bool:
    """Say that the worker lives and how far it is. False if the lease is lost."""
    values = {"lease_expires": Clock() + lease_s, "heartbeat_at": Clock(), "progress": progress}
    return _change(session, held, values)


def wants_history(session: Session, case_id: int) -> bool:
    """Whether some study asks to keep this case's history, and none is kept."""
    wanting = (
        select(Study.id)
        .join(StudyCase, StudyCase.study_id == Study.id)
        .where(StudyCase.case_id == case_id, Study.keep_history, events.LIVE)
    )
    kept = select(History.case_id).where(History.case_id == case_id)
    return bool(session.scalar(select(exists(wanting) & ~exists(kept))))


def succeed(
    session: Session,
    held: Lease,
    peaks: Sequence[dict[str, Any]],
    processing: dict[str, Any],
    history: dict[str, Any] | None,
    cpu_s: float,
) -> bool:
    """Write down all that came of a case. False, and nothing is written, if the lease is lost.

    Parameters
    ----------
    session : Session
        The transaction.
    held : Lease
        The case.
    peaks : sequence of dict
        Columns of the table ``peak``.
    processing : dict
        How the peaks were derived.
    history : dict, optional
        Columns of the table ``history``, of an object that is already stored.
    cpu_s : float
        Processor time, s.
    """
    if not _lock(session, held):
        return False
    if history is None and wants_history(session, held.case_id):  # since a moment ago: computed once more
        return release(session, held)
    _end(session, held, "succeeded", {"progress": 1.0, "cpu_s": cpu_s, "processing": processing, "error": None})
    session.execute(delete(Peak).where(Peak.case_id == held.case_id))
    case = session.execute(select(Case.speed_kmh, Case.percentile).where(Case.id == held.case_id)).one()
    if rows := [{"case_id": held.case_id, **case._mapping, **peak} for peak in peaks]:
        session.execute(insert(Peak), rows)
    if history is not None:
        session.execute(delete(History).where(History.case_id == held.case_id))
        session.execute(insert(History), {"case_id": held.case_id, **history})
    events.case_ended(session, held.case_id, "succeeded")
    return True


def fail(session: Session, held: Lease, code: str, detail: str) -> bool:
    """Write down that a case cannot be computed. False if the lease is lost."""
    if not _end(session, held, "failed", {"error": {"code": code, "detail": detail}}):
        return False
    events.case_ended(session, held.case_id, "failed")
    return True


def refuse(session: Session, case_id: int, code: str, detail: str) -> None:
    """Write down of a queued case, which the caller has locked, that nobody here can compute it."""
    values = {"state": "failed", "finished_at": Clock(), "error": {"code": code, "detail": detail}}
    session.execute(update(Case).where(Case.id == case_id).values(values))
    events.case_ended(session, case_id, "failed")


def give_up(session: Session, held: Lease, max_attempts: int, reason: str, code: str = "poison") -> bool:
    """End an attempt that had no outcome: queue the case again or, after the last attempt, let it fail."""
    if held.attempt >= max_attempts:
        return fail(session, held, code, f"{held.attempt} attempts had no outcome; the last: {reason}")
    return _change(session, held, _QUEUED | {"error": {"code": "retried", "detail": reason}})


def release(session: Session, held: Lease) -> bool:
    """Put a case back as if it had not been claimed: the worker stops, and the case is not to blame."""
    return _change(session, held, _QUEUED | {"attempt": held.attempt - 1})


_NO_LEASE: dict[str, Any] = {"lease_token": None, "lease_expires": None}
_QUEUED: dict[str, Any] = {**_NO_LEASE, "state": "queued", "worker": None, "progress": 0.0}


def _lock(session: Session, held: Lease) -> bool:
    """Keep others from changing the case, if the token still holds. A study that comes to want it waits too."""
    row = select(Case.id).where(Case.id == held.case_id, Case.state == "running", Case.lease_token == held.token)
    return session.scalar(row.with_for_update(key_share=True)) is not None


def _end(session: Session, held: Lease, state: CaseState, values: dict[str, Any]) -> bool:
    return _change(session, held, {**_NO_LEASE, "state": state, "finished_at": Clock(), **values})


def _change(session: Session, held: Lease, values: dict[str, Any]) -> bool:
    """Change a running case, if the token still holds."""
    row = update(Case).where(Case.id == held.case_id, Case.state == "running", Case.lease_token == held.token)
    return session.scalar(row.values(values).returning(Case.id)) is not None
