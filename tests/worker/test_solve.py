"""``tracksweep solve`` inside the process: what it says of wrong cases and of those that cannot be solved."""

import json
from pathlib import Path
from typing import Any

import pytest

from solver.case import Measured, Sum
from solver.errors import DivergedError
from tests.worker.conftest import QUICK
from worker import solve
from worker.casefile import read_case

WAVE = {"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.3}
CASE = {"speed_kmh": 300, "irregularity": WAVE}
BAND = {"min": 30, "max": 2}


RANDOM = {"kind": "spectrum", "wavelength_band_m": {"min": 2, "max": 30}}
PROFILE = {"kind": "measured", "wavelength_band_m": {"min": 2, "max": 10}}


def written(folder: Path, content: Any) -> Path:
    path = folder / "case.json"
    path.write_text(json.dumps(content))
    return path


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (CASE | {"speed_kmh": 900}, "speed_kmh: Input should be less than or equal to 600"),
        (CASE | {"numerics": {"track_length_m": 10}}, "numerics.track_length_m: Input should be greater than or"),
        (CASE | {"irregularity": WAVE | {"wavelength_m": "1"}}, "irregularity.wavelength_m: Input should be a valid"),
        (CASE | {"irregularity": {"kind": "spectrum", "wavelength_band_m": BAND}}, "irregularity.wavelength_band_m: "),
        (CASE | {"irregularity": RANDOM | {"spectrum": "white"}}, "irregularity.spectrum: Input should be 'tb3352"),
        (CASE | {"irregularity": {"kind": "measured", "file": 1}}, "irregularity.file: Extra inputs are not permitted"),
        (CASE | {"irregularity": PROFILE | {"file": "no.csv"}}, "no.csv: No such file"),
        (
            CASE | {"irregularity": PROFILE | {"file": "bad.csv"}},
            "bad.csv is not a profile:\n  line 2: must be two",
        ),
        (
            CASE | {"irregularity": PROFILE | {"file": "gap.csv"}},
            "irregularity.positions_m.1: must lie beyond 0 m",
        ),
        (CASE | {"colour": "red"}, "colour: Extra inputs are not permitted"),
        ([], "the file: "),
    ],
)
def test_a_wrong_case_is_told_by_field_and_bound(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], content: Any, words: str
) -> None:
    (tmp_path / "bad.csv").write_text("x_m,eta_mm\n1;2;3\n")
    (tmp_path / "gap.csv").write_text("".join(f"{n * 3},0\n" for n in range(20)))
    with pytest.raises(SystemExit) as ended:
        read_case(written(tmp_path, content))
    assert ended.value.code == 2
    assert words in capsys.readouterr().err


def test_profiles_are_read_from_beside_the_case(tmp_path: Path) -> None:
    (tmp_path / "track").mkdir()
    (tmp_path / "track/profile.csv").write_text("x_m,eta_mm\n" + "".join(f"{n / 2},{n % 5}\n" for n in range(100)))
    profile = PROFILE | {"file": "track/profile.csv"}
    alone = read_case(written(tmp_path, CASE | {"irregularity": profile})).irregularity
    assert isinstance(alone, Measured)
    assert (len(alone.positions), alone.positions[-1], max(alone.heights)) == (100, 49.5, pytest.approx(4e-3))
    both = read_case(written(tmp_path, CASE | {"irregularity": {"kind": "sum", "terms": [WAVE, profile]}})).irregularity
    assert isinstance(both, Sum)
    assert both.terms[1] == alone


def test_a_file_that_is_missing_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        read_case(tmp_path / "none.json")
    assert ended.value.code == 2
    assert "none.json: No such file" in capsys.readouterr().err


def test_json_says_how_peaks_were_derived(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    case = read_case(written(tmp_path, CASE | {"numerics": QUICK}))
    solve.run(case, histories=None, as_json=True)
    printed = json.loads(capsys.readouterr().out)
    assert printed["processing"]["sampling_step_s"] == printed["time_step_s"] == case.time_step
    assert printed["processing"]["samples"] == round(QUICK["window_s"] / case.time_step)


def test_a_case_that_cannot_be_solved_exits_with_1(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(solve, "solve", lambda cases, on_progress: [DivergedError("it grew and grew")])
    with pytest.raises(SystemExit) as ended:
        solve.run(read_case(written(tmp_path, CASE)), histories=None, as_json=False)
    assert ended.value.code == 1
    assert capsys.readouterr().err == "diverged: it grew and grew\n"
