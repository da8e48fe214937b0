"""What studies would take, on both databases."""

from collections.abc import Callable
from dataclasses import replace
from datetime import datetime, timedelta
from typing import Any

import httpx
import pytest
from sqlalchemy import func, select

from app.db.models import Case, Event, Study
from app.db.session import Database
from app.studies.resonance import p2_hz
from solver.catalogue import TRACKS, VEHICLES
from tests.outcomes import succeed
from worker import presence
from worker.claim import claim

Check = Callable[..., dict[str, Any]]
Body = dict[str, Any]


def compute(database: Database, *cpu_s: float) -> None:
    for seconds in cpu_s:
        with database.write() as session:
            (held,) = claim(session, "test", 15.0, lanes=1)
            assert succeed(session, held, peaks=[], processing={}, history=None, cpu_s=seconds)


def announce(database: Database, *names: str) -> None:
    for name in names:
        with database.write() as session:
            presence.announce(session, name, 600.0)


def ask(client: httpx.Client, study: Body, *speeds: float, **more: Any) -> dict[str, Any]:
    sweep = study["sweep"] | ({"speed_kmh": list(speeds)} if speeds else {})
    answer = client.post("/v1/study-estimates", json=study | {"sweep": sweep} | more)
    assert answer.status_code == 200, answer.text
    body: dict[str, Any] = answer.json()
    return body


def test_cases_are_told_apart_and_nothing_is_stored(client: httpx.Client, database: Database, study: Body) -> None:
    client.post("/v1/studies", json=study)
    compute(database, 2.0)
    with database.write() as session:
        claim(session, "test", 15.0, lanes=1)
    told = ask(client, study, 250, 300, 350)
    assert told["cases"] == {"total": 6, "computed": 1, "failed": 0, "in_flight": 3, "new": 2}
    wanting = ask(client, study, 250, 300, 350, keep_history=True)["cases"]
    assert (wanting["computed"], wanting["new"]) == (0, 3)
    with database.read() as session:
        counts = [session.scalar(select(func.count()).select_from(table)) for table in (Study, Case, Event)]
    assert counts == [1, 4, 3]
    created = client.post("/v1/studies", json=study | {"sweep": study["sweep"] | {"speed_kmh": [250, 300, 350]}})
    assert created.json()["cases_reused"] == told["cases"]["computed"]


def test_costs_are_learnt(client: httpx.Client, database: Database, study: Body) -> None:
    """From a benchmark, then from any case, then from those of the same operator."""
    first = ask(client, study)["cpu"]
    assert first["basis"] == "benchmark"
    assert 0 < first["least_s"] < first["expected_s"] < first["most_s"]
    client.post("/v1/studies", json=study)
    compute(database, 3.0, 5.0)  # both of 250 km/h
    other = ask(client, study, 100)["cpu"]
    assert other["basis"] == "other-cases"
    assert other["expected_s"] == pytest.approx(2 * 4.0, rel=0.02)  # as many steps, to rounding them between pads
    study["sweep"]["irregularity"]["amplitude_mm"] = [0.2]
    same = ask(client, study, 250)["cpu"]
    assert (same["basis"], same["expected_s"]) == ("same-operator", 4.0)
    assert same["least_s"] < 3 < 5 < same["most_s"]
    finer = ask(client, study, 250, numerics={"elements_per_pad": 24})["cpu"]
    assert finer["expected_s"] == pytest.approx(8.0)


def test_the_end_depends_on_workers_and_queue(client: httpx.Client, database: Database, study: Body) -> None:
    assert ask(client, study)["finish"] is None
    url = client.post("/v1/studies", json=study | {"sweep": study["sweep"] | {"speed_kmh": [200, 210]}}).headers[
        "location"
    ]
    compute(database, 10.0)
    announce(database, "one")
    alone = left(ask(client, study))
    announce(database, "two")
    told = ask(client, study)
    assert told["workers"] == 2
    assert left(told) == pytest.approx(alone / 2, rel=0.1)
    assert told["queue_cpu_s"] == pytest.approx(30, rel=0.05)
    assert left(told) == pytest.approx((30 + 40) / 2, rel=0.05)
    urgent = ask(client, study, priority=1)
    assert (urgent["queue_cpu_s"], left(urgent)) == (0, pytest.approx(20, rel=0.05))
    assert left(client.get(url).json()) == pytest.approx(15, rel=0.05)
    finish = told["finish"]
    assert finish["earliest"] <= finish["expected"] <= finish["latest"]


def left(told: dict[str, Any]) -> float:
    """Seconds to the expected end."""
    expected = datetime.fromisoformat(told["finish"]["expected"])
    return (expected - datetime.now(expected.tzinfo)) / timedelta(seconds=1)


BAND: Body = {"kind": "spectrum", "spectrum": "tb3352-ballastless", "wavelength_band_m": [{"min": 2, "max": 30}]}
WAVE: Body = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.1]}


@pytest.mark.parametrize(
    ("speeds", "irregularity", "numerics", "expected"),
    [
        ([300, 350], BAND, {}, []),
        ([250, 300], BAND, {}, [("spectrum-outside-speeds", "/sweep/speed_kmh", 1)]),
        (
            [300],
            BAND | {"wavelength_band_m": [{"min": 2, "max": 250}, {"min": 2, "max": 40}]},
            {"window_s": 20},
            [("spectrum-outside-band", "/sweep/irregularity", 1)],
        ),
        (
            [350],
            BAND | {"wavelength_band_m": [{"min": 1.5, "max": 30}]},
            {},
            [("spectrum-outside-band", "/sweep/irregularity", 1), ("p2-resonance", "/sweep/speed_kmh", 1)],
        ),
        ([150, 220, 350], WAVE, {}, [("p2-resonance", "/sweep/speed_kmh", 1)]),
        ([150], WAVE | {"wavelength_m": [40.0]}, {"window_s": 2}, [("short-window", "/numerics/window_s", 1)]),
        ([350], WAVE, {"time_step_s": 4e-4}, [("coarse-step", "/numerics/time_step_s", 1)]),
        ([350], {"kind": "none"}, {}, []),
    ],
)
def test_warnings(
    lenient_client: httpx.Client, study: Body, speeds: list[float], irregularity: Body, numerics: Body, expected: Any
) -> None:
    study["sweep"]["irregularity"] = irregularity
    told = ask(lenient_client, study, *speeds, numerics=numerics)["warnings"]
    found = [(each["code"], each["pointer"], each["cases"]) for each in told]
    assert found == expected


def test_the_resonance_is_where_theory_has_it() -> None:
    """61 to 65 Hz with pads every 0.625 m, in the frequency domain."""
    track = replace(TRACKS["crts2"].values, pad_spacing=0.625)
    assert 61 <= p2_hz(track, VEHICLES["crh3"].values) <= 65


def test_what_cannot_be_created_cannot_be_estimated(lenient_client: httpx.Client, study: Body, problem: Check) -> None:
    study["sweep"]["irregularity"] = WAVE | {"wavelength_m": [0.2]}
    study["numerics"] = {"time_step_s": 1e-3}
    answers = [lenient_client.post(path, json=study) for path in ("/v1/studies", "/v1/study-estimates")]
    details = [problem(answer, 422) for answer in answers]
    assert details[0]["errors"] == details[1]["errors"] != []
