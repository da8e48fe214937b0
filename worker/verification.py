"""Verifications: stored cases computed once more, when nothing else is to be done.

They are leased like cases, so that one is not lost with its worker; nothing stored of the case is written to.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from uuid import uuid4

from sqlalchemy import ColumnElement, and_, or_, select, update
from sqlalchemy.orm import Session

from app.db.models import Case, Peak, Verification
from app.db.types import Clock
from app.verifications.schemas import TOLERANCE
from solver.version import SOLVER_VERSION
from worker.lease import Lease

VALUES = ("peak", "maximum", "minimum", "mean", "std", "rms")


@dataclass(frozen=True, kw_only=True)
class Claim(Lease):
    """A verification that a worker may compute until its lease runs out."""

    verification_id: int
    inputs: dict[str, Any]


def due() -> ColumnElement[bool]:
    """Whether a verification is to be computed: it is new, or its worker fell silent."""
    silent = and_(Verification.state == "running", Verification.lease_expires < Clock())
    return or_(Verification.state == "queued", silent)


def claim(session: Session, lease_s: float, max_attempts: int) -> Claim | None:
    """Take the oldest verification that is due; one that was tried too often is given up."""
    oldest = (
        select(Verification.id, Verification.case_id, Verification.attempt, Case.inputs)
        .join(Case, Case.id == Verification.case_id)
        .where(due())
        .order_by(Verification.id)
        .limit(1)
        .with_for_update(skip_locked=True, of=Verification)
    )
    row = session.execute(oldest).one_or_none()
    if row is None:
        return None
    held = Claim(
        verification_id=row.id, case_id=row.case_id, inputs=row.inputs, attempt=row.attempt + 1, token=uuid4().hex
    )
    values = {"state": "running", "attempt": held.attempt, "lease_token": held.token}
    session.execute(
        update(Verification).where(Verification.id == row.id).values(values | {"lease_expires": Clock() + lease_s})
    )
    if row.attempt >= max_attempts:
        fail(session, held, "poison", f"{row.attempt} attempts had no outcome")
        return claim(session, lease_s, max_attempts)
    return held


def extend(session: Session, claims: Sequence[Claim], lease_s: float, progress: Mapping[int, float]) -> set[int]:
    """Say that the worker lives. Returns the cases of the verifications whose leases hold."""
    alive = {"lease_expires": Clock() + lease_s}
    return {held.case_id for held in claims if _change(session, held, alive)}


def release(session: Session, held: Claim) -> bool:
    """Put it back as if it had not been claimed."""
    return _change(session, held, {"state": "queued", "lease_token": None, "attempt": held.attempt - 1})


def give_up(session: Session, held: Claim, max_attempts: int, reason: str, code: str = "poison") -> bool:
    """End an attempt that had no outcome: try it again or, after the last attempt, let it fail."""
    if held.attempt >= max_attempts:
        return fail(session, held, code, f"{held.attempt} attempts had no outcome; the last: {reason}")
    return _change(session, held, {"state": "queued", "lease_token": None})


def fail(session: Session, held: Claim, code: str, detail: str) -> bool:
    """Write down that the case cannot be computed any more."""
    return _finish(session, held, {"state": "failed", "error": {"code": code, "detail": detail}})


def compare(session: Session, held: Claim, computed: Iterable[Mapping[str, Any]]) -> bool:
    """Write down how the peaks of a case differ from those that are stored."""
    stored = [vars(peak) for peak in session.scalars(select(Peak).where(Peak.case_id == held.case_id))]
    found = differences(stored, computed)
    outcome = "same" if max(found.values(), default=0.0) <= TOLERANCE else "differs"
    return _finish(session, held, {"state": "succeeded", "outcome": outcome, "differences": found})


def differences(stored: Iterable[Mapping[str, Any]], computed: Iterable[Mapping[str, Any]]) -> dict[str, float]:
    """The largest relative difference of every stored quantity."""
    new = {(peak["quantity"], peak["position"]): peak for peak in computed}
    largest: dict[str, float] = {}
    for peak in stored:
        quantity = peak["quantity"]
        difference = _difference(peak, new.get((quantity, peak["position"])))
        largest[quantity] = max(largest.get(quantity, 0.0), difference)
    return largest


def _difference(old: Mapping[str, Any], new: Mapping[str, Any] | None) -> float:
    if new is None:
        return 1.0
    apart = max(abs(old[name] - new[name]) for name in VALUES)
    scale = max(abs(old[name]) for name in VALUES)
    return apart / scale if scale else float(apart > 0)


def _finish(session: Session, held: Claim, values: dict[str, Any]) -> bool:
    ended = {"lease_token": None, "finished_at": Clock(), "solver_version": SOLVER_VERSION}
    return _change(session, held, values | ended)


def _change(session: Session, held: Claim, values: dict[str, Any]) -> bool:
    row = update(Verification).where(Verification.id == held.verification_id, Verification.lease_token == held.token)
    return session.scalar(row.values(values).returning(Verification.id)) is not None
