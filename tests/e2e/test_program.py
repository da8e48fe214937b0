"""The program ``tracksweep``: what it prints and how it exits."""

import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from tests.e2e.conftest import SECONDS_LONG, SMALL, Served, study, tracksweep

CASE = {
    "speed_kmh": 300,
    "irregularity": {"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.3},
    "numerics": SMALL,
}


@pytest.fixture
def on(service: Served) -> dict[str, str]:
    """The environment that leads to the service."""
    return {"TRACKSWEEP_DATA_DIR": str(service.data)}


def written(path: Path, content: Any) -> Path:
    path.write_text(json.dumps(content))
    return path


def test_solve_prints_peaks_and_keeps_histories(tmp_path: Path) -> None:
    case = written(tmp_path / "case.json", CASE)
    table = tracksweep("solve", case, "--out", tmp_path / "histories.npz")
    assert (table.returncode, table.stderr) == (0, "")
    assert ["wheel", "rail", "force", "wheelset", "1"] in [line.split()[:5] for line in table.stdout.splitlines()]
    assert "kN" in table.stdout
    with np.load(tmp_path / "histories.npz") as histories:
        row = list(histories["quantity"]).index("wheel_rail_force")
        force = histories["values"][row]

    peaks = json.loads(tracksweep("solve", case, "--json").stdout)["peaks"]
    assert (peaks[0]["quantity"], peaks[0]["position"], peaks[0]["unit"]) == ("wheel_rail_force", "wheelset_1", "N")
    assert peaks[0]["peak"] == pytest.approx(force.max())


def test_a_wrong_case_is_refused_without_a_traceback(tmp_path: Path) -> None:
    done = tracksweep("solve", written(tmp_path / "case.json", CASE | {"numerics": {"track_length_m": 10}}))
    assert (done.returncode, done.stdout) == (2, "")
    assert "numerics.track_length_m: Input should be greater than or equal to 90" in done.stderr
    assert "Traceback" not in done.stderr


def test_wrong_settings_are_named() -> None:
    done = tracksweep("peaks", TRACKSWEEP_PORT="many")
    assert done.returncode == 2
    assert "port: " in done.stderr


def test_without_a_service_the_program_says_how_to_start_one(tmp_path: Path) -> None:
    done = tracksweep("peaks", TRACKSWEEP_URL="http://127.0.0.1:9")
    assert done.returncode == 1
    assert "tracksweep serve" in done.stderr


def test_submit_watch_peaks(service: Served, on: dict[str, str], tmp_path: Path) -> None:
    submitted = tracksweep("submit", written(tmp_path / "study.json", study(200, 230)), **on)
    assert submitted.returncode == 0, submitted.stderr
    study_id = submitted.stdout.strip()

    watched = tracksweep("watch", study_id, "--json", **on)
    assert (watched.returncode, json.loads(watched.stdout)["state"]) == (0, "succeeded")
    assert "2 of 2 cases done" in watched.stderr.splitlines()[-1]

    file = tmp_path / "peaks.csv"
    assert tracksweep("peaks", "--study", study_id, "--csv", file, **on).returncode == 0
    with file.open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    expected = service.get("/v1/peaks", study_id=study_id, page_size=500)["items"]
    assert [float(row["peak"]) for row in rows] == [peak["peak"] for peak in expected]
    assert {row["unit"] for row in rows if row["quantity"] == "wheel_rail_force"} == {"N"}

    only = ("--study", study_id, "--quantity", "wheel_rail_force", "--sort=-peak", "--speed-kmh-min", 210)
    assert tracksweep("peaks", *only, "--parquet", tmp_path / "peaks.parquet", **on).returncode == 0
    saved = pd.read_parquet(tmp_path / "peaks.parquet")["peak"].tolist()
    printed = json.loads(tracksweep("peaks", *only, "--json", **on).stdout)
    assert [peak["peak"] for peak in printed] == saved == sorted(saved, reverse=True)
    assert {peak["speed_kmh"] for peak in printed} == {230}


def test_cancel_and_retry(service: Served, on: dict[str, str], tmp_path: Path) -> None:
    study_id = service.submit(study(300, window_s=2 * SECONDS_LONG))
    done = tracksweep("cancel", study_id, **on)
    assert (done.returncode, done.stdout) == (0, "cancelled\n"), done.stderr
    assert tracksweep("watch", study_id, **on).returncode == 1

    retried = tracksweep("retry", study_id, "--json", **on)
    assert json.loads(retried.stdout)["state"] in ("queued", "running")
    assert tracksweep("cancel", study_id, **on).returncode == 0

    unknown = tracksweep("retry", "0" * 32, **on)
    assert (unknown.returncode, unknown.stdout) == (2, "")
    assert "There is no such study." in unknown.stderr


def test_a_refused_study_is_explained(on: dict[str, str], tmp_path: Path) -> None:
    done = tracksweep("submit", written(tmp_path / "study.json", study(900)), **on)
    assert done.returncode == 2
    assert "/sweep/speed_kmh/0: " in done.stderr


def test_help_is_quick_because_it_imports_little() -> None:
    code = "import sys, worker.cli; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"numpy", "sqlalchemy", "fastapi", "celery", "httpx", "pydantic"} & set(loaded)
