"""The article's report: what it makes of results, and that the committed one comes from the results beside it."""

from functools import cache
from pathlib import Path

import numpy as np

from app.cases.schemas import conditions
from app.studies.schemas import StudyRequest
from app.studies.sweep.vary import PARAMETERS
from solver.case import Case
from worker.article import strip
from worker.article.report import write_report
from worker.article.results import CONDITIONS, PEAKS, Cases, Results
from worker.article.studies import PRESETS, studies

DOCS = Path(__file__).parents[2] / "docs"


def made_up(number: int, case: Case, paths: list[str]) -> dict[str, object]:
    """A case with peaks out of thin air."""
    given = conditions(case.to_dict())
    values: dict[str, object] = {name: given[name] for name in CONDITIONS} | {"case_id": number}
    for path in paths:
        value: object = case
        for name in PARAMETERS[path].inside:
            value = getattr(value, name)
        values[path] = value
    drawn = np.random.Generator(np.random.PCG64(int(case.digest()[:8], 16)))
    scale = {"wheel_rail_force": 1e5, "mean_force": 7e4, "rail_displacement": 1.2e-3, "mean_displacement": 9e-4}
    return values | {name: scale.get(name, 10.0) * (1 + 0.1 * drawn.random()) for name in PEAKS}


@cache
def fantasy() -> Results:
    """Results of the shape that a run has."""
    found = {}
    for name, study in studies().items():
        request = StudyRequest.model_validate(study)
        paths = [] if name in PRESETS else list(study["sweep"].get("vary", {}))
        rows = [made_up(number, case, paths) for number, case in enumerate(request.expand())]
        found[name] = Cases({key: [row[key] for row in rows] for key in rows[0]})
    curve = ([0.0, 1.0], [0.0, 1e-3])
    histories = {
        f"{study}, {value}, {quantity}": curve
        for study, values in (("percentiles", ("25", "63.2", "90")), ("bands", ("2", "2.5", "3", "3.5", "4")))
        for value in values
        for quantity in ("rail_displacement", "wheel_rail_force")
    }
    apart = [{"width_m": width, "speed_kmh": speed, "peaks": None} for width, speed in strip.PLAN]
    made = {"command": "tracksweep article", "seconds": 100.0, "seconds_served": 90.0, "solver_version": "3"}
    made |= {"software": "Python", "cores": "2"}
    profiles = dict.fromkeys(("25", "63.2", "90"), curve)
    return Results(made=made, cases=found, profiles=profiles, histories=histories, strip=apart)


def test_results_are_read_as_they_were_written(tmp_path: Path) -> None:
    fantasy().write(tmp_path / "results.json")
    again = Results.read(tmp_path / "results.json")
    again.write(tmp_path / "again.json")
    assert (tmp_path / "again.json").read_bytes() == (tmp_path / "results.json").read_bytes()


def test_a_report_is_written(tmp_path: Path) -> None:
    text = write_report(tmp_path, fantasy()).read_text()
    assert "holds" in text
