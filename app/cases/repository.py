"""Cases in the database."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Row, insert, select, update
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
    charged: int
    """How many are computed because of this study."""
    end: int
    """The turn behind its last case."""


def enqueue(
    session: Session, rows: dict[str, dict[str, Any]], begin: int, *, keep_history: bool, charged_to: int | None
) -> Enqueued:
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
    charged_to : int, optional
        The key that asks.
    """
    known = {row.digest: row for digests in batches(sorted(rows)) for row in _lock_known(session, digests)}
    lacking = {digest for digest, row in known.items() if keep_history and row.state == "succeeded" and row.key is None}
    revived = lacking | {digest for digest, row in known.items() if row.state == "cancelled"}
    new = rows.keys() - known.keys()
    begun = {digest for digest, row in known.items() if row.state in UNFINISHED}
    queued = new | revived | begun
    waiting = [digest for digest in rows if digest in queued]
    turns = {digest: begin + n for n, digest in enumerate(waiting)}
    revive(session, [known[digest].id for digest in revived], charged_to)
    if places := list(_places(rows, known, revived, turns)):
        session.execute(update(Case), places)
    added = [rows[digest] | {"turn": turns[digest], "charged_to": charged_to} for digest in rows if digest in new]
    inserted = session.execute(insert(Case).returning(Case.digest, Case.id), added).all() if added else []
    return Enqueued(
        ids={row.digest: row.id for row in (*known.values(), *inserted)},
        reused=sum(row.state == "succeeded" for row in known.values()) - len(lacking),
        charged=len(revived) + len(new),
        end=begin + len(waiting),
    )


def _places(
    rows: dict[str, dict[str, Any]], known: dict[str, Row[Any]], revived: set[str], turns: dict[str, int]
) -> Iterable[dict[str, Any]]:
    """New places in the queue of cases that exist, where they come earlier now or are queued again."""
    for digest, turn in turns.items():
        if (row := known.get(digest)) is not None:
            priority = rows[digest]["priority"]
            if digest in revived or (-priority, turn) < (-row.priority, row.turn):
                yield {"id": row.id, "priority": priority, "turn": turn}


def _lock_known(session: Session, digests: list[str]) -> Iterable[Row[Any]]:
    """Cases that exist, locked until the study that wants them is visible to whoever finishes one of them."""
    return session.execute(
        select(Case.digest, Case.id, Case.state, Case.priority, Case.turn, History.key)
        .outerjoin(History, History.case_id == Case.id)
        .where(Case.digest.in_(digests), Case.solver_version == SOLVER_VERSION)
        .order_by(Case.digest)
        .with_for_update(key_share=True, of=Case)
    )
