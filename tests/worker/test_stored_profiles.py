"""A worker computes what runs over a stored profile, as `tracksweep solve` does over the file."""

import json
import threading
from pathlib import Path
from typing import Any

import pytest
from sqlalchemy import delete, select

from app.access.caller import ANYBODY
from app.context import Context
from app.db.models import Case, Peak, Profile, StudyProfile
from app.problems import Problem
from app.profiles import service as profiles
from app.studies import lifecycle
from app.studies import service as studies
from app.studies.schemas import StudyRequest
from app.verifications import service as verifications
from solver.peaks import peaks
from solver.simulate import Response, solve
from tests.worker.conftest import QUICK
from worker.casefile import read_case
from worker.compute import Worker

TEXT = "x_m,eta_mm\n" + "".join(f"{n / 4},{(n * n % 17 - 8) / 8}\n" for n in range(400))
BAND = {"min": 2.0, "max": 30.0}


def test_what_a_deleted_profile_leaves_cannot_be_computed_again(context: Context) -> None:
    """A result outlives its study and, with that, its profile: computing it once more needs the same samples again."""
    stored = profiles.create(context, TEXT, ANYBODY)
    measured = {"kind": "measured", "wavelength_band_m": [BAND], "profile_id": stored.id}
    sweep = {"kind": "product", "speed_kmh": [310], "irregularity": measured}
    study = StudyRequest.model_validate({"name": "A line", "sweep": sweep, "numerics": QUICK})
    created = studies.create(context, study, None)
    worker = Worker(context.settings, threading.Event())
    assert worker.work() == 1
    with context.database.read() as session:
        case_id = session.scalars(select(Case.id)).one()
    verifications.request(context, case_id)
    lifecycle.remove(context, created.id)
    profiles.remove(context, stored.id, ANYBODY)
    worker.profiles.cache_clear()
    worker.work()
    with context.database.read() as session:
        found = verifications.get(session, case_id)
    assert found.error is not None
    assert (found.state, found.error.code) == ("failed", "profile-deleted")
    with pytest.raises(Problem) as refused:
        verifications.request(context, case_id)
    assert (refused.value.status_code, refused.value.code) == (409, "profile-deleted")
    profiles.create(context, TEXT, ANYBODY)
    verifications.request(context, case_id)
    worker.work()
    worker.database.close()
    with context.database.read() as session:
        assert verifications.get(session, case_id).outcome == "same"


def test_a_case_whose_profile_is_gone_fails_at_once(context: Context) -> None:
    """Nobody can delete a profile that a study uses; an operator who meddles with the database can."""
    stored = profiles.create(context, TEXT, ANYBODY)
    measured = {"kind": "measured", "wavelength_band_m": [BAND], "profile_id": stored.id}
    sweep = {"kind": "product", "speed_kmh": [300, 310, 320], "irregularity": measured}
    study = StudyRequest.model_validate({"name": "A line", "sweep": sweep, "numerics": QUICK})
    created = studies.create(context, study, None)
    with pytest.raises(Problem, match=created.id):
        profiles.remove(context, stored.id, ANYBODY)
    with context.database.write() as session:
        session.execute(delete(StudyProfile))
        session.execute(delete(Profile))
    worker = Worker(context.settings, threading.Event())
    assert worker.work() == 3
    worker.database.close()
    with context.database.read() as session:
        cases = session.scalars(select(Case)).all()
    assert {(case.state, case.attempt, case.error["code"]) for case in cases if case.error} == {
        ("failed", 1, "profile-deleted")
    }
    assert len(cases) == 3


def test_peaks_over_a_stored_profile_are_those_over_the_file(context: Context, tmp_path: Path) -> None:
    stored = profiles.create(context, TEXT, ANYBODY)
    measured: dict[str, Any] = {"kind": "measured", "wavelength_band_m": [BAND, {"min": 4.0, "max": 30.0}]}
    sweep = {"kind": "product", "speed_kmh": [300], "irregularity": measured | {"profile_id": stored.id}}
    study = {"name": "A line", "sweep": sweep, "numerics": QUICK}
    studies.create(context, StudyRequest.model_validate(study), None)
    worker = Worker(context.settings, threading.Event())
    assert worker.work() == 2
    worker.database.close()

    (tmp_path / "profile.csv").write_text(TEXT)
    alone = {"kind": "measured", "wavelength_band_m": BAND, "file": "profile.csv"}
    (tmp_path / "case.json").write_text(json.dumps({"speed_kmh": 300, "irregularity": alone, "numerics": QUICK}))
    case = read_case(tmp_path / "case.json")
    (response,) = solve([case])
    assert isinstance(response, Response)
    with context.database.read() as session:
        row = session.scalars(select(Case).where(Case.digest == case.digest())).one()
        found = session.scalars(select(Peak.peak).where(Peak.case_id == row.id).order_by(Peak.id)).all()
    assert found == [peak.peak for peak in peaks(response)]
    assert found[0] > 68.7e3  # the profile is felt
