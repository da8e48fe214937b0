"""The article's studies give the peaks they gave before: a change of numbers is a decision.

Who decides so, and counts the solver's version up, writes the new ones: ``python tests/solver/test_article_peaks.py``.
"""

import json
from pathlib import Path

import pytest

from app.studies.schemas import StudyRequest
from solver.peaks import peaks
from solver.simulate import Response, solve

KEPT = Path(__file__).with_name("article_peaks.json")
PRESETS = ("article-speed-continuous", "article-speed-discontinuous", "article-percentiles", "article-wavelength-bands")
NUMERICS = {"short": {"settle_s": 0.3, "window_s": 0.05}, "whole": {}}  # the first is quick and as fine
RELATIVE, NOTHING = 1e-6, 1e-12


def computed(preset: str, length: str) -> list[dict[str, float]]:
    """Peaks of every case of a preset, by quantity and position."""
    study = StudyRequest.model_validate({"name": preset, "sweep": preset, "numerics": NUMERICS[length]})
    responses = solve(study.expand())
    assert all(isinstance(response, Response) for response in responses)
    return [
        {f"{peak.quantity} {peak.position}": peak.peak for peak in peaks(response)}
        for response in responses
        if isinstance(response, Response)
    ]


@pytest.mark.parametrize("preset", PRESETS)
@pytest.mark.parametrize("length", ["short", pytest.param("whole", marks=pytest.mark.slow)])
def test_peaks_of_the_article_stay(preset: str, length: str) -> None:
    expected = json.loads(KEPT.read_text())[f"{preset}, {length}"]
    assert computed(preset, length) == [pytest.approx(case, rel=RELATIVE, abs=NOTHING) for case in expected]


def rewrite() -> None:
    """Keep what is computed now."""
    found = {f"{preset}, {length}": computed(preset, length) for length in NUMERICS for preset in PRESETS}
    rounded = {
        key: [{name: float(f"{value:.10g}") for name, value in case.items()} for case in cases]
        for key, cases in found.items()
    }
    KEPT.write_text(json.dumps(rounded, indent=1) + "\n")


if __name__ == "__main__":
    rewrite()
