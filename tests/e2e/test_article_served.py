"""The article's own studies through a service, shortened."""

from typing import Any

from tests.e2e.conftest import SMALL, Served
from worker.article.gathered import gather
from worker.article.results import Results
from worker.article.studies import PRESETS, studies


def test_presets_go_through_the_service(service: Served, tmp_path: Any) -> None:
    wanted = {name: studies()[name] | {"numerics": SMALL | {"time_step_s": 4e-4}} for name in PRESETS}
    told: list[float] = []
    results = gather(str(service.http.base_url), wanted, [], lambda done, _: told.append(done))
    assert told == [0.25, 0.5, 0.75, 1.0]
    assert results.cases["continuous"]["speed_kmh"].tolist() == [160, 200, 250, 300, 350]
    assert results.cases["bands"]["wavelength_min_m"].tolist() == [2, 2.5, 3, 3.5, 4]
    time, force = results.histories["percentiles, 90, wheel_rail_force"]
    assert len(time) == len(force) > 50
    heights = {percentile: max(curve[1]) for percentile, curve in results.profiles.items()}
    assert heights["25"] < heights["63.2"] < heights["90"]
    results.write(tmp_path / "results.json")
    assert Results.read(tmp_path / "results.json").made == results.made
