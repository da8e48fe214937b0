"""The client against a service that computes."""

import asyncio
import json
import re
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

README = Path(__file__).parents[2] / "client/README.md"


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


def test_the_readme_does_what_it_says(service: Served, tmp_path: Path) -> None:
    code = re.search("```python\n(.*?)```", README.read_text(), re.DOTALL)
    assert code is not None
    assert len(code[1].strip().splitlines()) < 10
    (tmp_path / "examples").mkdir()
    (tmp_path / "examples/speed_sweep.json").write_text(json.dumps(study(205, 235)))
    url = {"TRACKSWEEP_URL": str(service.http.base_url), "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, "-c", code[1] + "\nprint(len(peaks))"],
        cwd=tmp_path, env=clean_environment() | url, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip
    assert (done.returncode, done.stdout) == (0, "2\n"), done.stderr
