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

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import structlog
from sqlalchemy import select, update
from sqlalchemy.orm import Session

from app import events
from app.db import tally
from app.db.models import Case, CaseState, StudyCase
from app.db.types import Clock

log = structlog.get_logger()


@dataclass(frozen=True, kw_only=True)
class Lease:
    """The right to write to a running case."""

    case_id: int
    token: str
    attempt: int
    study_ids: Sequence[str] = ()  # that contain the case, for the log

    def logged(self) -> dict[str, Any]:
        """What a line of the log says of the case."""
        return {"case_id": self.case_id, "attempt": self.attempt, "study_ids": self.study_ids}


class LeaseLostError(Exception):
    """The case was given to another worker or cancelled."""


def studies_of(session: Session, case_ids: Collection[int]) -> Mapping[int, list[str]]:
    """The studies that contain cases, by case."""
    found = defaultdict(list)
    containing = select(StudyCase.case_id, StudyCase.study_id).where(StudyCase.case_id.in_(case_ids))
    for case_id, study_id in session.execute(containing.order_by(StudyCase.case_id, StudyCase.study_id)):
        found[case_id].append(study_id)
    return found


def lock(session: Session, leases: Sequence[Lease]) -> dict[int, Any]:
    """Keep others from changing the cases whose leases hold, until the transaction ends. Returns them by identifier.

    They are locked in the order of their digests, as by everyone who locks several.
    """
    tokens = {held.case_id: held.token for held in leases}
    rows = (
        select(Case.id, Case.lease_token, Case.speed_kmh, Case.percentile)
        .where(Case.id.in_(tokens), Case.state == "running")
        .order_by(Case.digest)
        .with_for_update(key_share=True)
    )
    return {row.id: row for row in session.execute(rows) if row.lease_token == tokens[row.id]}


def extend(session: Session, leases: Sequence[Lease], lease_s: float, progress: Mapping[int, float]) -> set[int]:
    """Say that the worker lives and how far its cases are. Returns the cases whose leases hold."""
    holding = set(lock(session, leases))
    alive = {"lease_expires": Clock() + lease_s, "heartbeat_at": Clock()}
    for fraction in {progress[case_id] for case_id in holding}:  # one, of cases that are computed side by side
        there = [case_id for case_id in holding if progress[case_id] == fraction]
        session.execute(update(Case).where(Case.id.in_(there)).values(alive | {"progress": fraction}))
    return holding


def fail(session: Session, held: Lease, code: str, detail: str) -> bool:
    """Write down that a case cannot be computed. False if the lease is lost."""
    if not _end(session, held, "failed", {"error": {"code": code, "detail": detail}}):
        return False
    log.warning("case failed", **held.logged(), code=code, detail=detail)
    events.cases_ended(session, [held.case_id], "failed")
    return True


def refuse(session: Session, case_id: int, code: str, detail: str) -> None:
    """Write down of a queued case, which the caller has locked, that nobody here can compute it."""
    values = {"state": "failed", "finished_at": Clock(), "error": {"code": code, "detail": detail}}
    session.execute(update(Case).where(Case.id == case_id).values(values))
    study_ids = studies_of(session, [case_id])[case_id]
    log.warning("case failed", case_id=case_id, study_ids=study_ids, code=code, detail=detail)
    events.cases_ended(session, [case_id], "failed")


def give_up(session: Session, held: Lease, max_attempts: int, reason: str, code: str = "poison") -> bool:
    """End an attempt that had no outcome: queue the case again or, after the last attempt, let it fail."""
    log.warning("attempt given up", **held.logged(), code=code, reason=reason)
    tally.count(session, "attempts_given_up", code)
    if held.attempt >= max_attempts:
        return fail(session, held, code, f"{held.attempt} attempts had no outcome; the last: {reason}")
    return _change(session, held, _QUEUED | {"error": {"code": "retried", "detail": reason}})


def release(session: Session, held: Lease) -> bool:
    """Put a case back as if it had not been claimed: the worker stops, and the case is not to blame."""
    log.info("case put back", **held.logged())
    return _change(session, held, _QUEUED | {"attempt": held.attempt - 1})


NO_LEASE: dict[str, Any] = {"lease_token": None, "lease_expires": None}
_QUEUED: dict[str, Any] = {**NO_LEASE, "state": "queued", "worker": None, "progress": 0.0}


def _end(session: Session, held: Lease, state: CaseState, values: dict[str, Any]) -> bool:
    return _change(session, held, {**NO_LEASE, "state": state, "finished_at": Clock(), **values})


def _change(session: Session, held: Lease, values: dict[str, Any]) -> bool:
    """Change a running case, if the token still holds."""
    row = update(Case).where(Case.id == held.case_id, Case.state == "running", Case.lease_token == held.token)
    return session.scalar(row.values(values).returning(Case.id)) is not None
