"""The examples are valid, and the demo does what it says."""

import csv
import os
import subprocess
import sys
from pathlib import Path

import attrs
import pytest

from app.cases.schemas import CaseFile
from app.console import digits
from app.studies.schemas import StudyRequest
from examples.demo import STUDY, largest_by_speed
from examples.figure import PANELS, draw
from tracksweep_client.generated.models import PeakRow

ROOT = Path(__file__).parent.parent


def test_the_study_has_the_cases_it_is_named_for() -> None:
    cases = StudyRequest.model_validate_json(STUDY.read_bytes()).expand()
    assert [round(case.speed * 3.6) for case in cases] == [160, 200, 250, 300, 350]


def test_the_case_is_one_of_them() -> None:
    case = CaseFile.model_validate_json((ROOT / "examples/case.json").read_bytes()).to_case()
    assert case in StudyRequest.model_validate_json(STUDY.read_bytes()).expand()


def test_the_largest_peak_at_any_position_counts() -> None:
    row = dict.fromkeys(field.name for field in attrs.fields(PeakRow) if field.init) | {"unit": "N"}
    peaks = [
        PeakRow(**row | {"quantity": "wheel_rail_force", "speed_kmh": speed, "peak": peak})
        for speed, peak in [(200.0, 90e3), (200.0, 95e3), (300.0, 92e3)]
    ]
    assert largest_by_speed(peaks) == {("wheel_rail_force", "kN"): {200.0: 95.0, 300.0: 92.0}}


def test_the_figure_is_drawn(tmp_path: Path) -> None:
    draw({(quantity, "unit"): {160.0: 1.0, 350.0: 2.0} for quantity in PANELS}, "title", tmp_path / "figure.png")
    assert (tmp_path / "figure.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("value", "text"), [(0, "0"), (123456.7, "123457"), (1.23456, "1.235"), (-0.00123456, "-0.001235")]
)
def test_values_have_four_digits(value: float, text: str) -> None:
    assert digits(value) == text


@pytest.mark.slow
@pytest.mark.timeout(1200)
def test_the_demo_computes_once(tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    for reused in (False, True):
        done = subprocess.run(
            [sys.executable, "-m", "examples.demo"],
            cwd=tmp_path,
            env=environment,
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            check=False,
        )
        assert done.returncode == 0, done.stderr
        assert ("5 of 5 cases were already computed" in done.stdout) == reused
        assert "wheel rail force" in done.stdout
    assert (tmp_path / "demo/peaks_vs_speed.png").exists()
    with (tmp_path / "demo/peaks.csv").open(newline="") as file:
        quantities = [row["quantity"] for row in csv.DictReader(file)]
    assert quantities.count("wheel_rail_force") == 5 * 4
