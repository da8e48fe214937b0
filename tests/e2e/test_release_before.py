"""The client of now against the service of the minor version before, taken from the repository's history."""

import io
import json
import subprocess
import tarfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tests.e2e.conftest import Served, served, study, until
from tracksweep_client import ProblemError, Service
from tracksweep_client.generated.api.cases import get_case
from tracksweep_client.generated.api.histories import download_history
from tracksweep_client.generated.models import CaseDetail
from tracksweep_client.generated.types import UNSET, File

ROOT = Path(__file__).parents[2]
RELEASE = "541afd8e72635c9c7b1a20a9ce0d1d62ff97024f"  # the last commit of 0.1.0


@pytest.fixture
def before(tmp_path: Path) -> Iterator[Served]:
    archive = subprocess.run(["git", "-C", ROOT, "archive", RELEASE], capture_output=True, check=False)
    if archive.returncode:
        pytest.skip(f"this clone's history does not reach back to release 0.1.0: {archive.stderr.decode()}")
    with tarfile.open(fileobj=io.BytesIO(archive.stdout)) as tar:
        tar.extractall(tmp_path / "source", filter="data")
    its_own = {"PYTHONPATH": str(tmp_path / "source"), "PYTHONSAFEPATH": "1"}
    with served(tmp_path / "data", "--workers", "1", **its_own) as service:
        yield service


@pytest.mark.slow
def test_what_it_offers_can_be_used(before: Served) -> None:
    assert before.get("/openapi.json") == json.loads((ROOT / "tests/client/openapi-0.1.json").read_text())
    with Service(str(before.http.base_url)) as remote:
        with pytest.raises(ProblemError) as caught:
            remote.submit(study(900))
        assert caught.value.errors[0].pointer == "/sweep/speed_kmh/0"

        sent = study(250, 300) | {"keep_history": True}
        submitted = remote.submit(sent, idempotency_key="once")
        assert remote.submit(sent, idempotency_key="once").id == submitted.id
        until(lambda: remote.study(submitted.id).state == "succeeded", 240)  # its solver is compiled first
        assert [each.id for each in remote.studies(page_size=1)] == [submitted.id]
        cases = list(remote.cases(submitted.id, page_size=1))
        assert [case.speed_kmh for case in cases] == [250, 300]
        peaks = list(remote.peaks(study_id=submitted.id, page_size=7))
        assert {peak.speed_kmh for peak in peaks} == {250, 300}

        case = get_case.sync(cases[0].id, client=remote.client)
        assert isinstance(case, CaseDetail)
        assert case.processing is UNSET  # which came later
        history = download_history.sync(case.id, client=remote.client)
        assert isinstance(history, File)
        assert np.load(history.payload).files
