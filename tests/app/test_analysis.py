"""Comparisons and statistics, beside what a hand computes."""

import statistics
from collections.abc import Callable
from typing import Any

import httpx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from sqlalchemy import select

from app.analysis.student import t_limit
from app.analysis.summary import describe
from app.cases.schemas import case_file
from app.db.models import STATISTICS, Case, Peak
from app.db.session import Database
from tests.outcomes import succeed
from worker.claim import claim

Check = Callable[..., dict[str, Any]]

SWEEP = {
    "kind": "product",
    "speed_kmh": [250, 300],
    "slab": ["continuous", "discontinuous"],
    "irregularity": {
        "kind": "spectrum",
        "percentile": [25, 90],
        "wavelength_band_m": [{"min": 2, "max": 30}, {"min": 4, "max": 30}],
        "realisations": 3,
    },
    "vary": {"track.pad_stiffness_n_per_m": [4e7, 6e7]},
}


def number(file: dict[str, Any]) -> float:
    """What the solver is taken to have found for a case: every axis adds something of its own."""
    wave = file["irregularity"]
    jointed, stiff = file["slab"] == "discontinuous", file["track"]["pad_stiffness_n_per_m"] == 6e7
    return (
        1000 * (file["speed_kmh"] == 300)
        + (20 if file["speed_kmh"] == 300 else 10) * jointed
        + 3 * (wave["percentile"] == 90)
        + 0.5 * (wave["wavelength_band_m"]["min"] == 4)
        + 100 * stiff
        + 2 * wave["realisation"]
    )


@pytest.fixture
def path(client: httpx.Client, database: Database) -> str:
    """A study, computed."""
    study = client.post("/v1/studies", json={"name": "A study", "sweep": SWEEP}).json()
    with database.write() as session:
        while batch := claim(session, "test", 15.0, lanes=1):
            (held,) = batch
            file = case_file(held.inputs)
            peaks = [
                {"quantity": quantity, "position": "wheelset_1", "unit": unit} | dict.fromkeys(STATISTICS, number(file))
                for quantity, unit in (("wheel_rail_force", "N"), ("rail_displacement", "m"))
            ]
            assert succeed(session, held, peaks=peaks, processing={}, history=None, cpu_s=1.0)
    return f"/v1/studies/{study['id']}"


def averages(client: httpx.Client, path: str, **query: str) -> list[tuple[Any, ...]]:
    answer = client.get(f"{path}/comparison", params={"quantity": "wheel_rail_force", **query}).json()
    return [(each["at"], each["groups"], pytest.approx(each["absolute"])) for each in answer["averages"]]


def test_differences_along_an_axis(client: httpx.Client, path: str) -> None:
    assert averages(client, path, axis="slab") == [("discontinuous", 48, 15)]
    assert averages(client, path, axis="slab", baseline="discontinuous") == [("continuous", 48, -15)]
    assert averages(client, path, axis="percentile") == [(90, 48, 3)]
    assert averages(client, path, axis="percentile", baseline="90.0") == [(25, 48, -3)]
    assert averages(client, path, axis="track.pad_stiffness_n_per_m") == [(6e7, 48, 100)]
    narrow, wide = {"min": 4, "max": 30}, {"min": 2, "max": 30}
    assert averages(client, path, axis="wavelength_band_m") == [(narrow, 48, 0.5)]
    assert averages(client, path, axis="wavelength_band_m", baseline='{"max": 30, "min": 4}') == [(wide, 48, -0.5)]
    assert averages(client, path, axis="realisation") == [(1, 32, 2), (2, 32, 4)]


def test_groups_of_otherwise_equal_cases(client: httpx.Client, path: str) -> None:
    answer = client.get(f"{path}/comparison", params={"axis": "slab", "statistic": "rms"}).json()
    assert (answer["baseline"], answer["statistic"], answer["groups_without_baseline"]) == ("continuous", "rms", 0)
    assert len(answer["groups"]) == 2 * 48  # of two quantities
    (group,) = (each for each in answer["groups"] if each["baseline_value"] == 1107.5 and each["unit"] == "N")
    assert group["conditions"] == {
        "speed_kmh": 300,
        "percentile": 90,
        "wavelength_band_m": {"min": 4, "max": 30},
        "realisation": 2,
        "track.pad_stiffness_n_per_m": 6e7,
    }
    assert group["differences"] == [
        {"at": "discontinuous", "value": 1127.5, "absolute": 20, "relative": pytest.approx(20 / 1107.5)}
    ]
    nothing = next(each for each in answer["groups"] if each["baseline_value"] == 0)
    assert nothing["differences"][0]["relative"] is None
    force = next(each for each in answer["averages"] if each["unit"] == "N")
    assert force["absolute_std"] == pytest.approx(statistics.stdev([10] * 24 + [20] * 24))
    assert force["relative"] is None


def test_a_baseline_that_is_missing(client: httpx.Client, path: str, database: Database) -> None:
    with database.write() as session:
        peak = session.scalars(
            select(Peak).join(Case, Case.id == Peak.case_id).where(Case.slab == "continuous")
        ).first()
        session.delete(peak)
    answer = client.get(f"{path}/comparison", params={"axis": "slab"}).json()
    assert (len(answer["groups"]), answer["groups_without_baseline"]) == (2 * 48 - 1, 1)


def test_what_cannot_be_compared(client: httpx.Client, path: str, problem: Check) -> None:
    for query, pointer in (
        ({}, "/query/axis"),
        ({"axis": "seed"}, "/query/axis"),
        ({"axis": "slab", "baseline": "wooden"}, "/query/baseline"),
        ({"axis": "slab", "baseline": "[" * 200}, "/query/baseline"),
        ({"axis": "slab", "statistic": "time_s"}, "/query/statistic"),
    ):
        assert problem(client.get(f"{path}/comparison", params=query), 422)["errors"][0]["pointer"] == pointer
    for name in ("comparison?axis=slab", "statistics"):
        problem(client.get(f"/v1/studies/{'0' * 32}/{name}"), 404)
    assert client.get(f"{path}/comparison", params={"axis": "slab", "quantity": "noise"}).json()["groups"] == []


def test_statistics_over_realisations(client: httpx.Client, path: str) -> None:
    answer = client.get(f"{path}/statistics", params={"quantity": "wheel_rail_force"})
    found = answer.json()["conditions"]
    assert len(found) == 32
    (summary,) = (each for each in found if each["minimum"] == 1020 and "realisation" not in each["conditions"])
    assert summary["conditions"]["slab"] == "discontinuous"
    reach = 4.302652729749464 * 2 / 3**0.5
    assert {name: value for name, value in summary.items() if name != "conditions"} == {
        **{"quantity": "wheel_rail_force", "position": "wheelset_1", "unit": "N"},
        **{"count": 3, "mean": 1022, "std": 2, "minimum": 1020, "maximum": 1024},
        "quantiles": pytest.approx({"p5": 1020.2, "p25": 1021, "p50": 1022, "p75": 1023, "p95": 1023.8}),
        "mean_95": pytest.approx({"lower": 1022 - reach, "upper": 1022 + reach}),
    }
    again = client.get(answer.url, headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304


@given(st.lists(st.floats(-1e6, 1e6), min_size=1, max_size=40))
def test_statistics_as_numpy_has_them(values: list[float]) -> None:
    found = describe(values)
    assert found["mean"] == pytest.approx(np.mean(values), abs=1e-9)
    expected = np.quantile(values, [0.05, 0.25, 0.5, 0.75, 0.95])
    assert list(dict(found["quantiles"]).values()) == pytest.approx(expected, abs=1e-6)
    if len(values) == 1:
        assert found["std"] is found["mean_95"] is None
    else:
        assert found["std"] == pytest.approx(np.std(values, ddof=1), abs=1e-6)


@pytest.mark.parametrize("freedom", [*range(1, 40), 99, 100, 999, 1000])
def test_student_as_scipy_has_it(freedom: int) -> None:
    for confidence in (0.5, 0.95, 0.999):
        assert t_limit(confidence, freedom) == pytest.approx(stats.t.ppf((1 + confidence) / 2, freedom), rel=1e-9)
