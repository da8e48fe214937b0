"""Pure functions of the boundary: counting, expansion, conversion, cursors, pointers."""

import dataclasses
import json
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.cases.irregularities import no_profiles
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
from app.studies.presets import PRESETS
from app.studies.schemas import StudyRequest
from app.studies.sweep import ContradictionError, ProductSweep, SpeedRange, ZipSweep, located
from app.studies.sweep.axes import length
from app.studies.sweep.vary import PARAMETERS, varied
from solver.case import Case, Harmonic, Joint, Numerics, Track, Vehicle
from solver.catalogue import TRACKS, VEHICLES
from solver.quantity import InvalidParameterError, quantities


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
VARY = st.fixed_dictionaries(
    {},
    optional={
        "track.pad_stiffness_n_per_m": listed(decimals(1e7, 1e8, 0)),
        "track.joint.pads_per_slab": listed(st.integers(3, 20)),
        "numerics.window_s": listed(decimals(1, 5)),
    },
)
SWEEPS = st.fixed_dictionaries(
    {"kind": st.just("product"), "speed_kmh": SPEEDS, "irregularity": IRREGULARITIES, "vary": VARY}
)


def expanded(sweep: ProductSweep | ZipSweep) -> int:
    """How many cases a sweep expands to, those included that the solver would refuse."""
    names, rows = list(sweep.irregularity.axes()), list(sweep.rows())
    values = dict(zip(names, rows[0][len(rows[0]) - len(names) :], strict=True))
    return len(rows) * len(list(sweep.irregularity.chosen(values, no_profiles)))


@given(SWEEPS)
def test_a_product_counts_what_it_expands_to(sweep: dict[str, Any]) -> None:
    parsed = ProductSweep.model_validate(sweep)
    assert len(set(parsed.rows())) * parsed.irregularity.repeats == parsed.count() == expanded(parsed)


@given(SWEEPS)
def test_a_zip_counts_what_it_expands_to_or_names_the_odd_axis(sweep: dict[str, Any]) -> None:
    axes = ProductSweep.model_validate(sweep).axes()
    if len({length(axis) for axis in axes.values()} - {1}) < 2:
        parsed = ZipSweep.model_validate(sweep | {"kind": "zip"})
        assert parsed.count() == expanded(parsed)
        assert {len(row) for row in parsed.rows()} == {len(axes)}
    else:
        with pytest.raises(ValidationError) as refused:
            ZipSweep.model_validate(sweep | {"kind": "zip"})
        assert {each["type"] for each in refused.value.errors()} == {"length-differs"}
        assert {each["loc"] for each in refused.value.errors()} < set(axes)


@given(SWEEPS)
def test_a_sweep_survives_json(sweep: dict[str, Any]) -> None:
    parsed = ProductSweep.model_validate(sweep)
    assert ProductSweep.model_validate_json(parsed.model_dump_json(exclude_unset=True)) == parsed


WAVE = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}


def study(**sweep: Any) -> StudyRequest:
    whole = {"speed_kmh": [300], "irregularity": WAVE} | sweep
    return StudyRequest.model_validate({"name": "A study", "sweep": whole})


def refusal(**sweep: Any) -> list[tuple[str, str, str]]:
    """Pointer, code and message of what is wrong with a sweep."""
    body = {"name": "A study", "sweep": {"kind": "product", "speed_kmh": [300], "irregularity": WAVE} | sweep}
    with pytest.raises(ValidationError) as refused:
        StudyRequest.model_validate(body)
    found = refused.value.errors()
    return [(pointer_to(("body", *each["loc"]), body), each["type"], each["msg"]) for each in found]


def test_what_is_varied_multiplies_in_a_product() -> None:
    vary = {"track.joint.shear_stiffness_n_per_m": [0, 1e8], "track.pad_stiffness_n_per_m": [4e7, 6e7, 8e7]}
    request = study(kind="product", slab=["discontinuous"], speed_kmh=[250, 300], vary=vary)
    cases = request.expand()
    assert len({case.digest() for case in cases}) == len(cases) == request.count() == 12
    # The last axis varies fastest, and the order of parameters is that of the model, however they were written.
    assert [case.track.pad_stiffness for case in cases[:6]] == [4e7] * 4 + [6e7] * 2
    assert [case.track.joint.shear_stiffness for case in cases[:4]] == [0, 0, 1e8, 1e8]
    assert [round(case.speed * 3.6) for case in cases[:2]] == [250, 300]


def test_axes_of_a_zip_are_walked_together_and_single_values_stay() -> None:
    vary = {"track.pad_stiffness_n_per_m": [4e7, 6e7, 8e7], "vehicle.wheelset_mass_kg": [2000]}
    irregularity = {"kind": "harmonic", "wavelength_m": [1.0, 2.0, 1.0], "amplitude_mm": [0.3]}
    request = study(kind="zip", speed_kmh=[300, 300, 200], irregularity=irregularity, vary=vary)
    found = [
        (round(case.speed * 3.6), case.track.pad_stiffness, case.vehicle.wheelset_mass, case.irregularity.wavelength)
        for case in request.expand()
        if isinstance(case.irregularity, Harmonic)
    ]
    assert found == [(300, 4e7, 2000, 1.0), (300, 6e7, 2000, 2.0), (200, 8e7, 2000, 1.0)]


def test_realisations_of_a_zip_belong_to_every_row() -> None:
    spectrum = {"kind": "spectrum", "percentile": [25, 90], "wavelength_band_m": [BAND], "realisations": 3}
    request = study(kind="zip", speed_kmh=[300, 350], irregularity=spectrum)
    cases = request.expand()
    assert len(cases) == request.count() == 6
    found = [conditions(case.to_dict()) for case in cases]
    assert [(each["speed_kmh"], each["percentile"], each["realisation"]) for each in found] == [
        (speed, percentile, n) for speed, percentile in ((300, 25), (350, 90)) for n in range(3)
    ]


def test_the_odd_axis_of_a_zip_is_named() -> None:
    vary = {"track.pad_stiffness_n_per_m": [4e7, 6e7], "vehicle.wheelset_mass_kg": [2000, 2400, 2800]}
    ((pointer, code, message),) = refusal(kind="zip", speed_kmh=[250, 300], vary=vary)
    assert (pointer, code) == ("/sweep/vary/vehicle.wheelset_mass_kg", "length-differs")
    assert "3 values, where vary.track.pad_stiffness_n_per_m has 2" in message
    spectrum = {"kind": "spectrum", "percentile": [25, 63.2, 90], "wavelength_band_m": [BAND]}
    assert refusal(kind="zip", speed_kmh=[250, 300], irregularity=spectrum)[0][0] == "/sweep/irregularity/percentile"


@pytest.mark.parametrize(
    ("vary", "pointer", "words"),
    [
        (
            {"track.pad_stifness_n_per_m": [4e7]},
            "track.pad_stifness_n_per_m",
            "nearest are track.pad_stiffness_n_per_m",
        ),
        ({"shear_stiffness": [1]}, "shear_stiffness", "track.joint.shear_stiffness_n_per_m"),
        ({"zzz": [4e7]}, "zzz", "get_limits"),
        ({"vehicle.wheel_tread": ["worn"]}, "vehicle.wheel_tread", "no such parameter"),
        ({"track.pad_stiffness_n_per_m": [4e7, 1e13]}, "track.pad_stiffness_n_per_m/1", "1000000000000"),
        ({"track.pad_stiffness_n_per_m": [4e7, "6e7"]}, "track.pad_stiffness_n_per_m/1", "number"),
        ({"numerics.elements_per_pad": [12, 12.5]}, "numerics.elements_per_pad/1", "integer"),
        ({"track.pad_stiffness_n_per_m": []}, "track.pad_stiffness_n_per_m", "at least 1"),
        ({"track.pad_stiffness_n_per_m": [4e7, 4e7]}, "track.pad_stiffness_n_per_m", "listed twice"),
        ({"track.pad_stiffness_n_per_m": None}, "track.pad_stiffness_n_per_m", "list"),
    ],
)
def test_what_cannot_be_varied_is_named(vary: dict[str, Any], pointer: str, words: str) -> None:
    ((found, _, message),) = refusal(vary=vary)
    assert found == f"/sweep/vary/{pointer}"
    assert words in message


def test_values_that_do_not_go_together_are_named_where_they_are_varied() -> None:
    with pytest.raises(ContradictionError, match="half_bogie_distance") as refused:
        study(
            kind="product", vary={"vehicle.half_wheelbase_m": [1.0, 2.0], "vehicle.half_bogie_distance_m": [1.5]}
        ).expand()
    assert refused.value.pointer == "/sweep/vary/vehicle.half_wheelbase_m"
    # Both together are fine, though neither is with what the other had before.
    vary = {"vehicle.half_wheelbase_m": [1.2], "vehicle.half_bogie_distance_m": [1.25]}
    assert len(study(kind="product", vary=vary).expand()) == 1


CASES = [
    {"speed_kmh": 300, "irregularity": {"kind": "none"}},
    {
        "speed_kmh": 250,
        "slab": "discontinuous",
        "irregularity": {"kind": "harmonic", "wavelength_m": 1.0, "amplitude_mm": 0.3},
        "vary": {"track.joint.shear_stiffness_n_per_m": 0, "numerics.window_s": 5.0},
    },
]


def listing(*cases: dict[str, Any]) -> StudyRequest:
    return StudyRequest.model_validate({"name": "A list", "sweep": {"kind": "list", "cases": list(cases)}})


def test_cases_may_be_listed_one_by_one() -> None:
    request = listing(*CASES)
    plain, other = request.expand()
    assert request.count() == 2
    assert plain == CaseFile.model_validate(CASES[0]).to_case()
    own = {"track": {"joint": {"shear_stiffness_n_per_m": 0}}, "numerics": {"window_s": 5.0}}
    assert other == CaseFile.model_validate({k: v for k, v in CASES[1].items() if k != "vary"} | own).to_case()


def test_what_is_wrong_with_a_listed_case_is_named_by_its_place() -> None:
    wave = {"kind": "sum", "terms": [{"kind": "spectrum", "wavelength_band_m": {"min": 30, "max": 2}}]}
    for change, pointer in (
        ({"irregularity": wave}, "irregularity/terms/0/wavelength_band_m"),
        ({"vary": {"numerics.elements_per_pad": 2}}, "vary/numerics.elements_per_pad"),
    ):
        with pytest.raises(ContradictionError) as refused:
            listing(CASES[0], CASES[1] | change).expand()
        assert refused.value.pointer == f"/sweep/cases/1/{pointer}"


@pytest.mark.parametrize("name", PRESETS)
def test_presets_are_studies(name: str) -> None:
    short = StudyRequest.model_validate({"name": "By name", "sweep": name})
    whole = StudyRequest.model_validate(PRESETS[name].study)
    assert short.expand() == whole.expand()
    assert short.count() == whole.count() == len({case.digest() for case in whole.expand()})


def test_presets_of_the_article_are_the_article_s() -> None:
    def cases(name: str) -> list[Case]:
        return StudyRequest.model_validate({"name": "The article", "sweep": f"article-{name}"}).expand()

    for slab in ("continuous", "discontinuous"):
        found = cases(f"speed-{slab}")
        assert [round(case.speed * 3.6) for case in found] == [160, 200, 250, 300, 350]
        assert {(case.slab, case.numerics.window) for case in found} == {(slab, 3.0)}
        assert {case.irregularity for case in found} == {Harmonic(wavelength=1.0, amplitude=3e-4)}
    random = [*cases("percentiles"), *cases("wavelength-bands")]
    found = [conditions(case.to_dict()) for case in random]
    assert [each["percentile"] for each in found] == [25, 63.2, 90, *[63.2] * 5]
    assert [each["wavelength_min_m"] for each in found] == [2, 2, 2, 2, 2.5, 3, 3.5, 4]
    assert {(each["wavelength_max_m"], each["spectrum"]) for each in found} == {(30, "tb3352-ballastless")}
    assert {(round(case.speed * 3.6), case.slab, case.numerics.window) for case in random} == {
        (350, "discontinuous", 5)
    }
    assert {(case.numerics.track_length, case.numerics.elements_per_pad) for case in random} == {(140, 12)}


def test_a_preset_yields_to_what_the_study_says_itself() -> None:
    body = {
        "name": "Softer",
        "sweep": "joint-stiffness",
        "track": {"base": "crts2-soft"},
        "numerics": {"settle_s": 2.0},
    }
    cases = StudyRequest.model_validate(body).expand()
    assert {case.track.mortar_stiffness for case in cases} == {4.5e8}
    assert {(case.numerics.settle, case.numerics.window) for case in cases} == {(2.0, 3.0)}


def test_every_number_of_the_model_can_be_varied() -> None:
    parts = Model().parts()
    for path, parameter in PARAMETERS.items():
        part, *between, name = parameter.inside
        value = parts[part]
        for each in (*between, name):
            value = getattr(value, each)
        assert varied(parts, {path: value}) == parts
        changed = varied(parts, {path: type(value)(value * 0.95 if isinstance(value, float) else value + 1)})
        assert [other for other in parts if parts[other] != changed[other]] in ([part], [] if value == 0 else [part])
    numbers = [path for path in PARAMETERS if path.startswith("track.joint.")]
    assert len(numbers) == len(dataclasses.fields(Joint))


def test_a_range_includes_its_stop() -> None:
    speeds = SpeedRange(kind="range", start=160, stop=350, step=10).expand()
    assert speeds == [float(v) for v in range(160, 351, 10)]
    assert SpeedRange(kind="range", start=160, stop=161, step=0.1).expand()[-3:] == [160.8, 160.9, 161.0]


def test_the_order_of_cases_is_fixed() -> None:
    irregularity = {"kind": "harmonic", "wavelength_m": [1, 2], "amplitude_mm": [0.1, 0.2]}
    sweep = ProductSweep.model_validate({"kind": "product", "speed_kmh": [300, 250], "irregularity": irregularity})
    found = [conditions(case.to_dict()) for case in sweep.expand(Model().parts(), no_profiles)]
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
def test_samples_of_profiles_are_not_taken_over_http(irregularity: dict[str, Any]) -> None:
    with pytest.raises(ValidationError, match="profile_id"):
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
    (speed,) = (outside for inside, outside, _ in quantities(Case) if inside == "speed")
    for parameter, pointer in {
        "vehicle.half_wheelbase_m": "/vehicle/half_wheelbase_m",
        "irregularity.wavelength_band_m": "/sweep/irregularity/wavelength_band_m",
        "slab": "/sweep/slab",
        speed: "/sweep/speed_kmh",
        "track.pad_spacing_m": "/sweep/vary/track.pad_spacing_m",
    }.items():
        with pytest.raises(ContradictionError) as refused, located("/sweep", ["track.pad_spacing_m"]):
            raise InvalidParameterError(parameter, "is wrong")
        assert refused.value.pointer == pointer


@given(st.text(), st.lists(st.none() | st.text() | st.integers() | st.floats(allow_nan=False)))
def test_cursors_carry_any_values(question: str, values: list[Any]) -> None:
    assert decode_cursor(encode_cursor(question, values), question) == values


@given(st.text())
def test_a_cursor_that_is_none_of_ours(text: str) -> None:
    with pytest.raises(Problem):
        decode_cursor(text, "question")


def test_a_cursor_answers_one_question() -> None:
    with pytest.raises(Problem, match="other filters"):
        decode_cursor(encode_cursor("peaks of A", [1, 1]), "peaks of B")


KEYS = ["kind", "speed_kmh", "irregularity", "spectrum", "start", "vary", "cases", "track.pad_stiffness_n_per_m", "0"]
WORDS = ["300", "range", "none", "spectrum", "harmonic", "measured", "product", "zip", "list", "joint-stiffness"]
JSON = st.recursive(
    st.none() | st.booleans() | st.integers(-3, 3) | st.sampled_from(WORDS),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from(KEYS), inner, max_size=4),
    max_leaves=12,
)


@given(JSON)
def test_every_error_points_at_something(sweep: Any) -> None:
    """Every pointer leads to a value of the body, or to a field that its object lacks."""
    body = {"name": "Anything", "sweep": sweep}
    try:
        StudyRequest.model_validate(body)
    except ValidationError as error:
        for each in error.errors():
            *parents, last = pointer_to(("body", *each["loc"]), body).split("/")[1:] or [None]
            node: Any = body
            for part in parents:
                node = node[int(part) if isinstance(node, list) else part]
            assert last is None or isinstance(node, dict) or int(last) < len(node)
