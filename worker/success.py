"""Cases that succeeded: all that came of them is written down in one transaction, that of several cases together."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import structlog
from sqlalchemy import ARRAY, Connection, bindparam, delete, exists, func, insert, select, update
from sqlalchemy.orm import Session

from app import events
from app.db import tally
from app.db.models import Case, History, Peak, Study, StudyCase
from app.db.types import Clock
from worker import place
from worker.lease import NO_LEASE, Lease, lock, release

_PEAK_COLUMNS = {column.name: column.type for column in Peak.__table__.columns if column.name != "id"}
_PEAKS_OF_COLUMNS = insert(Peak).from_select(
    list(_PEAK_COLUMNS),
    select(*(func.unnest(bindparam(name, type_=ARRAY(kind))) for name, kind in _PEAK_COLUMNS.items())),
)
_SUCCEEDED = (
    update(Case)
    .where(Case.id == bindparam("ended_id"))
    .values(NO_LEASE | {"state": "succeeded", "finished_at": Clock(), "progress": 1.0, "error": None})
    .values(cpu_s=bindparam("ended_cpu_s"), processing=bindparam("ended_processing"))
)

log = structlog.get_logger()


def wanting_history(session: Session, case_ids: Collection[int]) -> set[int]:
    """Those of the cases whose history some study asks to keep, and of which none is kept."""
    kept = select(History.case_id).where(History.case_id == StudyCase.case_id)
    wanting = (
        select(StudyCase.case_id)
        .join(Study, Study.id == StudyCase.study_id)
        .where(StudyCase.case_id.in_(case_ids), Study.keep_history, events.LIVE, ~exists(kept))
    )
    return set(session.scalars(wanting))


@dataclass(frozen=True, kw_only=True)
class Success:
    """All that came of a case.

    Attributes
    ----------
    held : Lease
        The case.
    peaks : sequence of dict
        Columns of the table ``peak``.
    processing : dict
        How the peaks were derived.
    history : dict, optional
        Columns of the table ``history``, of an object that is already stored.
    cpu_s, simulated_s : float
        Processor time, and time that the train ran, s.
    """

    held: Lease
    peaks: Sequence[dict[str, Any]]
    processing: dict[str, Any]
    history: dict[str, Any] | None
    cpu_s: float
    simulated_s: float

    def end(self) -> dict[str, Any]:
        """Values of the statement that ends the case."""
        return {"ended_id": self.held.case_id, "ended_cpu_s": self.cpu_s, "ended_processing": self.processing}

    def rows(self, case: Any) -> Iterator[dict[str, Any]]:
        """Rows of the table ``peak``."""
        of_case = {"case_id": case.id, "speed_kmh": case.speed_kmh, "percentile": case.percentile}
        return (of_case | peak for peak in self.peaks)


def write_down(session: Session, successes: Sequence[Success], places: int) -> set[int]:
    """Write down what came of cases.

    Parameters
    ----------
    session : Session
        The transaction.
    successes : sequence of Success
        In the order in which to lock the cases, that of their digests.
    places : int
        How many transactions may add peaks at once, on PostgreSQL.

    Returns
    -------
    set of int
        The cases whose leases held. A case whose history was not kept, and is wanted since a moment ago, is queued
        once more.
    """
    cases = lock(session, [each.held for each in successes])
    held = [each for each in successes if each.held.case_id in cases]
    wanting = wanting_history(session, cases)
    late = [each for each in held if each.history is None and each.held.case_id in wanting]
    for each in late:
        release(session, each.held)
    if done := [each for each in held if each not in late]:
        _end(session, done, cases, places)
    return set(cases)


def _end(session: Session, done: Sequence[Success], cases: Mapping[int, Any], places: int) -> None:
    ids = [each.held.case_id for each in done]
    connection = session.connection()
    connection.execute(_SUCCEEDED, [each.end() for each in done])
    session.execute(delete(Peak).where(Peak.case_id.in_(ids)))
    place.take(session, places)
    _insert_peaks(connection, [row for each in done for row in each.rows(cases[each.held.case_id])])
    if kept := [{"case_id": each.held.case_id, **each.history} for each in done if each.history is not None]:
        session.execute(delete(History).where(History.case_id.in_([row["case_id"] for row in kept])))
        session.execute(insert(History), kept)
    log.info("cases succeeded", case_ids=ids)
    tally.count(session, "solver_cpu_s", by=sum(each.cpu_s for each in done))
    tally.count(session, "simulated_s", by=sum(each.simulated_s for each in done))
    events.cases_ended(session, ids, "succeeded")


def _insert_peaks(connection: Connection, rows: Sequence[dict[str, Any]]) -> None:
    """Many at once: PostgreSQL prefers them as the columns of one statement."""
    if not rows:
        return
    if connection.dialect.name == "postgresql":
        connection.execute(_PEAKS_OF_COLUMNS, {name: [row[name] for row in rows] for name in _PEAK_COLUMNS})
    else:
        connection.execute(insert(Peak), rows)
