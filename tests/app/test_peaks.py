"""Peaks across studies: every filter, every order, page by page, on both databases."""

import csv
import io
import json
import random
from collections.abc import Callable
from typing import Any

import httpx
import psycopg
import pyarrow.parquet as pq
import pytest
from sqlalchemy import update
from sqlalchemy.exc import OperationalError

from app.cases.views import CASE_ORDERS
from app.db.models import Study
from app.db.session import Database
from app.peaks.export import as_csv, export
from app.peaks.schemas import COLUMNS, PeakFilters
from app.studies.presets import PRESETS
from app.studies.varying import varied_paths
from tests.outcomes import succeed
from worker.claim import claim

Check = Callable[..., dict[str, Any]]
STATISTICS = ["peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m"]


def peak(quantity: str, value: float, position: str = "wheelset_1") -> dict[str, Any]:
    return {"quantity": quantity, "position": position, "unit": "N"} | dict.fromkeys(STATISTICS, value)


@pytest.fixture
def peaks(client: httpx.Client, database: Database, study: dict[str, Any]) -> list[dict[str, Any]]:
    """Two studies, harmonic and spectrum, whose cases have three peaks each."""
    client.post("/v1/studies", json=study)
    study["sweep"]["irregularity"] = {
        "kind": "spectrum",
        "percentile": [25, 90],
        "wavelength_band_m": [{"min": 2, "max": 30}, {"min": 4, "max": 30}],
    }
    client.post("/v1/studies", json=study)
    number = 0
    with database.write() as session:
        while batch := claim(session, "test", 15.0, lanes=1):
            (held,) = batch
            number += 1
            found = [peak("wheel_rail_force", 1e5 + number), peak("pad_force", 3e4), peak("pad_force", 2e4, "middle")]
            assert succeed(session, held, peaks=found, processing={}, history=None, cpu_s=1.0)
    return walk(client)


def test_peaks_come_with_their_conditions(peaks: list[dict[str, Any]]) -> None:
    assert len(peaks) == 3 * (4 + 8)
    assert list(peaks[0]) == [*COLUMNS, "parameters"]
    assert {(each["irregularity"], each["percentile"], each["amplitude_mm"]) for each in peaks} == {
        *[("harmonic", None, amplitude) for amplitude in (0.1, 0.3)],
        *[("spectrum", percentile, None) for percentile in (25, 90)],
    }


def test_the_peaks_of_one_case(client: httpx.Client, peaks: list[dict[str, Any]], problem: Check) -> None:
    names = [*client.get("/v1/cases/3/peaks").json()["items"][0]]
    assert names == [name for name in COLUMNS if name in names] == [*COLUMNS[COLUMNS.index("quantity") :]]
    expected = [{name: each[name] for name in names} for each in peaks if each["case_id"] == 3]
    assert client.get("/v1/cases/3/peaks").json()["items"] == expected
    problem(client.get("/v1/cases/99/peaks"), 404, "not-found")


def test_any_column_sorts_in_both_directions(client: httpx.Client, peaks: list[dict[str, Any]]) -> None:
    for order in [sign + column for column in COLUMNS for sign in ("", "-")]:
        ordered = walk(client, sort=order)
        assert sorted(map(repr, ordered)) == sorted(map(repr, peaks))  # each once, over all pages
        values = [each[order.removeprefix("-")] for each in ordered]
        present = [value for value in values if value is not None]
        assert values == [*present, *[None] * (len(values) - len(present))], order
        assert present == sorted(present, reverse=order.startswith("-")), order


def test_values_of_all_quantities_are_in_one_order(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    """They overlap in part, and some are equal."""
    client.post("/v1/studies", json=study)
    chance = random.Random(1)
    with database.write() as session:
        while batch := claim(session, "test", 15.0, lanes=1):
            found = [
                peak(f"quantity_{n}", float(n + chance.randrange(4)), position)
                for n in range(6)
                for position in ("first", "second")
                if n != 5 or position == "first"
            ]
            assert succeed(session, batch[0], peaks=found, processing={}, history=None, cpu_s=1.0)
    for query in ({}, {"position": "second"}, {"value_min": "4"}, {"speed_kmh_max": "250"}):
        peaks = walk(client, **query)
        for sort in ("rms", "-rms", "mean", "-time_s"):
            ordered = walk(client, **query, sort=sort, page_size="7")
            assert sorted(map(repr, ordered)) == sorted(map(repr, peaks))
            values = [each[sort.removeprefix("-")] for each in ordered]
            assert values == sorted(values, reverse=sort.startswith("-")), (query, sort)


FILTERS: list[tuple[dict[str, str], Callable[[dict[str, Any]], bool]]] = [
    ({"quantity": "pad_force", "position": "middle"}, lambda each: each["position"] == "middle"),
    ({"slab": "continuous"}, lambda each: True),
    ({"slab": "wooden"}, lambda each: False),
    ({"irregularity": "harmonic"}, lambda each: each["irregularity"] == "harmonic"),
    ({"spectrum": "tb3352-ballastless"}, lambda each: each["irregularity"] == "spectrum"),
    ({"speed_kmh_min": "300"}, lambda each: each["speed_kmh"] == 300),
    ({"speed_kmh_max": "250"}, lambda each: each["speed_kmh"] == 250),
    ({"percentile": "90"}, lambda each: each["percentile"] == 90),
    ({"wavelength_min_m": "4"}, lambda each: each["wavelength_min_m"] == 4),
    ({"wavelength_max_m": "30"}, lambda each: each["wavelength_max_m"] == 30),
    ({"wavelength_m": "1"}, lambda each: each["wavelength_m"] == 1),
    ({"value_min": "30000", "value_max": "100006"}, lambda each: 30000 <= each["peak"] <= 100006),
]


def test_filters(client: httpx.Client, peaks: list[dict[str, Any]]) -> None:
    for query, keeps in FILTERS:
        assert walk(client, **query) == [each for each in peaks if keeps(each)], query


def test_peaks_of_one_study(client: httpx.Client, peaks: list[dict[str, Any]]) -> None:
    for study in client.get("/v1/studies").json()["items"]:
        cases = {case["id"] for case in client.get(f"/v1/studies/{study['id']}/cases").json()["items"]}
        assert walk(client, study_id=study["id"]) == [each for each in peaks if each["case_id"] in cases]


def test_cases_are_chosen_and_sorted_alike(client: httpx.Client, peaks: list[dict[str, Any]]) -> None:
    study = client.get("/v1/studies", params={"sort": "-created_at"}).json()["items"][0]["id"]

    def cases(**query: str) -> list[dict[str, Any]]:
        items: list[dict[str, Any]] = client.get(f"/v1/studies/{study}/cases", params=query).json()["items"]
        return items

    assert len(cases()) == 8
    assert {each["percentile"] for each in cases(percentile="25")} == {25}
    assert {each["speed_kmh"] for each in cases(speed_kmh_min="260", speed_kmh_max="300")} == {300}
    assert (len(cases(slab="continuous")), cases(slab="wooden"), cases(irregularity="harmonic")) == (8, [], [])
    for order in CASE_ORDERS[1:]:
        for sign in ("", "-"):
            values = [each[order] for each in cases(sort=sign + order)]
            assert values == sorted(values, reverse=sign == "-")
    assert cases(sort="-position") == cases()[::-1]


def test_exports_hold_what_pages_hold(client: httpx.Client, peaks: list[dict[str, Any]]) -> None:
    digests = {case: client.get(f"/v1/cases/{case}").json()["digest"] for case in {each["case_id"] for each in peaks}}
    for query in ({}, {"sort": "-percentile", "quantity": "pad_force"}, {"sort": "peak", "slab": "wooden"}):
        expected = [each | {"case_digest": digests[each["case_id"]]} for each in walk(client, **query)]
        for each in expected:
            assert each.pop("parameters") == {}
        answer = client.get("/v1/peaks.csv", params=query)
        assert answer.headers["content-type"] == "text/csv; charset=utf-8"
        assert answer.headers["content-disposition"] == 'attachment; filename="peaks.csv"'
        lines = answer.text.split("\r\n")
        assert lines[0] == ",".join([*COLUMNS, "case_digest"])
        assert len(lines) == len(expected) + 2  # the last is ended, too
        texts = [{k: "" if v is None else str(v) for k, v in each.items()} for each in expected]
        assert list(csv.DictReader(io.StringIO(answer.text, newline=""))) == texts
        answer = client.get("/v1/peaks.parquet", params=query)
        assert answer.headers["content-type"] == "application/vnd.apache.parquet"
        table = pq.read_table(io.BytesIO(answer.content))
        assert table.to_pylist() == expected
        assert json.loads(table.schema.metadata[b"filters"]) == {"sort": "case_id"} | query
        assert table.schema.field("speed_kmh").metadata == {b"unit": b"km/h"}
        assert table.schema.field("rms").metadata == {b"unit_column": b"unit"}


def test_exports_refuse_what_pages_need(client: httpx.Client, problem: Callable[..., dict[str, Any]]) -> None:
    for file in ("csv", "parquet"):
        problem(client.get(f"/v1/peaks.{file}", params={"page_size": 5}), 422)
        problem(client.get(f"/v1/peaks.{file}", params={"speed_kmh_min": "nan"}), 422)


STIFFNESS, ELEMENTS, SHEAR = (
    "track.pad_stiffness_n_per_m",
    "numerics.elements_per_pad",
    "track.joint.shear_stiffness_n_per_m",
)


@pytest.fixture
def varied(client: httpx.Client, database: Database, study: dict[str, Any]) -> dict[str, Any]:
    """A study that varies two parameters, with a peak for each of its cases."""
    study["sweep"] |= {"vary": {STIFFNESS: [4e7, 6e7], ELEMENTS: [12, 14]}, "speed_kmh": [250]}
    study["sweep"]["irregularity"]["amplitude_mm"] = [0.1]
    created: dict[str, Any] = client.post("/v1/studies", json=study).json()
    with database.write() as session:
        while batch := claim(session, "test", 15.0, lanes=1):
            found = [peak("pad_force", float(batch[0].case_id))]
            assert succeed(session, batch[0], peaks=found, processing={}, history=None, cpu_s=1.0)
    return created


def test_peaks_of_a_study_tell_what_it_varies(client: httpx.Client, varied: dict[str, Any]) -> None:
    expected = [{STIFFNESS: k, ELEMENTS: n} for k in (4e7, 6e7) for n in (12, 14)]
    found = walk(client, study_id=varied["id"])
    assert [each["parameters"] for each in found] == expected
    assert list(found[0]["parameters"]) == [STIFFNESS, ELEMENTS]
    assert type(found[0]["parameters"][ELEMENTS]) is int
    assert [each["parameters"] for each in walk(client)] == [{}] * 4
    for each in found:
        inputs = client.get(f"/v1/cases/{each['case_id']}").json()["inputs"]
        assert inputs["track"]["pad_stiffness_n_per_m"] == each["parameters"][STIFFNESS]
    rows = csv.DictReader(io.StringIO(client.get("/v1/peaks.csv", params={"study_id": varied["id"]}).text, newline=""))
    assert [(float(row[STIFFNESS]), row[ELEMENTS]) for row in rows] == [
        (each[STIFFNESS], str(each[ELEMENTS])) for each in expected
    ]
    table = pq.read_table(
        io.BytesIO(client.get("/v1/peaks.parquet", params={"study_id": varied["id"]}).content),
        columns=[STIFFNESS, ELEMENTS],
    )
    assert table.to_pylist() == expected
    assert table.schema.field(STIFFNESS).metadata == {b"unit": b"N/m"}


def test_any_parameter_can_be_asked_for(
    client: httpx.Client, varied: dict[str, Any], problem: Callable[..., dict[str, Any]]
) -> None:
    query = {"parameter": [SHEAR, STIFFNESS, SHEAR], "study_id": varied["id"]}
    items = client.get("/v1/peaks", params=query).json()["items"]
    assert [list(each["parameters"]) for each in items] == [[SHEAR, STIFFNESS]] * 4
    header, _, _ = client.get("/v1/peaks.csv", params={"parameter": SHEAR}).text.partition("\r\n")
    assert header == ",".join([*COLUMNS, "case_digest", SHEAR])
    assert {each["parameters"][SHEAR] for each in walk(client, parameter=SHEAR)} == {1e8}
    details = problem(client.get("/v1/peaks", params={"parameter": "track.colour"}), 422)
    assert details["errors"][0]["pointer"] == "/query/parameter/0"


def test_lists_and_presets_vary_too() -> None:
    one, other = {"vary": {SHEAR: 1e8}}, {"vary": {ELEMENTS: 14, STIFFNESS: 4e7}}
    assert varied_paths({"sweep": {"kind": "list", "cases": [one, {}, other]}}) == [STIFFNESS, SHEAR, ELEMENTS]
    of_presets = {name: varied_paths({"sweep": name}) for name in PRESETS}
    assert of_presets == {name: list(preset.study["sweep"].get("vary", {})) for name, preset in PRESETS.items()}
    assert any(of_presets.values())
    assert varied_paths({"sweep": "a preset of the past"}) == []


def test_an_export_holds_no_connection_while_somebody_reads(peaks: list[dict[str, Any]], database: Database) -> None:
    """Else fifteen slow readers would exhaust PostgreSQL's pool. What comes meanwhile may be in the file or not."""
    exports = [as_csv(export(database, PeakFilters(sort="-peak"), at_once=5)) for _ in range(20)]
    begun = [next(each) for each in exports]
    assert database.engine.pool.checkedout() == 0  # type: ignore[attr-defined]  # of every pool that is used
    with database.write() as session:
        session.execute(update(Study).values(name="written meanwhile"))
    for begin, rest in zip(begun, exports, strict=True):
        lines = b"".join([begin, *rest]).decode().splitlines()
        assert [float(line["peak"]) for line in csv.DictReader(lines)] == sorted(
            (each["peak"] for each in peaks), reverse=True
        )


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_an_export_breaks_off_with_the_database(peaks: list[dict[str, Any]], database: Database) -> None:
    written = as_csv(export(database, PeakFilters(), at_once=5))
    assert next(written).count(b"\r\n") == 6
    url = database.engine.url
    with psycopg.connect(host=url.query["host"], user=url.username, dbname="postgres", autocommit=True) as other:
        others = f"datname = '{url.database}'"
        other.execute(f"ALTER DATABASE {url.database} ALLOW_CONNECTIONS false")
        try:
            other.execute(f"SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE {others}")
            with pytest.raises(OperationalError):
                list(written)
        finally:
            other.execute(f"ALTER DATABASE {url.database} ALLOW_CONNECTIONS true")


def walk(client: httpx.Client, **query: str) -> list[dict[str, Any]]:
    """Every peak, page by page."""
    items: list[dict[str, Any]] = []
    while True:
        page = client.get("/v1/peaks", params={"page_size": "13", **query}).json()
        items += page["items"]
        if page["next_cursor"] is None:
            return items
        query["cursor"] = page["next_cursor"]
