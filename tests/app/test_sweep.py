"""Pure functions of the boundary: counting, expansion, conversion, cursors, pointers."""

import dataclasses
import json
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.cases.schemas import (
    CaseFile,
    Model,
    NumericsOverrides,
    TrackOverrides,
    VehicleOverrides,
    case_file,
    conditions,
)
from app.pagination import decode_cursor, encode_cursor
from app.pointer import pointer_to
from app.problems import Problem
from app.studies.schemas import pointer_to_parameter
from app.studies.sweep import ProductSweep, SpeedRange
from solver.case import Case, Numerics, Track, Vehicle
from solver.catalogue import TRACKS, VEHICLES
from solver.quantity import quantities


def listed(values: st.SearchStrategy[Any], most: int = 4) -> st.SearchStrategy[list[Any]]:
    return st.lists(values, min_size=1, max_size=most, unique=True)


def decimals(low: float, high: float, places: int = 3) -> st.SearchStrategy[float]:
    """Numbers as people write them."""
    scale = 10**places
    return st.integers(math.ceil(low * scale), math.floor(high * scale)).map(lambda n: n / scale)


SPEEDS = listed(decimals(10, 600)) | st.builds(
    lambda start, steps, step: {"kind": "range", "start": start, "stop": start + steps * step, "step": step},
    decimals(10, 300),
    st.integers(0, 20),
    decimals(0.1, 10, 1),
)
BANDS = st.builds(lambda low, width: {"min": low, "max": low + width}, decimals(0.1, 50), decimals(1, 100))
OWN = {"kind": "power-law", "per": "1/m", "sides": 1, "coefficients": [1e-8], "exponents": [2], "breaks": []}
IRREGULARITIES = st.one_of(
    st.just({"kind": "none"}),
    st.fixed_dictionaries(
        {
            "kind": st.just("harmonic"),
            "wavelength_m": listed(decimals(0.1, 200)),
            "amplitude_mm": listed(decimals(0, 20)),
        }
    ),
    st.just({"kind": "dip", "position_m": 20, "length_m": 1.0, "depth_mm": 0.3}),
    st.just({"kind": "sum", "terms": [{"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.1}]}),
    st.fixed_dictionaries(
        {
            "kind": st.just("spectrum"),
            "spectrum": st.sampled_from(["fra-6", OWN]),
            "percentile": listed(decimals(0.1, 99.9)),
            "wavelength_band_m": st.lists(BANDS, min_size=1, max_size=3, unique_by=lambda band: tuple(band.values())),
            "realisations": st.integers(1, 5),
            "seed": st.integers(0, 2**63 - 1),
        }
    ),
)
SWEEPS = st.fixed_dictionaries({"kind": st.just("product"), "speed_kmh": SPEEDS, "irregularity": IRREGULARITIES})


@given(SWEEPS)
def test_a_sweep_counts_what_it_expands_to(sweep: dict[str, Any]) -> None:
    parsed = ProductSweep.model_validate(sweep)
    irregularities = list(parsed.irregularity.expand())
    assert len(irregularities) == parsed.irregularity.count()
    speeds = parsed.speed_kmh.expand() if isinstance(parsed.speed_kmh, SpeedRange) else parsed.speed_kmh
    assert len(set(speeds)) * len(irregularities) == parsed.count()


@given(SWEEPS)
def test_a_sweep_survives_json(sweep: dict[str, Any]) -> None:
    parsed = ProductSweep.model_validate(sweep)
    assert ProductSweep.model_validate_json(parsed.model_dump_json()) == parsed


def test_a_range_includes_its_stop() -> None:
    speeds = SpeedRange(kind="range", start=160, stop=350, step=10).expand()
    assert speeds == [float(v) for v in range(160, 351, 10)]
    assert SpeedRange(kind="range", start=160, stop=161, step=0.1).expand()[-3:] == [160.8, 160.9, 161.0]


def test_the_order_of_cases_is_fixed() -> None:
    irregularity = {"kind": "harmonic", "wavelength_m": [1, 2], "amplitude_mm": [0.1, 0.2]}
    sweep = ProductSweep.model_validate({"kind": "product", "speed_kmh": [300, 250], "irregularity": irregularity})
    found = [conditions(case.to_dict()) for case in sweep.expand(Model().parts())]
    assert [(each["speed_kmh"], each["wavelength_m"], each["amplitude_mm"]) for each in found] == [
        (speed, wavelength, amplitude) for speed in (300, 250) for wavelength in (1, 2) for amplitude in (0.1, 0.2)
    ]


@given(speed=decimals(100, 400, 6), amplitude=decimals(0, 20, 6), wavelength=decimals(1, 200))
def test_a_case_is_shown_as_it_was_written(speed: float, amplitude: float, wavelength: float) -> None:
    irregularity = {"kind": "harmonic", "wavelength_m": wavelength, "amplitude_mm": amplitude}
    case = CaseFile.model_validate({"speed_kmh": speed, "irregularity": irregularity}).to_case()
    shown = case_file(case.to_dict())
    assert (shown["speed_kmh"], shown["irregularity"]) == (speed, irregularity)
    assert CaseFile.model_validate(shown).to_case() == case


def test_a_spectrum_case_is_shown_as_it_was_written() -> None:
    irregularity = {
        "kind": "spectrum",
        "spectrum": "tb3352-ballastless",
        "percentile": 90.0,
        "wavelength_band_m": {"min": 2.0, "max": 30.0},
        "seed": 2**63 - 1,
        "realisation": 7,
    }
    given = {"speed_kmh": 300, "irregularity": irregularity, "track": {"pad_stiffness_n_per_m": 4e7}}
    case = CaseFile.model_validate(given).to_case()
    assert case.track.pad_stiffness == 4e7
    assert case_file(case.to_dict())["irregularity"] == irregularity
    assert CaseFile.model_validate(case_file(case.to_dict())).to_case().digest() == case.digest()


BAND = {"min": 2.0, "max": 12.0}
SAMPLE = {"kind": "spectrum", "percentile": 63.2, "wavelength_band_m": BAND, "seed": 1, "realisation": 0}
TABLE = {"kind": "table", "per": "rad/m", "sides": 2, "frequencies": [0.1, 5.0], "densities": [1e-6, 1e-9]}
RATIONAL = {"kind": "rational", "per": "rad/m", "sides": 1, "roughness": 4e-7, "cutoff": 0.8, "lower_cutoff": 0.02}
DIP = {"kind": "dip", "position_m": 20.0, "length_m": 1.5, "depth_mm": -0.3}
PROFILE = {
    "kind": "measured",
    "positions_m": [0.5 * n for n in range(40)],
    "heights_m": [1e-3 * (n % 7) for n in range(40)],
    "wavelength_band_m": BAND,
}
SHOWN = [
    {"kind": "none"},
    DIP,
    PROFILE,
    *(SAMPLE | {"spectrum": spectrum} for spectrum in ("german-high", OWN, TABLE, RATIONAL)),
    {"kind": "sum", "terms": [DIP, PROFILE, SAMPLE | {"spectrum": TABLE}]},
]


@pytest.mark.parametrize("irregularity", SHOWN, ids=lambda each: each["kind"])
def test_every_irregularity_is_shown_as_it_was_written(irregularity: dict[str, Any]) -> None:
    given = json.dumps({"speed_kmh": 300, "irregularity": irregularity})
    case = CaseFile.model_validate_json(given).to_case()
    stored = json.loads(json.dumps(case.to_dict()))
    assert case_file(stored)["irregularity"] == irregularity
    assert CaseFile.model_validate_json(json.dumps(case_file(stored))).to_case().digest() == case.digest()


def test_an_own_spectrum_is_filtered_by_its_kind() -> None:
    case = CaseFile.model_validate({"speed_kmh": 300, "irregularity": SAMPLE | {"spectrum": TABLE}}).to_case()
    assert conditions(case.to_dict())["spectrum"] == "table"


@pytest.mark.parametrize("irregularity", [PROFILE, {"kind": "sum", "terms": [DIP, PROFILE]}])
def test_measured_profiles_are_not_taken_over_http(irregularity: dict[str, Any]) -> None:
    with pytest.raises(ValidationError, match="does not match any of the expected tags"):
        ProductSweep.model_validate({"kind": "product", "speed_kmh": [300], "irregularity": irregularity})


def test_a_case_digests_alike_however_it_is_written() -> None:
    written = '{"speed_kmh": 300, "irregularity": {"kind": "none"}}', '{"irregularity":{"kind":"none"},"speed_kmh":3e2}'
    assert len({CaseFile.model_validate_json(text).to_case().digest() for text in written}) == 1


@pytest.mark.parametrize(
    ("model", "cls"), [(TrackOverrides, Track), (VehicleOverrides, Vehicle), (NumericsOverrides, Numerics)]
)
def test_every_field_of_the_solver_is_offered_with_its_bounds(model: Any, cls: type) -> None:
    offered = model.model_json_schema()["properties"]
    assert len(offered) == len(dataclasses.fields(cls)) + ("base" in offered)
    for _, name, quantity in quantities(cls):
        assert quantity.meaning[1:] in offered[name]["description"]
        keywords = {"ge": "minimum", "gt": "exclusiveMinimum", "le": "maximum", "lt": "exclusiveMaximum"}
        for bound, value in quantity.bounds().items():
            assert offered[name][keywords[bound]] == value


def test_parts_are_the_catalogue_s_with_what_was_overridden() -> None:
    given = {"track": {"base": "crts2", "pad_spacing_m": 0.6}, "vehicle": {"wheel_tread": "conical"}}
    parts = Model.model_validate(given).parts()
    assert parts["track"] == dataclasses.replace(TRACKS["crts2"].values, pad_spacing=0.6)
    assert parts["vehicle"] == dataclasses.replace(VEHICLES["crh3"].values, wheel_tread="conical")
    assert parts["numerics"] == Numerics()


def test_every_check_of_the_solver_points_into_the_study() -> None:
    assert pointer_to_parameter("vehicle.half_wheelbase_m") == "/vehicle/half_wheelbase_m"
    assert pointer_to_parameter("irregularity.wavelength_band_m") == "/sweep/irregularity/wavelength_band_m"
    assert pointer_to_parameter("slab") == "/sweep/slab"
    (speed,) = (outside for inside, outside, _ in quantities(Case) if inside == "speed")
    assert pointer_to_parameter(speed) == "/sweep/speed_kmh"


@given(st.text(), st.none() | st.text() | st.integers() | st.floats(allow_nan=False), st.integers() | st.text())
def test_cursors_carry_any_value(question: str, value: Any, key: Any) -> None:
    assert decode_cursor(encode_cursor(question, value, key), question) == (value, key)


@given(st.text())
def test_a_cursor_that_is_none_of_ours(text: str) -> None:
    with pytest.raises(Problem):
        decode_cursor(text, "question")


def test_a_cursor_answers_one_question() -> None:
    with pytest.raises(Problem, match="other filters"):
        decode_cursor(encode_cursor("peaks of A", 1, 1), "peaks of B")


KEYS = st.sampled_from(["kind", "speed_kmh", "irregularity", "spectrum", "start", "0"])
JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-3, 3) | st.sampled_from(["300", "range", "none", "spectrum", "harmonic"]),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(
            st.sampled_from(["kind", "speed_kmh", "irregularity", "spectrum", "start", "0"]), inner, max_size=4
        )
    ),
    max_leaves=12,
)


@given(JSON)
def test_every_error_points_at_something(body: Any) -> None:
    """Every pointer leads to a value of the body, or to a field that its object lacks."""
    try:
        ProductSweep.model_validate(body)
    except ValidationError as error:
        for each in error.errors():
            *parents, last = pointer_to(("body", *each["loc"]), body).split("/")[1:] or [None]
            node = body
            for part in parents:
                node = node[int(part) if isinstance(node, list) else part]
            assert last is None or isinstance(node, dict) or int(last) < len(node)
