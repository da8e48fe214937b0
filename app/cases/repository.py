"""Cases in the database."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Row, insert, select
from sqlalchemy.orm import Session

from app.cases.queue import UNFINISHED, batches, revive
from app.cases.schemas import conditions
from app.db.models import Case, History
from solver.case import Case as SolverCase
from solver.version import SOLVER_VERSION


def work(case: SolverCase) -> float:
    """What a case's processor time is about proportional to: unknowns times time steps."""
    n = case.numerics
    return 6.0 * case.cells * n.elements_per_pad * (n.settle + n.window) / case.time_step


def row_of(case: SolverCase, priority: int) -> dict[str, Any]:
    """The columns of a new case."""
    inputs = case.to_dict(samples=False)
    return {
        "digest": case.digest(),
        "solver_version": SOLVER_VERSION,
        "operator_key": case.operator_key(),
        "inputs": inputs,
        "work": work(case),
        "priority": priority,
        **conditions(inputs),
    }


@dataclass(frozen=True)
class Enqueued:
    """What became of the cases of a study."""

    ids: dict[str, int]
    """Identifier of every case by digest, new or not."""
    reused: int
    """How many are already computed."""
    to_line_up: list[int]
    """Cases that existed, and come earlier now or are queued again."""


def enqueue(session: Session, rows: dict[str, dict[str, Any]], begin: int, *, keep_history: bool) -> Enqueued:
    """Queue the cases nobody has asked for before.

    Parameters
    ----------
    session
        The transaction.
    rows : dict
        Columns of the cases by digest, all of one priority.
    begin : int
        Turn of the first.
    keep_history : bool
        Whether a case that was computed without keeping its history is to be computed once more.
    """
    known = {row.digest: row for digests in batches(sorted(rows)) for row in _lock_known(session, digests)}
    lacking = [row.id for row in known.values() if keep_history and row.state == "succeeded" and row.key is None]
    revived = [row.id for row in known.values() if row.state == "cancelled"] + lacking
    revive(session, revived)
    turns = {digest: begin + n for n, digest in enumerate(rows)}
    new = [row | {"turn": turns[digest]} for digest, row in rows.items() if digest not in known]
    inserted = session.execute(insert(Case).returning(Case.digest, Case.id), new).all() if new else []
    ids = {row.digest: row.id for row in known.values()} | {row.digest: row.id for row in inserted}
    earlier = [
        row.id
        for digest, row in known.items()
        if row.state in UNFINISHED and (-rows[digest]["priority"], turns[digest]) < (-row.priority, row.turn)
    ]
    reused = sum(row.state == "succeeded" for row in known.values()) - len(lacking)
    return Enqueued(ids, reused, revived + earlier)


def _lock_known(session: Session, digests: list[str]) -> Iterable[Row[Any]]:
    """Cases that exist, locked until the study that wants them is visible to whoever finishes one of them."""
    return session.execute(
        select(Case.digest, Case.id, Case.state, Case.priority, Case.turn, History.key)
        .outerjoin(History, History.case_id == Case.id)
        .where(Case.digest.in_(digests), Case.solver_version == SOLVER_VERSION)
        .order_by(Case.digest)
        .with_for_update(key_share=True, of=Case)
    )
