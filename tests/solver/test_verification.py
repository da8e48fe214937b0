"""The quick checks of ``tracksweep verify``, and that a missed tolerance is told."""

import numpy as np
import pytest

from solver.verification.checks import CHECKS
from solver.verification.finding import Bound, Check, Comparison, Curve, Finding, Plot
from solver.verification.report import write_report
from worker.verify import run


@pytest.mark.parametrize("check", [check for check in CHECKS if check.quick], ids=lambda check: check.title)
def test_solver_meets(check):
    missed = [(row.what, *row.cells()) for row in check.run().rows if not row.passed]
    assert not missed


def test_checks_have_titles_of_their_own():
    titles = [check.title for check in CHECKS]
    assert len(set(titles)) == len(titles)


@pytest.mark.parametrize(
    ("row", "passed"),
    [
        (Comparison(what="", ours=1.01, expected=1.0, tolerance=0.011), True),
        (Comparison(what="", ours=1.012, expected=1.0, tolerance=0.011), False),
        (Comparison(what="", ours=-0.988, expected=-1.0, tolerance=0.011), False),
        (Comparison(what="", ours=0.1, expected=0.0, tolerance=0.011, scale=10.0), True),
        (Comparison(what="", ours=np.nan, expected=1.0, tolerance=0.011), False),
        (Comparison(what="", ours=1.0, expected=np.nan, tolerance=0.011), False),
        (Bound(what="", ours=1.0, low=0.5), True),
        (Bound(what="", ours=0.4, low=0.5), False),
        (Bound(what="", ours=0.6, high=0.5), False),
        (Bound(what="", ours=np.nan, low=0.5), False),
    ],
)
def test_a_row_passes_only_within_its_tolerance(row, passed):
    assert row.passed == passed
    assert Finding(rows=[row]).passed == passed


def test_a_check_that_compares_nothing_has_not_passed():
    assert not Finding(rows=[]).passed


def test_the_report_shows_both_numbers_the_difference_and_the_verdict(tmp_path):
    plot = Plot(
        x_label="time, s", y_label="force, N", curves=(Curve(label="ours", x=[1, 2], y=[1, 4]),), logarithmic=True
    )
    rows = [
        Comparison(what="a force", ours=103.0, expected=100.0, tolerance=0.02, unit="kN"),
        Bound(what="an order", ours=2.0, low=1.8, high=2.2),
    ]
    kept = Check(title="Kept, m/s", how="So.", run=lambda: Finding(rows=rows[1:]))
    missed = Check(title="Missed", how="Otherwise.", run=lambda: Finding(rows=rows, plots=[plot]))
    text = write_report(tmp_path, [(check, check.run()) for check in (kept, missed)]).read_text()
    assert "2 checks, 3 numbers, **1 missed**" in text
    assert "| a force | 103 kN | 100 kN | +3 % | 2 % | **missed** |" in text
    assert "| an order | 2 | at least 1.8 at most 2.2 |  |  | kept |" in text
    assert "(#kept-ms)" in text
    (picture,) = (tmp_path / "verification").iterdir()
    assert f"(verification/{picture.name})" in text
    drawn = picture.read_bytes()
    assert drawn.startswith(b"<?xml")
    write_report(tmp_path, [(check, check.run()) for check in (kept, missed)])
    assert picture.read_bytes() == drawn


def off_by_a_third() -> Finding:
    return Finding(rows=[Comparison(what="a force", ours=4.0, expected=3.0, tolerance=0.1)])


def test_the_program_fails_when_a_tolerance_is_missed(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("worker.verify.CHECKS", (Check(title="Wrong", how="", run=off_by_a_third, quick=True),))
    with pytest.raises(SystemExit) as ended:
        run(tmp_path, quick=True)
    assert ended.value.code == 1
    assert "MISSED" in capsys.readouterr().out
    assert "**1 missed**" in (tmp_path / "verification.md").read_text()
