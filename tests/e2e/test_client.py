"""The client against a service that computes."""

import asyncio
import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pandas as pd
import pytest

from tests.e2e.conftest import Served, clean_environment, study
from tracksweep_client import ProblemError, Service, connect
from tracksweep_client.generated.api.catalogue import list_quantities
from tracksweep_client.generated.models import QuantityList

ROOT = Path(__file__).parents[2]


@pytest.fixture
def remote(service: Served) -> Iterator[Service]:
    with Service(str(service.http.base_url)) as remote:
        yield remote


def test_a_study_from_beginning_to_end(remote: Service, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    submitted = remote.submit(study(205, 235), idempotency_key="a study from beginning to end")
    assert remote.submit(study(205, 235), idempotency_key="a study from beginning to end").id == submitted.id
    assert remote.wait(submitted.id).state == "succeeded"
    assert "2 of 2 cases done" in capsys.readouterr().err
    assert [case.state for case in remote.cases(submitted.id, page_size=1)] == ["succeeded"] * 2
    assert submitted.id in [each.id for each in remote.studies(page_size=1)]
    assert [event.kind for event in remote.watch(submitted.id)].count("done") == 1

    peaks = list(remote.peaks(study_id=submitted.id, page_size=7, sort="-peak"))
    table = remote.to_dataframe(study_id=submitted.id, sort="-peak")
    assert table["peak"].tolist() == [peak.peak for peak in peaks]
    remote.save_peaks(tmp_path / "peaks.parquet", "parquet", study_id=submitted.id, sort="-peak")
    assert pd.read_parquet(tmp_path / "peaks.parquet")["peak"].tolist() == [peak.peak for peak in peaks]

    assert remote.cancel(submitted.id).state == remote.retry(submitted.id).state == "succeeded"


def test_what_is_refused_says_why(remote: Service) -> None:
    with pytest.raises(ProblemError) as caught:
        remote.submit(study(900))
    assert (caught.value.status, caught.value.errors[0].pointer) == (422, "/sweep/speed_kmh/0")


def test_without_blocking(service: Served) -> None:
    async def ask() -> object:
        async with connect(str(service.http.base_url)) as client:
            return await list_quantities.asyncio(client=client)

    quantities = asyncio.run(ask())
    assert isinstance(quantities, QuantityList)
    assert "wheel_rail_force" in [quantity.name for quantity in quantities.items]


README = (ROOT / "client/README.md").read_text()
FIRST_EXAMPLE = README.partition("```python\n")[2].partition("```")[0]
NOTEBOOK = (ROOT / "examples/notebook.py").read_text()


def test_the_example_is_short() -> None:
    assert 0 < len(FIRST_EXAMPLE.strip().splitlines()) < 10


@pytest.mark.parametrize("code", [FIRST_EXAMPLE, NOTEBOOK], ids=["readme", "notebook"])
def test_the_examples_do_what_they_say(code: str, service: Served, tmp_path: Path) -> None:
    (tmp_path / "examples").mkdir()
    (tmp_path / "examples/speed_sweep.json").write_text(json.dumps(study(205, 235)))
    url = {"TRACKSWEEP_URL": str(service.http.base_url), "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, "-c", code + "\nprint(peaks.speed_kmh.nunique())"],
        cwd=tmp_path, env=clean_environment() | url, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == "2"
    assert "2 of 2 cases done" in done.stderr
