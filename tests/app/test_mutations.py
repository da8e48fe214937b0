"""Whatever is sent as a study or a profile is answered, without a fault, in bounded time and memory.

Valid bodies are spoilt in many ways, and sent to the application in this process. A few hundred are part of the
ordinary tests, ``pytest -m slow`` sends a hundred thousand of each.
"""

import asyncio
import json
import resource
import time
from collections.abc import Callable, Iterator
from copy import deepcopy
from typing import Any

import httpx
import hypothesis
import pytest
from hypothesis import HealthCheck, Phase, given
from hypothesis import strategies as st

import migrations
from app.examples import PROFILE, STUDY
from app.main import create_app
from app.settings import Settings
from app.studies.presets import PRESETS

CPU_S, MEMORY_MB = 10.0, 600  # far above what any of these takes, and far below what would be felt
ROUND = 1000  # examples that Hypothesis has in memory

Post = Callable[[str, str, bytes], httpx.Response]


@pytest.fixture(scope="module")
def post(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Post]:
    """Sends a body to the application and judges the answer."""
    folder = tmp_path_factory.mktemp("mutations")
    broker_url = f"redis+socket://{folder}/nobody"
    settings = Settings(data_dir=folder, broker_url=broker_url, max_cases_per_study=30, writes_per_minute=0)
    migrations.upgrade(settings.resolved_database_url)
    application = create_app(settings)
    transport = httpx.ASGITransport(application)
    with asyncio.Runner() as runner:
        client = httpx.AsyncClient(transport=transport, base_url="http://localhost", timeout=None)

        def send(path: str, media_type: str, body: bytes) -> httpx.Response:
            began = time.process_time()
            answer = runner.run(client.post(path, content=body, headers={"Content-Type": media_type}))
            assert time.process_time() - began < CPU_S
            assert answer.status_code in (200, 201, 400, 413, 422), (answer.status_code, answer.text)
            if answer.is_error:
                problem = answer.json()
                assert problem["code"], problem
                assert len(problem["errors"]) <= 100
            return answer

        yield send
        runner.run(client.aclose())
    application.state.context.database.close()


@pytest.fixture(autouse=True)
def bounded_memory() -> Iterator[None]:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    yield
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024 < MEMORY_MB


# --- studies

PRODUCT = {"kind": "product", "speed_kmh": [250, 300], "slab": ["continuous"]}
TABLE = {"kind": "table", "per": "1/m", "sides": 1, "frequencies": [0.01, 1], "densities": [1e-6, 1e-9]}
BAND = {"min": 2, "max": 30}
MASS = {"vehicle.bogie_mass_kg": [3e3, 4e3]}
TERMS = [{"kind": "dip", "position_m": 20, "length_m": 1, "depth_mm": 0.3}]
IRREGULARITIES: list[dict[str, Any]] = [
    {"kind": "none"},
    {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.1, 0.3]},
    {
        "kind": "spectrum",
        "percentile": [25],
        "wavelength_band_m": [{"min": 2, "max": 30}],
        "realisations": 2,
        "seed": 1,
    },
    {"kind": "spectrum", "spectrum": TABLE, "wavelength_band_m": [{"min": 2, "max": 30}]},
    {"kind": "measured", "profile_id": "0" * 64},
    {"kind": "sum", "terms": TERMS},
]
CASE = {"speed_kmh": 300, "irregularity": {"kind": "none"}, "vary": {"track.pad_stiffness_n_per_m": 4e7}}
SPEEDS = {"kind": "range", "start": 200, "stop": 300, "step": 20}
VALID: list[dict[str, Any]] = [
    STUDY,
    *({"name": "study", "sweep": PRODUCT | {"irregularity": each}} for each in IRREGULARITIES),
    *(preset.study for preset in PRESETS.values()),
    *({"name": "study", "sweep": name} for name in PRESETS),
    {"name": "study", "sweep": {"kind": "list", "cases": [CASE, CASE | {"speed_kmh": 200}]}},
    {"name": "study", "sweep": PRODUCT | {"kind": "zip", "irregularity": IRREGULARITIES[1]}, "labels": {"a": "b"}},
    {
        "name": "study",
        "priority": -5,
        "sweep": PRODUCT
        | {"speed_kmh": SPEEDS, "irregularity": {"kind": "none"}, "vary": {"vehicle.bogie_mass_kg": [3e3]}},
        "track": {"base": "crts2", "joint": {"shear_stiffness_n_per_m": 1e8}},
        "vehicle": {"wheel_tread": "worn"},
        "numerics": {"window_s": 3, "elements_per_pad": 8},
    },
]

numbers = st.one_of(
    st.integers(),
    st.floats(),
    st.sampled_from([0, -0.0, 1e308, 5e-324, 2**31, 2**63, 2**64, 10**400, 1e-300, 0.1 + 0.2, 1e16]),
)
texts = st.one_of(
    st.text(max_size=20),
    st.sampled_from(["", "\0", "\ud800", "NaN", "1", "true", "../etc", "a" * 5000, "' OR 1=1 --", "kind", "product"]),
)
scalars = st.one_of(st.none(), st.booleans(), numbers, texts)
documents = st.recursive(
    scalars, lambda inner: st.lists(inner, max_size=4) | st.dictionaries(texts, inner, max_size=4), max_leaves=8
)
deep = st.integers(1, 150).map(lambda depth: json.loads("[" * depth + "]" * depth))  # more of it in the bytes


def places(node: Any) -> list[tuple[Any, Any]]:
    """Every container with every key or index in it."""
    keys = list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else []
    return [place for key in keys for place in [(node, key), *places(node[key])]]


@st.composite
def spoilt_documents(draw: st.DrawFn) -> bytes:
    """A study of which some places hold something else."""
    document = deepcopy(draw(st.sampled_from(VALID)))
    for _ in range(draw(st.integers(0, 3))):
        container, key = draw(st.sampled_from(places(document) or [(document, "sweep")]))
        match draw(st.sampled_from(["replace", "delete", "repeat", "add", "move", "deep"])):
            case "replace":
                container[key] = draw(documents)
            case "delete":
                container.pop(key)
            case "repeat" if isinstance(container, list):
                container.extend([container[key]] * draw(st.integers(1, 2000)))
            case "add" if isinstance(container, dict):
                container[draw(texts)] = draw(documents)
            case "move":
                other, place = draw(st.sampled_from(places(document)))
                container[key] = deepcopy(other[place])
            case _:
                container[key] = draw(deep)
        if not places(document):
            break
    return json.dumps(document).encode()


@st.composite
def spoilt_bytes(draw: st.DrawFn, bodies: st.SearchStrategy[bytes]) -> bytes:
    """A body of which some bytes are others."""
    body = bytearray(draw(bodies))
    for _ in range(draw(st.integers(1, 4))):
        at = draw(st.integers(0, len(body)))
        match draw(st.sampled_from(["insert", "overwrite", "cut", "double"])):
            case "insert":
                body[at:at] = draw(st.binary(max_size=8) | st.sampled_from([b"[" * 500, b"\xef\xbb\xbf", b"9" * 400]))
            case "overwrite":
                body[at : at + 4] = draw(st.binary(max_size=4))
            case "cut":
                del body[at : at + draw(st.integers(1, 200))]
            case _:
                body[at:at] = body[at : at + 200]
    return bytes(body)


studies = spoilt_documents() | spoilt_bytes(spoilt_documents()) | documents.map(lambda each: json.dumps(each).encode())


# --- profiles

cells = st.one_of(
    st.floats(-1, 1).map(repr),
    st.floats().map(repr),
    st.integers().map(str),
    st.sampled_from(
        ["", "x_m", "eta_mm", "1e", "1_0", "٣", "0x1", "inf", "nan", "-", "1" * 400, "1e-999", "x µm", " "]
    ),
    st.text(max_size=6),
)
separators = st.sampled_from([",", ";", "\t", " ", " , ", "", ",,", "\xa0"])
line_ends = st.sampled_from(["\n", "\r\n", "\r", "\n\n", "\u2028", "\x0b", ""])


@st.composite
def spoilt_lines(draw: st.DrawFn) -> bytes:
    """A profile of which some lines are others."""
    lines = PROFILE.splitlines()[: draw(st.just(None) | st.integers(0, 40))]
    for _ in range(draw(st.integers(0, 3))):
        at = draw(st.integers(0, len(lines)))
        line = draw(separators).join(draw(st.lists(cells, max_size=4)))
        lines[at : at + draw(st.integers(0, 1))] = [line] * draw(st.sampled_from([1, 2, 300]))
    end = draw(line_ends)
    return end.join(lines).encode(draw(st.sampled_from(["utf-8", "utf-8-sig", "utf-16"])), "surrogatepass")


@st.composite
def well_formed(draw: st.DrawFn) -> bytes:
    """A profile in one of the ways in which it may be written."""
    cells_apart = PROFILE.replace(",", draw(st.sampled_from([",", ";", "\t", ", "])))
    line_end = draw(st.sampled_from(["\n", "\r\n"]))
    return cells_apart.replace("\n", line_end).encode(draw(st.sampled_from(["utf-8", "utf-8-sig"])))


profiles = spoilt_lines() | spoilt_bytes(spoilt_lines() | well_formed()) | st.binary(max_size=200)


# --- the tests


def send_many(examples: int, bodies: st.SearchStrategy[bytes], send: Callable[[bytes], httpx.Response]) -> None:
    """Send that many bodies, and see that some are taken and some are not."""
    outcomes: dict[bool, int] = {True: 0, False: 0}

    def check(body: bytes) -> None:
        outcomes[send(body).is_success] += 1

    for n in range(0, examples, ROUND):
        chosen = hypothesis.settings(
            max_examples=min(ROUND, examples - n),
            database=None,
            phases=[Phase.generate, Phase.shrink] if examples <= ROUND else [Phase.generate],
            suppress_health_check=list(HealthCheck),
        )
        hypothesis.seed(n)(chosen(given(bodies)(check)))()
    assert sum(outcomes.values()) >= examples
    assert min(outcomes.values()) > examples / 100, outcomes


MANY = [300, pytest.param(100_000, marks=[pytest.mark.slow, pytest.mark.timeout(3600)])]


@pytest.mark.parametrize("examples", MANY)
def test_any_study_is_answered(examples: int, post: Post) -> None:
    send_many(examples, studies, lambda body: post("/v1/study-estimates", "application/json", body))


@pytest.mark.parametrize("examples", MANY)
def test_any_profile_is_answered(examples: int, post: Post) -> None:
    send_many(examples, profiles, lambda body: post("/v1/profiles", "text/csv", body))


def filled(make: Callable[[int], Any]) -> bytes:
    """A document as large as a body may be."""
    count = 1000 * 990_000 // len(json.dumps(make(1000)))
    return json.dumps(make(count)).encode()[:1_000_000]


def sweep(**axes: Any) -> dict[str, Any]:
    return {"name": "study", "sweep": PRODUCT | {"irregularity": {"kind": "none"}} | axes}


LARGE: dict[str, Callable[[], bytes]] = {
    "brackets": lambda: b"[" * 1_000_000,
    "braces": lambda: b'{"a":' * 200_000,
    "a name": lambda: filled(lambda n: sweep() | {"name": "a" * n}),
    "speeds": lambda: filled(lambda n: sweep(speed_kmh=[100 + i / 1e4 for i in range(n)])),
    "wrong speeds": lambda: filled(lambda n: sweep(speed_kmh=["a"] * n)),
    "huge numbers": lambda: filled(lambda n: sweep(speed_kmh=[10**300] * (n // 300))),
    "unknown fields": lambda: filled(lambda n: sweep() | {f"f{i}": 1 for i in range(n)}),
    "unknown parameters": lambda: filled(lambda n: sweep(vary={f"track.pad_{i}": [1] for i in range(n)})),
    "labels": lambda: filled(lambda n: sweep() | {"labels": {f"l\n{i}": 1 for i in range(n)}}),
    "empty cases": lambda: filled(lambda n: {"name": "study", "sweep": {"kind": "list", "cases": [{}] * n}}),
    "wrong cases": lambda: filled(
        lambda n: {"name": "study", "sweep": {"kind": "list", "cases": [CASE | {"vary": {"track.pads": 1}}] * n}}
    ),
    "terms": lambda: filled(lambda n: sweep(irregularity={"kind": "sum", "terms": [{}] * n})),
    "bands": lambda: filled(lambda n: sweep(irregularity=IRREGULARITIES[2] | {"wavelength_band_m": [{}] * n})),
    "a table": lambda: filled(
        lambda n: sweep(irregularity=IRREGULARITIES[3] | {"spectrum": TABLE | {"frequencies": ["x"] * n}})
    ),
}


@pytest.mark.parametrize("name", LARGE)
def test_a_large_study_is_answered_soon(name: str, post: Post) -> None:
    """These took up to half a minute of processor time once."""
    assert post("/v1/study-estimates", "application/json", LARGE[name]()).is_error


MEGABYTE = 1_000_000
LARGE_PROFILES: dict[str, Callable[[], bytes]] = {
    "empty lines": lambda: b"\n" * 10 * MEGABYTE,
    "remarks": lambda: b"#\n" * 5 * MEGABYTE,
    "short lines": lambda: b"1,1\n" * 2 * MEGABYTE,
    "old line ends": lambda: b"\r" * 10 * MEGABYTE,
    "separators": lambda: b"\t," * 5 * MEGABYTE,
    "a header": lambda: b"x_m " * 2 * MEGABYTE,
    "digits": lambda: b"1" * 5 * MEGABYTE + b"," + b"1" * 4 * MEGABYTE,
    "blanks": lambda: b"1" + b" " * 9 * MEGABYTE + b"1",
    "points": lambda: b"".join(b"%d,0\n" % n for n in range(900_000)),
}


@pytest.mark.parametrize("name", LARGE_PROFILES)
def test_a_large_profile_is_answered_soon(name: str, post: Post) -> None:
    assert post("/v1/profiles", "text/csv", LARGE_PROFILES[name]()).status_code == 422
