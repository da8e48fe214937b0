"""What benchmarks make of their figures."""

import json
from pathlib import Path

import numpy as np
import pytest

from benchmarks import results
from benchmarks.report import write
from benchmarks.results import Result, exponent, machine, publish, scatter
from benchmarks.timing import interleave, medians


@pytest.fixture
def result() -> Result:
    curve = {"label": "ours", "x": [1, 8], "y": [0.4, 0.1], "style": "o-"}
    return Result(
        title="Something",
        how="In some way.",
        command="python -m benchmarks.contenders",
        values={"ratio_something": 3.25},
        table=[["what", "ms"], ["ours", "0.1"]],
        plots=[{"x_label": "lanes", "y_label": "ms", "curves": [curve]}],
    )


def test_the_exponent_of_a_power_law_is_found() -> None:
    x = np.array([1.0, 2.0, 5.0, 9.0])
    assert exponent(x, 3 * x**1.7) == pytest.approx(1.7)


def test_scatter_is_half_the_distance_between_quartiles() -> None:
    assert scatter([8.0, 9.0, 10.0, 11.0, 12.0]) == pytest.approx(0.1)


def test_rounds_take_turns() -> None:
    turns: list[str] = []

    def work(name: str) -> int:
        turns.append(name)
        return 4

    seconds = interleave({"a": lambda: work("a"), "b": lambda: work("b")}, 3)
    assert turns == ["a", "b"] * 3
    assert set(medians(seconds)) == {"a", "b"}


def test_the_page_tells_figures_command_and_machine(
    result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(results, "RESULTS", tmp_path / "results")
    publish("contenders", result)
    assert "ratio_something = 3.25" in capsys.readouterr().out.splitlines()

    page = write(tmp_path / "results", tmp_path).read_text()
    for part in ("## Something", "python -m benchmarks.contenders", "| ours | 0.1 |", machine()["processor"]):
        assert part in page
    picture = tmp_path / "results" / "contenders-1.svg"
    assert f"]({picture.relative_to(tmp_path)})" in page
    drawn = picture.read_bytes()
    write(tmp_path / "results", tmp_path)
    assert picture.read_bytes() == drawn


def test_results_do_not_tell_the_name_of_the_machine(
    result: Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(results, "RESULTS", tmp_path)
    publish("contenders", result)
    assert set(json.loads((tmp_path / "contenders.json").read_text())["machine"]) == {"processor", "caches", "software"}
