"""What the catalogue says is what the service takes."""

import json
from collections.abc import Callable
from typing import Any

import httpx
import pytest

from solver.catalogue import SPECTRA, TRACKS, VEHICLES

Check = Callable[..., dict[str, Any]]


def listed(client: httpx.Client, what: str) -> list[dict[str, Any]]:
    response = client.get(f"/v1/{what}")
    assert response.status_code == 200, response.text
    items: list[dict[str, Any]] = response.json()["items"]
    return items


def test_quantities_have_positions_units_and_marked_limits(lenient_client: httpx.Client) -> None:
    quantities = {each["name"]: each for each in listed(lenient_client, "quantities")}
    force, slow = quantities["wheel_rail_force"], quantities["wheel_rail_force_20hz"]
    assert (force["unit"], force["peak"], force["derived_from"]) == ("N", "maximum", None)
    assert force["positions"] == slow["positions"] == [f"wheelset_{n}" for n in (1, 2, 3, 4)]
    assert slow["derived_from"] == "wheel_rail_force"
    assert quantities["slab_moment"]["positions"] == ["wheelset_1", "joints"]
    assert [(each["value"], each["mark"]) for each in force["limits"]] == [(170e3, "C")]
    assert {each["mark"] for quantity in quantities.values() for each in quantity["limits"]} == {"V", "C"}


@pytest.mark.parametrize(("part", "catalogue"), [("track", TRACKS), ("vehicle", VEHICLES)])
def test_values_of_a_named_set_make_it_again(
    part: str, catalogue: dict[str, Any], lenient_client: httpx.Client, client: httpx.Client, study: dict[str, Any]
) -> None:
    """All values of the last set, written over the first, are the last."""
    items = listed(lenient_client, f"{part}s")
    assert [each["name"] for each in items] == list(catalogue)
    values: dict[str, Any] = {}
    for each in items[-1]["values"]:
        assert each["source"]
        assert each["basis"]
        assert each["mark"] in "VCA"
        outer, _, inner = each["name"].rpartition(".")
        number = int(each["value"]) if each["name"].endswith("pads_per_slab") else each["value"]
        (values.setdefault(outer, {}) if outer else values)[inner] = number
    overwritten = client.post("/v1/studies", json=study | {part: {"base": items[0]["name"]} | values})
    named = client.post("/v1/studies", json=study | {part: {"base": items[-1]["name"]}})
    digests = [
        [case["digest"] for case in client.get(f"{each.headers['location']}/cases").json()["items"]]
        for each in (overwritten, named)
    ]
    assert digests[0] == digests[1]


def test_spectra_are_defined_as_one_s_own_would_be(
    lenient_client: httpx.Client, client: httpx.Client, study: dict[str, Any]
) -> None:
    items = listed(lenient_client, "spectra")
    assert [each["name"] for each in items] == list(SPECTRA)
    assert items[0]["wavelength_range_m"] == {"min": 2, "max": 200}
    assert items[0]["speed_range_kmh"] == {"min": 300, "max": 350}
    assert (items[0]["unit"], items[1]["unit"]) == ("m^2/(1/m)", "m^2/(rad/m)")
    for each in items:
        assert {source["name"] for source in each["sources"]} == set(each["definition"]) - {"kind"}
        own = {"kind": "spectrum", "spectrum": each["definition"], "wavelength_band_m": [{"min": 4, "max": 30}]}
        study["sweep"]["irregularity"] = own
        assert client.post("/v1/studies", json=study).status_code == 201


def test_presets_can_be_posted_by_name_and_as_they_are(client: httpx.Client) -> None:
    presets = {each["name"]: each for each in listed(client, "presets")}
    assert {"article-speed-continuous", "article-speed-discontinuous", "article-percentiles"} < set(presets)
    preset = presets["article-wavelength-bands"]
    whole = client.post("/v1/studies", json=preset["study"]).json()
    by_name = client.post("/v1/studies", json={"name": "By name", "sweep": preset["name"]}).json()
    assert whole["cases"]["total"] == by_name["cases"]["total"] == preset["cases"] == 5
    assert by_name["definition"] == {"name": "By name", "sweep": preset["name"]}
    cases = [client.get(f"/v1/studies/{each['id']}/cases").json() for each in (whole, by_name)]
    assert cases[0] == cases[1]


def test_limits_are_those_that_are_kept(lenient_client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    limits = lenient_client.get("/v1/limits").json()
    assert limits["max_cases_per_study"] == 1000
    parameters = {each.pop("path"): each for each in limits["parameters"]}
    bounds = {"minimum": 0, "exclusive_minimum": None, "maximum": 1e9, "exclusive_maximum": None}
    shear = {"unit": "N s/m", "meaning": "damping of a jump between slabs", "integer": False, "default": 8e4}
    assert parameters["track.joint.shear_damping_ns_per_m"] == shear | bounds
    for path, each in parameters.items():
        if each["maximum"] is not None:
            above = 2 * each["maximum"]
            study["sweep"]["vary"] = {path: [int(above) if each["integer"] else above]}
            (error,) = problem(lenient_client.post("/v1/studies", json=study), 422)["errors"]
            assert error["pointer"] == f"/sweep/vary/{path}/0"


def test_too_many_cases_are_counted_and_never_made(lenient_client: httpx.Client, problem: Check) -> None:
    """A count of these cases cannot be had by making them."""
    vary = {"track.pad_stiffness_n_per_m": [1e7 + n for n in range(1000)], "numerics.window_s": [3, 4, 5]}
    irregularity = {"kind": "spectrum", "wavelength_band_m": [{"min": 2, "max": 30}], "realisations": 2**31}
    speeds = {"kind": "range", "start": 10, "stop": 600, "step": 0.001}
    sweep = {"kind": "product", "speed_kmh": speeds, "irregularity": irregularity, "vary": vary}
    body = json.dumps({"name": "Everything", "sweep": sweep})
    response = lenient_client.post("/v1/studies", content=body, headers={"Content-Type": "application/json"})
    details = problem(response, 422, "max-cases-per-study")
    assert f"{590_001 * 1000 * 3 * 2**31} cases" in details["detail"]
    assert details["errors"][0]["pointer"] == "/sweep"
