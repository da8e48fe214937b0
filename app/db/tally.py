"""What is counted for operators (docs/operations.md): in the transaction that makes it happen, so that it happens once
or not at all, whatever processes and hosts there are. Rows are added to at the very end of a transaction, always in the
same order, so that who counts neither waits long nor in a circle.
"""

from collections import Counter
from typing import Any, Literal

from sqlalchemy import select
from sqlalchemy.dialects import postgresql, sqlite
from sqlalchemy.orm import Session

from app.db.models import Tally

Name = Literal[
    "cases_requested",
    "cases_ended",
    "attempts_given_up",
    "leases_expired",
    "solver_cpu_s",
    "simulated_s",
    "lanes",
]

_INSERT: dict[str, Any] = {"sqlite": sqlite.insert, "postgresql": postgresql.insert}


def count(session: Session, name: Name, label: str = "", by: float = 1.0) -> None:
    """Add to a count when the transaction ends, if it does not fail."""
    session.info.setdefault("tally", Counter())[name, label] += by


def write(session: Session) -> None:
    """Write down what the transaction counted: the last that it does."""
    counted: Counter[tuple[str, str]] = session.info.pop("tally", Counter())
    rows = [{"name": name, "label": label, "value": value} for (name, label), value in sorted(counted.items()) if value]
    if rows:
        insert = _INSERT[session.get_bind().dialect.name](Tally)
        added = {"value": Tally.value + insert.excluded.value}
        session.execute(insert.values(rows).on_conflict_do_update(index_elements=["name", "label"], set_=added))


def read(session: Session) -> dict[tuple[str, str], float]:
    """All counts, by name and label."""
    return {(row.name, row.label): row.value for row in session.execute(select(Tally.name, Tally.label, Tally.value))}
