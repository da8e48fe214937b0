"""A worker computes what runs over a stored profile, as `tracksweep solve` does over the file."""

import json
import threading
from pathlib import Path
from typing import Any

from sqlalchemy import select

from app.access.caller import ANYBODY
from app.context import Context
from app.db.models import Case, Peak
from app.profiles import service as profiles
from app.studies import service as studies
from app.studies.schemas import StudyRequest
from solver.peaks import peaks
from solver.simulate import Response, solve
from tests.worker.conftest import QUICK
from worker.casefile import read_case
from worker.compute import Worker

TEXT = "x_m,eta_mm\n" + "".join(f"{n / 4},{(n * n % 17 - 8) / 8}\n" for n in range(400))
BAND = {"min": 2.0, "max": 30.0}


def test_peaks_over_a_stored_profile_are_those_over_the_file(context: Context, tmp_path: Path) -> None:
    stored = profiles.create(context, TEXT, ANYBODY)
    measured: dict[str, Any] = {"kind": "measured", "wavelength_band_m": [BAND, {"min": 4.0, "max": 30.0}]}
    sweep = {"kind": "product", "speed_kmh": [300], "irregularity": measured | {"profile_id": stored.id}}
    study = {"name": "A line", "sweep": sweep, "numerics": QUICK}
    studies.create(context, StudyRequest.model_validate(study), None)
    worker = Worker(context.settings, threading.Event())
    assert worker.drain() == 2
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
