"""Measured profiles: uploaded, shared, used by studies, deleted; on both databases."""

import random
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import pytest
from sqlalchemy import func, select

from app.db.models import Case, Profile
from app.db.session import Database
from app.settings import Settings
from solver.case import Measured
from solver.profile import read_profile

Check = Callable[..., dict[str, Any]]

CSV = {"Content-Type": "text/csv"}
HEIGHTS = [random.Random(n).uniform(-1, 1) for n in range(400)]
TEXT = "x_m,eta_mm\n" + "".join(f"{n / 4},{height:.3f}\n" for n, height in enumerate(HEIGHTS))
BAND = {"min": 2, "max": 30}


def upload(client: httpx.Client, text: str = TEXT) -> dict[str, Any]:
    response = client.post("/v1/profiles", content=text.encode(), headers=CSV)
    assert response.status_code == 201, response.text
    assert response.headers["location"] == f"/v1/profiles/{response.json()['id']}"
    profile: dict[str, Any] = response.json()
    return profile


def over(study: dict[str, Any], profile_id: str, **more: Any) -> dict[str, Any]:
    """The study on a measured profile."""
    irregularity = {"kind": "measured", "profile_id": profile_id, **more}
    return study | {"sweep": study["sweep"] | {"irregularity": irregularity}}


def test_a_profile_is_what_was_uploaded(client: httpx.Client) -> None:
    profile = upload(client)
    positions, heights = read_profile(TEXT)
    measured = Measured(positions=positions, heights=heights, wavelength_min=2, wavelength_max=30)
    assert profile["id"] == measured.profile
    assert (profile["points"], profile["start_m"], profile["end_m"]) == (400, 0, 99.75)
    assert (profile["wavelength_min_m"], profile["wavelength_max_m"]) == (0.5, 99.75)
    assert profile["highest_mm"] == pytest.approx(max(heights) * 1e3)
    assert client.get(f"/v1/profiles/{profile['id']}").json() == profile
    download = client.get(f"/v1/profiles/{profile['id']}/profile.csv")
    assert read_profile(download.text) == (positions, heights)
    assert upload(client, download.text) == profile
    headers = {"If-None-Match": download.headers["etag"]}
    assert client.get(f"/v1/profiles/{profile['id']}/profile.csv", headers=headers).status_code == 304


def test_the_same_samples_are_stored_once_also_when_they_come_at_once(client: httpx.Client, database: Database) -> None:
    texts = [TEXT, TEXT.replace(",", ";"), f"# a remark\n{TEXT}"] * 3
    with ThreadPoolExecutor(9) as pool:
        assert len({profile["id"] for profile in pool.map(lambda text: upload(client, text), texts)}) == 1
    with database.read() as session:
        assert session.scalar(select(func.count()).select_from(Profile)) == 1


def test_profiles_are_listed_page_by_page(client: httpx.Client) -> None:
    ids = [upload(client, f"{TEXT}{100 + n},0\n")["id"] for n in range(3)]
    first = client.get("/v1/profiles?page_size=2&sort=created_at").json()
    rest = client.get(f"/v1/profiles?page_size=2&sort=created_at&cursor={first['next_cursor']}").json()
    assert [each["id"] for each in first["items"] + rest["items"]] == ids
    assert [each["id"] for each in client.get("/v1/profiles").json()["items"]] == ids[::-1]


def test_a_study_runs_over_a_profile_without_copying_it(
    client: httpx.Client, database: Database, study: dict[str, Any]
) -> None:
    profile = upload(client)
    created = client.post(
        "/v1/studies", json=over(study, profile["id"], wavelength_band_m=[BAND, {"min": 3, "max": 30}])
    )
    assert created.json()["cases"]["total"] == 4
    with database.read() as session:
        stored = session.scalars(select(Case.inputs).order_by(Case.id)).all()
    assert stored[0]["irregularity"] == {
        "kind": "measured",
        "profile": profile["id"],
        "wavelength_min": 2.0,
        "wavelength_max": 30.0,
    }
    (case, *_) = client.get(f"{created.headers['location']}/cases").json()["items"]
    shown = client.get(f"/v1/cases/{case['id']}").json()["inputs"]["irregularity"]
    assert shown == {"kind": "measured", "profile_id": profile["id"], "wavelength_band_m": BAND}
    assert (case["irregularity"], case["wavelength_min_m"], case["wavelength_max_m"]) == ("measured", 2, 30)


def test_without_a_band_all_that_the_profile_holds_is_used(client: httpx.Client, study: dict[str, Any]) -> None:
    profile = upload(client)
    created = client.post("/v1/studies", json=over(study, profile["id"]))
    assert created.status_code == 201, created.text
    (case, *_) = client.get(f"{created.headers['location']}/cases").json()["items"]
    assert (case["wavelength_min_m"], case["wavelength_max_m"]) == (0.5, 99.75)


def test_a_case_depends_on_what_its_profile_holds(client: httpx.Client, study: dict[str, Any]) -> None:
    profiles = [upload(client), upload(client, TEXT.replace("\n0.25,", "\n0.26,"))]
    studies = [client.post("/v1/studies", json=over(study, each["id"])).headers["location"] for each in profiles]
    digests = [{case["digest"] for case in client.get(f"{url}/cases").json()["items"]} for url in studies]
    assert len(digests[0] | digests[1]) == 4


def test_a_profile_that_a_study_uses_stays(client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    url = f"/v1/profiles/{upload(client)['id']}"
    profile_id = url.rpartition("/")[2]
    terms = [{"kind": "dip", "position_m": 20, "length_m": 1.0, "depth_mm": 0.3}]
    terms += [{"kind": "measured", "profile_id": profile_id, "wavelength_band_m": BAND}]
    within = study | {"sweep": study["sweep"] | {"irregularity": {"kind": "sum", "terms": terms}}}
    created = client.post("/v1/studies", json=within)
    assert created.status_code == 201, created.text
    assert created.json()["id"] in problem(client.delete(url), 409, "profile-in-use")["detail"]
    client.post(f"{created.headers['location']}/cancel")
    client.delete(created.headers["location"])
    assert client.delete(url).status_code == 204
    problem(client.get(url), 404, "not-found")
    problem(client.delete(url), 404, "not-found")
    details = problem(client.post("/v1/studies", json=within), 422)
    assert details["errors"][0]["pointer"] == "/sweep/irregularity/terms/1/profile_id"


@pytest.mark.parametrize(
    ("irregularity", "pointer", "words"),
    [
        ({"profile_id": "0" * 64}, "profile_id", "names no stored profile"),
        ({"profile_id": "x"}, "profile_id", "pattern"),
        ({"wavelength_band_m": [{"min": 0.3, "max": 30}]}, "wavelength_band_m", "sample 1 must lie"),
        ({"wavelength_band_m": [{"min": 2, "max": 300}]}, "wavelength_band_m", "longer than the profile, 99.75 m"),
        ({"wavelength_band_m": []}, "wavelength_band_m", "at least 1"),
        ({"file": "profile.csv"}, "file", "not permitted"),
    ],
)
def test_what_a_profile_does_not_hold_is_named(
    irregularity: dict[str, Any],
    pointer: str,
    words: str,
    lenient_client: httpx.Client,
    study: dict[str, Any],
    problem: Check,
) -> None:
    chosen = {"profile_id": upload(lenient_client)["id"]} | irregularity
    (error,) = problem(lenient_client.post("/v1/studies", json=over(study, **chosen)), 422)["errors"]
    assert error["pointer"] == f"/sweep/irregularity/{pointer}"
    assert words in error["detail"]


@pytest.mark.parametrize(
    ("text", "pointer", "words"),
    [
        (TEXT.replace("\n0.5,", "\n0.2,"), "/line/4", "beyond 0.25 m"),
        (TEXT.replace("\n0.5,", "\nhalf,"), "/line/4", "two numbers"),
        (TEXT.replace("eta_mm", "eta_m"), "/line/2", "mind the units"),
        (TEXT.replace("eta_mm", "eta_ft"), "/line/1", "m or mm"),
        ("x,eta\n0,0\n1,0\n", "", "at least 16 points"),
        ("", "", "at least 16 points"),
        ("".join(f"{n},0\n" for n in [*range(16), 100]), "", "as wide as half the profile"),
    ],
)
def test_a_wrong_line_is_named(
    text: str, pointer: str, words: str, lenient_client: httpx.Client, problem: Check
) -> None:
    (error,) = problem(lenient_client.post("/v1/profiles", content=text.encode(), headers=CSV), 422)["errors"]
    assert error["pointer"] == pointer
    assert words in error["detail"]


def test_bodies_that_are_no_csv(lenient_client: httpx.Client, problem: Check) -> None:
    problem(lenient_client.post("/v1/profiles", content=b"\xff\xfe", headers=CSV), 400, "unparsable")
    refused = lenient_client.post("/v1/profiles", json={"x": [0, 1]})
    problem(refused, 415, "unsupported-media-type")
    assert refused.headers["accept"] == "text/csv"
    problem(lenient_client.post("/v1/profiles", content=b"0,0\n"), 415)


def test_a_profile_may_be_too_large(settings: Settings, serve: Any, problem: Check) -> None:
    with serve(settings.model_copy(update={"max_profile_bytes": len(TEXT)})) as client:
        upload(client)
        refused = client.post("/v1/profiles", content=f"{TEXT}\n".encode(), headers=CSV)
        assert str(len(TEXT)) in problem(refused, 413, "body-too-large")["detail"]
        assert client.get("/v1/limits").json()["max_profile_bytes"] == len(TEXT)
