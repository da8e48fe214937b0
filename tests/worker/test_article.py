"""The article's report: what it makes of results, and that the committed one comes from the results beside it."""

import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from app.analysis.student import t_limit
from app.cases.schemas import conditions
from app.studies.schemas import StudyRequest
from app.studies.sweep.vary import PARAMETERS
from solver.case import Case, Numerics
from solver.peaks import peaks
from solver.track import TrackModel
from solver.verification.problems import make_case, solved
from worker.article import strip
from worker.article.figures import PICTURES
from worker.article.outcome import Sample, elasticities, joint_differences
from worker.article.report import render, write_report
from worker.article.reported import TABLE_1_TARGETS, TABLE_2_TARGETS
from worker.article.results import CONDITIONS, PEAKS, Cases, Results
from worker.article.run import RESULTS
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


def test_a_report_is_written_with_its_pictures(tmp_path: Path) -> None:
    text = write_report(tmp_path, fantasy()).read_text()
    pictures = {path.name: path.read_bytes() for path in (tmp_path / "article").iterdir()}
    assert {f"{name}.svg" for name in PICTURES} == set(pictures)
    assert all(f"(article/{name})" in text for name in pictures)
    assert len(re.findall(r"^\| Table [12], ", text, re.MULTILINE)) == len(TABLE_1_TARGETS + TABLE_2_TARGETS)
    write_report(tmp_path, fantasy())
    assert {path.name: path.read_bytes() for path in (tmp_path / "article").iterdir()} == pictures


def test_the_report_that_is_kept_comes_from_the_results_that_are_kept() -> None:
    assert (DOCS / "article.md").read_text() == render(Results.read(DOCS / RESULTS))


def test_every_study_is_one() -> None:
    counted = {name: StudyRequest.model_validate(study).count() for name, study in studies().items()}
    assert counted["ensemble"] == 64 * 7
    assert counted["sweep"] == 61 * 2


def rows(case_id: int, slab: str, **peaks: float) -> list[dict[str, str]]:
    """Peaks as they are exported."""
    common = {"case_id": str(case_id), "slab": slab, "speed_kmh": "350.0", "percentile": "", "track.pad_mass": "1.5"}
    common |= {"wavelength_min_m": "", "realisation": "", "wavelength_m": "1.0"}
    kinds = {(quantity, position) for quantity, position, _ in PEAKS.values()}
    return [
        common | {"quantity": quantity, "position": position, "mean": "0.5", "peak": str(peaks.get(quantity, 1.0))}
        for quantity, position in sorted(kinds)
    ]


def test_rows_become_cases() -> None:
    cases = Cases.from_rows(rows(9, "discontinuous", pad_force=3.0) + rows(4, "continuous", pad_force=2.0))
    assert cases["case_id"].tolist() == [4, 9]
    assert cases.where(slab="discontinuous")["pad_force"].tolist() == [3.0]
    assert cases["track.pad_mass"].tolist() == [1.5, 1.5]
    assert cases["mean_force"].tolist() == [0.5, 0.5]
    assert "percentile" not in cases.to_json()


def test_where_all_cases_diverged_there_are_none() -> None:
    assert len(Cases.from_rows([]).where(percentile=25.0)["pad_force"]) == 0


def test_joints_add_the_difference_of_equal_speeds() -> None:
    cases = Cases.from_rows(
        rows(1, "continuous", wheel_rail_force=1e5) + rows(2, "discontinuous", wheel_rail_force=112e3)
    )
    assert joint_differences(cases, "wheel_rail_force") == pytest.approx([12.0])


def test_a_sample_tells_how_sure_it_is() -> None:
    sample = Sample(np.array([9.0, 10.0, 11.0]))
    assert (sample.mean, sample.std, sample.below(10.5)) == (10.0, 1.0, 2)
    assert sample.half_interval == pytest.approx(4.302652730 / math.sqrt(3))  # Student, two degrees of freedom, 95 %
    needed = sample.needed(0.05)
    assert t_limit(0.95, needed - 1) / math.sqrt(needed) <= 0.5 < t_limit(0.95, needed - 2) / math.sqrt(needed - 1)


def test_the_elasticity_of_a_power_law_is_its_exponent() -> None:
    path, factors = "track.pad_damping_ns_per_m", np.array([0.9, 1.0, 1.1])
    cases = Cases({"case_id": [1, 2, 3], path: 2.0 * factors, "pad_force": 5.0 * factors**0.7})
    results = replace(fantasy(), cases={f"wave, {path}": cases})
    assert elasticities(results, path, "pad_force", "wave").values == pytest.approx([0.7])


def strips(width: float | str) -> strip.Strips:
    """On a standing track."""
    numerics = Numerics(track_length=92.0, elements_per_pad=4, time_step=4e-4)
    return strip.Strips(TrackModel(make_case(numerics=numerics)), width)


@pytest.mark.parametrize("width", [0.05, strip.ELEMENT])
@pytest.mark.parametrize("step", [1, 5, 12])
def test_strips_remove_slab_and_hold_the_rest(width: float | str, step: int) -> None:
    them = strips(width)
    stiffness = them.change(step, 0.0, 0.0)
    sunk = np.zeros(len(stiffness))
    sunk[2::6] = sunk[4::6] = 1.0  # slab and base
    assert stiffness @ sunk == pytest.approx(np.zeros(len(sunk)), abs=1e-2)  # N/m, beside 1e8
    mass = them.change(step, 1.0, 0.0) - stiffness
    removed = them.model.element.length if isinstance(width, str) else width
    assert sunk @ mass @ sunk == pytest.approx(-removed * them.model.case.track.slab_mass, rel=1e-4)


def test_without_strips_the_experiment_is_the_solver() -> None:
    numerics = Numerics(track_length=92.0, elements_per_pad=4, time_step=4e-4, settle=0.3, window=0.02)
    case = make_case(numerics=numerics)
    (response,) = solved([case])
    expected = {peak.quantity: peak.peak for peak in peaks(response) if peak.position == "wheelset_1"}
    found = strip.peaks_with_strips(case, 0.0)
    assert found == pytest.approx({name: expected[name] for name in strip.MEASURES}, rel=1e-7)
