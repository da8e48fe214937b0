"""Time histories: drawn without losing a peak, and downloaded whole, in parts or not at all."""

import hashlib
import io
import json
from collections.abc import Callable
from typing import Any

import httpx
import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy import signal

from app.cases.schemas import CaseFile
from app.db.session import Database
from app.histories.sampling import peaks_of_bins
from app.settings import Settings
from app.storage import HistoryStore
from solver.channels import CHANNELS
from solver.simulate import Response
from tests.outcomes import succeed
from worker.claim import claim
from worker.history import archive

SAMPLES, STEP_S, HIGHEST = 20_000, 1e-4, 12_345
KEY = "a/history.npz"

Check = Callable[..., dict[str, Any]]


@given(arrays.arrays(np.float32, st.integers(1, 200), elements=st.floats(-1e3, 1e3, width=32)), st.integers(2, 50))
def test_no_peak_is_lost(values: Any, max_points: int) -> None:
    shown = peaks_of_bins(values, max_points)
    assert len(shown) <= max_points
    assert (np.diff(shown) > 0).all()
    if len(values) <= max_points:
        assert len(shown) == len(values)
    stretch = -(-len(values) // (max_points // 2))
    for first in range(0, len(values), stretch):  # in every stretch, so also in all
        inside, every = values[shown[shown // stretch == first // stretch]], values[first : first + stretch]
        assert (inside.min(), inside.max()) == (every.min(), every.max())


@pytest.fixture(scope="module")
def content() -> bytes:
    """What a worker would store: noise, with one sample that stands out in every channel."""
    time, noise = np.arange(SAMPLES) * STEP_S, np.random.default_rng(1).integers(-9, 9, SAMPLES)
    noise[HIGHEST] = 1000
    values = noise * np.arange(1.0, len(CHANNELS) + 1)[:, None]
    case = CaseFile.model_validate({"speed_kmh": 250, "irregularity": {"kind": "none"}}).to_case()
    return archive(
        Response(
            case=case,
            time=time,
            track_position=100 + case.speed * time,
            channels=CHANNELS,
            values=values,
            time_step=STEP_S,
        )
    )


@pytest.fixture
def histories(settings: Settings) -> HistoryStore:
    return HistoryStore(settings.resolved_storage_url)


@pytest.fixture
def path(
    client: httpx.Client, database: Database, study: dict[str, Any], histories: HistoryStore, content: bytes
) -> str:
    """Of a case with a history."""
    client.post("/v1/studies", json=study | {"keep_history": True})
    histories.put(KEY, content)
    stored = {"key": KEY, "digest": hashlib.sha256(content).hexdigest(), "size_bytes": len(content)}
    with database.write() as session:
        (held,) = claim(session, "test", 15.0, lanes=1)
        assert succeed(session, held, peaks=[], processing={}, history=stored, cpu_s=1.0)
    return f"/v1/cases/{held.case_id}/history"


def test_all_channels_are_drawn(client: httpx.Client, path: str) -> None:
    history = client.get(path).json()
    assert (history["samples"], history["speed_kmh"], history["track_position_start_m"]) == (SAMPLES, 250, 100)
    assert [(c["quantity"], c["position"], c["unit"]) for c in history["channels"]] == [
        (channel.quantity, channel.position, channel.unit) for channel in CHANNELS
    ]
    for n, channel in enumerate(history["channels"], start=1):
        assert len(channel["values"]) == len(channel["time_s"]) <= 1000
        assert max(channel["values"]) == 1000 * n
        assert channel["time_s"][np.argmax(channel["values"])] == pytest.approx(HIGHEST * STEP_S)


def test_a_part_is_drawn_in_full(client: httpx.Client, path: str) -> None:
    query = {"quantity": ["wheel_rail_force", "pad_force"], "position": ["wheelset_2", "pads"]}
    part = client.get(path, params=query | {"time_min_s": 0.1, "time_max_s": 0.2, "max_points": 10_000}).json()
    assert [(c["quantity"], c["position"]) for c in part["channels"]] == [
        ("wheel_rail_force", "wheelset_2"),
        ("pad_force", "pads"),
    ]
    assert part["samples"] == 1001  # both ends
    for channel in part["channels"]:
        np.testing.assert_array_equal(channel["time_s"], (np.arange(1000, 2001) * STEP_S).astype(np.float32))
    assert client.get(path, params={"time_min_s": 1.5, "time_max_s": 1}).json()["samples"] == 0
    assert client.get(path, params={"quantity": "noise"}).json()["channels"] == []


def test_what_is_known_is_not_sent_again(client: httpx.Client, path: str) -> None:
    for url in (path, f"{path}?max_points=10", f"{path}.npz", f"{path}.parquet", path.removesuffix("/history")):
        first = client.get(url)
        assert first.status_code == 200
        again = client.get(url, headers={"If-None-Match": first.headers["etag"]})
        assert (again.status_code, again.content) == (304, b"")
        head = client.head(url)
        assert (head.status_code, head.content) == (200, b"")
        assert head.headers["etag"] == first.headers["etag"]
        assert head.headers["content-length"] == first.headers["content-length"]
    assert client.get(path).headers["etag"] != client.get(path, params={"max_points": 10}).headers["etag"]


def test_downloads_hold_everything(client: httpx.Client, path: str, content: bytes) -> None:
    assert client.get(f"{path}.npz").content == content
    parquet = client.get(f"{path}.parquet")
    assert parquet.headers["content-type"] == "application/vnd.apache.parquet"
    assert parquet.headers["content-disposition"].startswith('attachment; filename="case-')
    table = pq.read_table(io.BytesIO(parquet.content))
    frame = pd.read_parquet(io.BytesIO(parquet.content))
    with np.load(io.BytesIO(content)) as npz:
        np.testing.assert_array_equal(frame["time_s"], npz["time_s"])
        np.testing.assert_array_equal(frame["track_position_m"], npz["track_position_m"])
        np.testing.assert_array_equal(frame.iloc[:, 2:].T, npz["values"])
    field = table.schema.field("wheel_rail_force:wheelset_3")
    assert field.metadata == {b"quantity": b"wheel_rail_force", b"position": b"wheelset_3", b"unit": b"N"}
    case = client.get(path.removesuffix("/history")).json()
    origin = {key.decode(): value.decode() for key, value in table.schema.metadata.items()}
    assert (origin["case_digest"], origin["solver_version"]) == (case["digest"], case["solver_version"])
    assert json.loads(origin["inputs"]) == case["inputs"]
    assert json.loads(origin["processing"])["samples"] == SAMPLES


@pytest.mark.parametrize("suffix", ["npz", "parquet"])
def test_parts_of_a_download(client: httpx.Client, path: str, problem: Check, suffix: str) -> None:
    url = f"{path}.{suffix}"
    whole = client.get(url)
    size = len(whole.content)
    for asked, part in {"10-19": slice(10, 20), f"{size - 5}-": slice(-5, None), "-7": slice(-7, None)}.items():
        response = client.get(url, headers={"Range": f"bytes={asked}", "If-Range": whole.headers["etag"]})
        assert (response.status_code, response.content) == (206, whole.content[part])
        first, last, _ = slice(*part.indices(size)).indices(size)
        assert response.headers["content-range"] == f"bytes {first}-{last - 1}/{size}"
    problem(client.get(url, headers={"Range": f"bytes={size}-"}), 416, "range-not-satisfiable")
    for headers in (
        {"Range": "bytes=0-1,4-5"},
        {"Range": "bytes=-"},
        {"Range": "bytes=9-3"},
        {"Range": "lines=1-2"},
        {"Range": "bytes=0-1", "If-Range": '"another"'},
    ):
        assert client.get(url, headers=headers).content == whole.content


def test_a_store_that_lost_a_history(
    client: httpx.Client, path: str, histories: HistoryStore, content: bytes, problem: Check
) -> None:
    histories.put(KEY, content[:-1])
    for url in (path, f"{path}.parquet"):
        problem(client.get(url), 503, "history-damaged")
    histories.delete(KEY)
    for url in (path, f"{path}.parquet", f"{path}.npz"):
        problem(client.get(url), 503, "unavailable")


def test_a_case_without_history(client: httpx.Client, study: dict[str, Any], problem: Check) -> None:
    client.post("/v1/studies", json=study)
    for suffix in ("", ".npz", ".parquet"):
        problem(client.get(f"/v1/cases/1/history{suffix}"), 404, "history-not-kept")
        problem(client.get(f"/v1/cases/99/history{suffix}"), 404, "not-found")


def test_head_wherever_there_is_get(client: httpx.Client) -> None:
    for path in ("/healthz", "/v1/studies", "/v1/peaks"):
        response = client.head(path)
        assert (response.status_code, response.content) == (200, b"")
    assert client.head("/v1/nothing").status_code == 404


def test_a_spectrum_tells_what_rings(client: httpx.Client, path: str, content: bytes, problem: Check) -> None:
    url = path.removesuffix("history") + "spectrum"
    asked = {"quantity": "wheel_rail_force", "position": "wheelset_2"}
    found = client.get(url, params=asked | {"resolution_hz": 5, "frequency_max_hz": 2000}).json()
    assert (found["unit"], found["density_unit"], found["segments"]) == ("N", "N^2/Hz", 19)
    assert found["frequency_hz"] == pytest.approx([5.0 * n for n in range(1, 401)])
    with np.load(io.BytesIO(content)) as npz:
        _, density = signal.welch(npz["values"][1].astype(float), 1 / STEP_S, nperseg=2000)
    np.testing.assert_allclose(found["density"], density[1:401])
    assert found["pad_passing_hz"] == pytest.approx(250 / 3.6 / 0.65, rel=0.05)
    assert 20 < found["p2_hz"] < 160
    first = client.get(url, params=asked)
    again = client.get(url, params=asked, headers={"If-None-Match": first.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    problem(client.get(url, params=asked | {"position": "nowhere"}), 404, "no-such-channel")
    problem(client.get(url), 422, "invalid")
    problem(client.get("/v1/cases/99/spectrum", params=asked), 404, "not-found")
