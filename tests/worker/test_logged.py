"""A study is followed through the log by its identifier, from the request that created it to its last case."""

import json
import threading
from typing import Any

import pytest
from sqlalchemy import select, update

from app.context import Context
from app.db.models import Case
from tests.app.conftest import serving
from tests.worker.conftest import QUICK
from worker.compute import Worker
from worker.sweeper import sweep


def request(*amplitudes_mm: float) -> dict[str, Any]:
    irregularity = {"kind": "harmonic", "wavelength_m": [2.0], "amplitude_mm": list(amplitudes_mm)}
    sweep = {"kind": "product", "speed_kmh": [300], "irregularity": irregularity}
    return {"name": "A study", "sweep": sweep, "numerics": QUICK}


def test_a_study_is_followed_from_its_request_to_its_last_case(
    context: Context, capsys: pytest.CaptureFixture[str]
) -> None:
    with serving(context.settings) as client:
        answers = [
            client.post("/v1/studies", json=request(*amplitudes)) for amplitudes in ([0.1, 0.2, 0.3], [0.3, 0.4])
        ]
    first, second = (answer.json()["id"] for answer in answers)
    with context.database.write() as session:
        lost, *others = session.scalars(select(Case.id).order_by(Case.turn)).all()
        silent = {"state": "running", "attempt": 3, "lease_token": "t", "lease_expires": 1.0, "worker": "silent"}
        session.execute(update(Case).where(Case.id == lost).values(silent))
        sweep(session, max_attempts=3)
    worker = Worker(context.settings, threading.Event())
    assert worker.work() == 3
    worker.database.close()

    lines = [json.loads(line) for line in capsys.readouterr().err.splitlines() if first in line]
    created, expired, given_up, failed, begun, succeeded = lines
    assert (created["event"], created["study_id"]) == ("study created", first)
    assert created["request_id"] == answers[0].headers["x-request-id"]
    for line, event in ((expired, "lease expired"), (given_up, "attempt given up"), (failed, "case failed")):
        assert (line["event"], line["case_id"], line["study_ids"]) == (event, lost, [first])
    for line, event in ((begun, "cases begun"), (succeeded, "cases succeeded")):
        assert (line["event"], sorted(line["case_ids"])) == (event, sorted(others))
        assert line["study_ids"] == sorted([first, second])
