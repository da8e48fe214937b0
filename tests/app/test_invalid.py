"""Whatever a client sends, the answer is a problem that names the field, and nothing is stored."""

import json
import tracemalloc
from collections.abc import Callable
from typing import Any

import httpx
import pytest

Check = Callable[..., dict[str, Any]]

NESTED = "[" * 100_000 + "]" * 100_000

# What is put where in a valid study (None in the middle of a path starts a new one), and the pointer that must come.
WAVE = {"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.1}
SPECTRUM = {"kind": "power-law", "per": "1/m", "coefficients": [1e-8], "exponents": [2, 3]}
SPOILT: dict[str, tuple[tuple[str, ...], Any, str]] = {
    "unknown field": (("colour",), "red", "/colour"),
    "unknown field within": (("track",), {"pad_stifness_n_per_m": 6e7}, "/track/pad_stifness_n_per_m"),
    "NaN": (("sweep", "speed_kmh"), [float("nan")], "/sweep/speed_kmh/0"),
    "infinity": (("sweep", "speed_kmh"), [300, float("inf")], "/sweep/speed_kmh/1"),
    "negative speed": (("sweep", "speed_kmh"), [-300], "/sweep/speed_kmh/0"),
    "too fast": (("sweep", "speed_kmh"), [300, 601], "/sweep/speed_kmh/1"),
    "number as text": (("sweep", "speed_kmh"), ["300"], "/sweep/speed_kmh/0"),
    "true as number": (("sweep", "speed_kmh"), [True], "/sweep/speed_kmh/0"),
    "number as list": (("sweep", "speed_kmh"), 300, "/sweep/speed_kmh"),
    "null": (("sweep", "speed_kmh"), None, "/sweep/speed_kmh"),
    "empty list": (("sweep", "speed_kmh"), [], "/sweep/speed_kmh"),
    "listed twice": (("sweep", "speed_kmh"), [300, 300.0], "/sweep/speed_kmh"),
    "huge integer": (("sweep", "speed_kmh"), [10**400], "/sweep/speed_kmh/0"),
    "range backwards": (
        ("sweep", "speed_kmh"),
        {"kind": "range", "start": 350, "stop": 160, "step": 10},
        "/sweep/speed_kmh",
    ),
    "range without end": (
        ("sweep", "speed_kmh"),
        {"kind": "range", "start": 160, "stop": 350, "step": 0},
        "/sweep/speed_kmh/step",
    ),
    "range of 10^9 steps": (
        ("sweep", "speed_kmh"),
        {"kind": "range", "start": 160, "stop": 350, "step": 1.9e-7},
        "/sweep/speed_kmh/step",
    ),
    "unknown slab": (("sweep", "slab"), ["wooden"], "/sweep/slab/0"),
    "unknown kind": (("sweep", "irregularity"), {"kind": "square"}, "/sweep/irregularity"),
    "no kind": (("sweep", "irregularity"), {}, "/sweep/irregularity"),
    "missing field": (
        ("sweep", "irregularity"),
        {"kind": "spectrum"},
        "/sweep/irregularity/wavelength_band_m",
    ),
    "percentile 100": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "percentile": [100], "wavelength_band_m": [{"min": 2, "max": 30}]},
        "/sweep/irregularity/percentile/0",
    ),
    "unknown spectrum": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "spectrum": "white", "wavelength_band_m": [{"min": 2, "max": 30}]},
        "/sweep/irregularity/spectrum",
    ),
    "own spectrum without convention": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "spectrum": SPECTRUM, "wavelength_band_m": [{"min": 2, "max": 30}]},
        "/sweep/irregularity/spectrum/sides",
    ),
    "own spectrum of unequal parts": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "spectrum": SPECTRUM | {"sides": 1}, "wavelength_band_m": [{"min": 2, "max": 30}]},
        "/sweep/irregularity/spectrum/exponents",
    ),
    "own spectrum of no kind": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "spectrum": {}, "wavelength_band_m": [{"min": 2, "max": 30}]},
        "/sweep/irregularity/spectrum",
    ),
    "dip deeper than deep": (
        ("sweep", "irregularity"),
        {"kind": "sum", "terms": [WAVE, {"kind": "dip", "position_m": 1, "length_m": 1, "depth_mm": 21}]},
        "/sweep/irregularity/terms/1/depth_mm",
    ),
    "band upside down in a sum": (
        ("sweep", "irregularity"),
        {"kind": "sum", "terms": [WAVE, {"kind": "spectrum", "wavelength_band_m": {"min": 30, "max": 2}}]},
        "/sweep/irregularity/terms/1/wavelength_band_m",
    ),
    "sum of a sum": (
        ("sweep", "irregularity"),
        {"kind": "sum", "terms": [{"kind": "sum", "terms": [WAVE]}]},
        "/sweep/irregularity/terms/0",
    ),
    "band upside down": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "wavelength_band_m": [{"min": 30, "max": 2}]},
        "/sweep/irregularity/wavelength_band_m",
    ),
    "seed beyond 63 bits": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "wavelength_band_m": [{"min": 2, "max": 30}], "seed": 2**63},
        "/sweep/irregularity/seed",
    ),
    "10^6 cases": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "wavelength_band_m": [{"min": 2, "max": 30}], "realisations": 500_000},
        "/sweep",
    ),
    "10^9 realisations": (
        ("sweep", "irregularity"),
        {"kind": "spectrum", "wavelength_band_m": [{"min": 2, "max": 30}], "realisations": 10**9},
        "/sweep",
    ),
    "null as override": (("track",), {"pad_stiffness_n_per_m": None}, "/track/pad_stiffness_n_per_m"),
    "negative mass": (("vehicle",), {"bogie_mass_kg": -1}, "/vehicle/bogie_mass_kg"),
    "unknown tread": (("vehicle",), {"wheel_tread": "square"}, "/vehicle/wheel_tread"),
    "unknown track": (("track",), {"base": "gravel"}, "/track/base"),
    "fraction as count": (("numerics",), {"elements_per_pad": 12.5}, "/numerics/elements_per_pad"),
    "wheelbase beyond the car": (
        ("vehicle",),
        {"half_wheelbase_m": 2.5, "half_bogie_distance_m": 2.0},
        "/vehicle/half_wheelbase_m",
    ),
    "track shorter than the car": (("numerics",), {"absorbing_length_m": 60.0}, "/numerics/track_length_m"),
    "next to nothing": (
        ("track",),
        {"rail_elastic_modulus_pa": 5e-324, "rail_second_moment_m4": 5e-324},
        "/sweep",
    ),
    "no name": (("name",), "", "/name"),
    "NUL in a name": (("name",), "a\0b", "/name"),
    "text as priority": (("priority",), "high", "/priority"),
    "priority beyond 64 bits": (("priority",), 2**64, "/priority"),
    "label that is a number": (("labels",), {"line": 1}, "/labels/line"),
    "slash and tilde in a key": (("labels",), {"a/b~c": 1}, "/labels/a~1b~0c"),
    "a list as study": ((), [], ""),
    "a number as study": ((), 1e400, ""),
}


@pytest.mark.parametrize("case", SPOILT)
def test_invalid_study(case: str, lenient_client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    path, value, pointer = SPOILT[case]
    body: Any = study
    if path:
        at = study
        for part in path[:-1]:
            at = at[part]
        at[path[-1]] = value
    else:
        body = value
    response = lenient_client.post(
        "/v1/studies", content=json.dumps(body), headers={"Content-Type": "application/json"}
    )
    details = problem(response, 422)
    assert pointer in [error["pointer"] for error in details["errors"]]
    assert lenient_client.get("/v1/studies").json()["items"] == []


def test_a_study_that_is_too_large_names_the_limit(
    lenient_client: httpx.Client, study: dict[str, Any], problem: Check
) -> None:
    study["sweep"]["speed_kmh"] = {"kind": "range", "start": 160, "stop": 350, "step": 0.1}
    details = problem(lenient_client.post("/v1/studies", json=study), 422, "max-cases-per-study")
    assert "3802" in details["detail"]
    assert "1000" in details["detail"]


MILLION = {
    "a product": {
        "speed_kmh": {"kind": "range", "start": 160, "stop": 169.9, "step": 0.1},
        "irregularity": {"kind": "harmonic", "wavelength_m": [1 + n for n in range(100)], "amplitude_mm": [0.1]},
        "vary": {"track.pad_stiffness_n_per_m": [4e7 + n for n in range(100)]},
    },
    "realisations": {
        "speed_kmh": [300],
        "irregularity": {"kind": "spectrum", "wavelength_band_m": [{"min": 2, "max": 30}], "realisations": 10**6},
    },
}


@pytest.mark.parametrize("path", ["/v1/studies", "/v1/study-estimates"])
@pytest.mark.parametrize("sweep", MILLION)
def test_a_million_cases_are_refused_without_being_made(
    sweep: str, path: str, lenient_client: httpx.Client, problem: Check
) -> None:
    """`python -m benchmarks.large` prints how soon."""
    tracemalloc.start()
    try:
        answer = lenient_client.post(path, json={"name": "Many", "sweep": MILLION[sweep] | {"kind": "product"}})
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert "The sweep has 1000000 cases" in problem(answer, 422, "max-cases-per-study")["detail"]
    assert most < 50e6


@pytest.mark.parametrize(
    "content",
    [b"{", b"", b"nonsense", NESTED.encode(), b'{"name": "\\ud800"}', b"\xff\xfe", b"9" * 5000, b'{"a" "b"}'],
    ids=lambda content: repr(content[:12]),
)
def test_unparsable_body(content: bytes, lenient_client: httpx.Client, problem: Check) -> None:
    response = lenient_client.post("/v1/studies", content=content, headers={"Content-Type": "application/json"})
    problem(response, 400 if content else 422)


@pytest.mark.parametrize("media_type", ["text/plain", "application/x-www-form-urlencoded", "", "json", "a/b/c;;="])
def test_body_of_another_type(media_type: str, lenient_client: httpx.Client, problem: Check) -> None:
    response = lenient_client.post("/v1/studies", content=b"{}", headers={"Content-Type": media_type})
    problem(response, 415, "unsupported-media-type")


@pytest.mark.parametrize("chunked", [False, True])
def test_body_too_large(chunked: bool, lenient_client: httpx.Client, problem: Check) -> None:
    body = b" " * 1_000_001
    content = iter([body]) if chunked else body
    response = lenient_client.post("/v1/studies", content=content, headers={"Content-Type": "application/json"})
    problem(response, 413, "body-too-large")


@pytest.mark.parametrize(
    "path",
    [
        *("/v1", "/v1/studies/", "/v1/studies/x", f"/v1/studies/{'0' * 32}", f"/v1/studies/{'0' * 32}/cases"),
        *("/v1/cases/0", "/v1/cases/x", "/v1/cases/99999999999999999999999", "/v1/cases/1", "/v1/cases/1/history.npz"),
        *("/v1/studies/%00", "/v1/studies/%ff", "/v1/cases/%F0%9F%9A%84", "/v1/cases/1e3"),
    ],
)
def test_not_found(path: str, lenient_client: httpx.Client, problem: Check) -> None:
    problem(lenient_client.get(path), 404, "not-found")


@pytest.mark.parametrize(
    ("method", "path", "allowed"),
    [
        ("DELETE", "/v1/studies", "GET, HEAD, POST"),
        ("PUT", "/v1/peaks", "GET, HEAD"),
        ("POST", f"/v1/studies/{'0' * 32}", "DELETE, GET, HEAD, PATCH"),
        ("BREW", "/v1/cases/1", "GET, HEAD"),
    ],
)
def test_method_not_allowed(method: str, path: str, allowed: str, lenient_client: httpx.Client, problem: Check) -> None:
    response = lenient_client.request(method, path)
    problem(response, 405, "method-not-allowed")
    assert response.headers["allow"] == allowed


@pytest.mark.parametrize(
    ("path", "query", "pointer"),
    [
        ("/v1/studies", "page_size=0", "/query/page_size"),
        ("/v1/studies", "page_size=501", "/query/page_size"),
        ("/v1/studies", "page_size=99999999999999999999999999", "/query/page_size"),
        ("/v1/studies", "state=sleeping", "/query/state"),
        ("/v1/studies", "created_after=yesterday", "/query/created_after"),
        ("/v1/studies", "created_after=2026-01-01T00:00:00", "/query/created_after"),
        ("/v1/studies", "created_after=0.5", "/query/created_after"),
        ("/v1/studies", "created_after=1e-5", "/query/created_after"),
        ("/v1/studies", "created_after=1e400", "/query/created_after"),
        ("/v1/studies", "name=%00", "/query/name"),
        ("/v1/studies", "colour=red", "/query/colour"),
        ("/v1/studies", "sort=colour", "/query/sort"),
        ("/v1/studies", "cursor=nonsense", "/query/cursor"),
        ("/v1/studies", "cursor=%F0%9F%9A%84", "/query/cursor"),
        ("/v1/studies", "cursor=W10=", "/query/cursor"),
        ("/v1/cases/1/history", "max_points=1", "/query/max_points"),
        ("/v1/cases/1/history", "time_min_s=nan", "/query/time_min_s"),
        ("/v1/cases/1/history", "quantity=pad_force&quantity=%00", "/query/quantity/1"),
        ("/v1/cases/1/history", "channel=1", "/query/channel"),
        ("/v1/peaks", "study_id=x", "/query/study_id"),
        ("/v1/peaks", "speed_kmh_min=nan", "/query/speed_kmh_min"),
        ("/v1/peaks", "value_max=inf", "/query/value_max"),
        ("/v1/peaks", "quantity=%00", "/query/quantity"),
        ("/v1/peaks", "sort=id", "/query/sort"),
    ],
)
def test_invalid_query(path: str, query: str, pointer: str, lenient_client: httpx.Client, problem: Check) -> None:
    details = problem(lenient_client.get(f"{path}?{query}"), 422)
    assert pointer in [error["pointer"] for error in details["errors"]]


@pytest.mark.parametrize("query", ["created_after=0001-01-01T00:00:00Z", "created_after=9999-12-31T23:59:59-23:59"])
def test_dates_at_the_ends_of_time(query: str, lenient_client: httpx.Client) -> None:
    assert lenient_client.get(f"/v1/studies?{query}").json()["items"] == []


def test_many_errors_are_cut_short(lenient_client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    study["sweep"]["speed_kmh"] = ["300"] * 10_000
    assert len(problem(lenient_client.post("/v1/studies", json=study), 422)["errors"]) == 100
