"""Cases in the database."""

from collections.abc import Iterable, Iterator
from typing import Any, TypeVar

from sqlalchemy import Row, insert, select, update
from sqlalchemy.orm import Session

from app.cases.schemas import conditions
from app.db.models import Case, History
from solver.case import Case as SolverCase
from solver.version import SOLVER_VERSION

T = TypeVar("T")
BATCH = 1000  # well below what either database takes as parameters of one statement


def row_of(case: SolverCase, priority: int) -> dict[str, Any]:
    """The columns of a new case."""
    inputs = case.to_dict()
    return {
        "digest": case.digest(),
        "solver_version": SOLVER_VERSION,
        "operator_key": case.operator_key(),
        "inputs": inputs,
        "priority": priority,
        **conditions(inputs),
    }


def enqueue(session: Session, rows: dict[str, dict[str, Any]], *, keep_history: bool) -> tuple[dict[str, int], int]:
    """Queue the cases nobody has asked for before.

    Parameters
    ----------
    session
        The transaction.
    rows : dict
        Columns of the cases by digest, all of one priority.
    keep_history : bool
        Whether a case that was computed without keeping its history is to be computed once more.

    Returns
    -------
    ids : dict
        Identifier of every case by digest, new or not.
    reused : int
        How many of them are already computed.
    """
    known = {row.digest: row for digests in _batches(sorted(rows)) for row in _lock_known(session, digests)}
    _revive(session, [row.id for row in known.values() if row.state == "cancelled"])
    lacking = [row.id for row in known.values() if keep_history and row.state == "succeeded" and row.key is None]
    _revive(session, lacking)
    if rows:
        priority = next(iter(rows.values()))["priority"]
        _raise_priority(session, [row.id for row in known.values()], priority)
    new = [row for digest, row in rows.items() if digest not in known]
    inserted = session.execute(insert(Case).returning(Case.digest, Case.id), new).all() if new else []
    ids = {row.digest: row.id for row in known.values()} | {row.digest: row.id for row in inserted}
    return ids, sum(row.state == "succeeded" for row in known.values()) - len(lacking)


def _batches(items: Iterable[T]) -> Iterator[list[T]]:
    everything = list(items)
    return (everything[n : n + BATCH] for n in range(0, len(everything), BATCH))


def _lock_known(session: Session, digests: list[str]) -> Iterable[Row[Any]]:
    """Cases that exist, locked until the study that wants them is visible to whoever finishes one of them.

    In the order of their digests, as whoever locks several cases must, or two would wait for each other in a circle.
    """
    return session.execute(
        select(Case.digest, Case.id, Case.state, History.key)
        .outerjoin(History, History.case_id == Case.id)
        .where(Case.digest.in_(digests), Case.solver_version == SOLVER_VERSION)
        .order_by(Case.digest)
        .with_for_update(key_share=True, of=Case)
    )


def _revive(session: Session, ids: list[int]) -> None:
    nothing = dict.fromkeys(("error", "processing", "started_at", "finished_at"))
    anew = {"state": "queued", "attempt": 0, "progress": 0.0, **nothing}
    for batch in _batches(ids):
        session.execute(update(Case).where(Case.id.in_(batch)).values(anew))


def _raise_priority(session: Session, ids: list[int], priority: int) -> None:
    for batch in _batches(ids):
        session.execute(update(Case).where(Case.id.in_(batch), Case.priority < priority).values(priority=priority))
