"""What is left at the end: the database and the history store, boiled down to what the checker asks about."""

import hashlib
import io
from collections import defaultdict
from functools import cache
from typing import Any

import numpy as np
from obstore.exceptions import NotFoundError
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.cases.schemas import CaseFile
from app.db.models import Case, History, Peak, StudyCase, Verification
from app.db.session import Database
from app.storage import HistoryStore
from app.studies import repository
from solver.peaks import peaks
from solver.simulate import Response, solve
from tests.chaos.clients import NUMERICS, WINDOWS_S

Remains = dict[str, list[dict[str, Any]]]


def collect(database: Database, store: HistoryStore) -> Remains:
    """Studies, cases and histories as they are."""
    with database.read() as session:
        return {
            "studies": _studies(session),
            "cases": _cases(session),
            "histories": [_history(row, store) for row in session.scalars(select(History))],
            "verifications": [
                {"case_id": row.case_id, "state": row.state, "outcome": row.outcome}
                for row in session.scalars(select(Verification))
            ],
        }


@cache
def complete_set() -> str:
    """The fingerprint of a complete set of peaks: which there are does not depend on the numbers."""
    case = {"speed_kmh": 300.0, "irregularity": {"kind": "harmonic", "wavelength_m": 2.0, "amplitude_mm": 0.1}}
    numerics = {"numerics": NUMERICS | {"window_s": WINDOWS_S[0]}}
    (response,) = solve([CaseFile.model_validate(case | numerics).to_case()])
    assert isinstance(response, Response)
    return _fingerprint([(peak.quantity, peak.position) for peak in peaks(response)])


def _fingerprint(names: list[tuple[str, str]]) -> str:
    """Of names, each as often as it occurs."""
    return hashlib.sha256(repr(sorted(names)).encode()).hexdigest()[:16]


def _studies(session: Session) -> list[dict[str, Any]]:
    cases = defaultdict(list)
    for row in session.execute(select(StudyCase.study_id, StudyCase.case_id)):
        cases[row.study_id].append(row.case_id)
    return [
        {
            "id": row.Study.id,
            "name": row.Study.name,
            "state": row.state,
            "keep_history": row.Study.keep_history,
            "cases": cases[row.Study.id],
        }
        for row in session.execute(repository.overview())
    ]


def _cases(session: Session) -> list[dict[str, Any]]:
    names = defaultdict(list)
    for row in session.execute(select(Peak.case_id, Peak.quantity, Peak.position)):
        names[row.case_id].append((row.quantity, row.position))
    return [
        {
            "id": row.id,
            "state": row.state,
            "attempt": row.attempt,
            "error": row.error and row.error["code"],
            "peaks": len(names[row.id]),
            "set": _fingerprint(names[row.id]),
        }
        for row in session.execute(select(Case.id, Case.state, Case.attempt, Case.error))
    ]


def _history(row: History, store: HistoryStore) -> dict[str, Any]:
    try:
        content = b"".join(store.read(row.key))
    except NotFoundError:
        return {"case_id": row.case_id, "key": row.key, "found": "nothing"}
    if hashlib.sha256(content).hexdigest() != row.digest:
        return {"case_id": row.case_id, "key": row.key, "found": "other bytes"}
    with np.load(io.BytesIO(content)) as archive:
        whole = bool(np.isfinite(archive["values"]).all()) and archive["values"].size > 0
    return {"case_id": row.case_id, "key": row.key, "found": "history" if whole else "no numbers"}
