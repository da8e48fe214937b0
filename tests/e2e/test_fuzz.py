"""Thousands of requests made from the OpenAPI document, against a service that computes meanwhile."""

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.e2e.conftest import Served, clean_environment, served

ROOT = Path(__file__).parents[2]
SMALL = dict.fromkeys(("TRACKSWEEP_READS_PER_MINUTE", "TRACKSWEEP_WRITES_PER_MINUTE"), "0") | {
    "TRACKSWEEP_MAX_CASES_PER_STUDY": "20"
}
PROGRAM = Path(sys.executable).parent / "schemathesis"


@pytest.fixture(scope="module")
def small_service(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    """Takes small studies only, so that there is time to compute them."""
    with served(tmp_path_factory.mktemp("fuzz") / "data", "--workers", "1", **SMALL) as service:
        yield service


def fuzz(service: Served, *options: object) -> int:
    """How many requests were made; fails if one of them was answered in a way that the document does not say."""
    command = [PROGRAM, "--config-file", ROOT / "tests/e2e/schemathesis.toml", "run", "--no-color", *options]
    command.append(f"{service.http.base_url}/openapi.json")
    environment = clean_environment() | {"NO_PROXY": "*", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [str(part) for part in command], cwd=service.data, env=environment, capture_output=True, text=True, check=False
    )
    made = re.search(r"^  (\d+) generated", done.stdout, re.MULTILINE)
    assert made is not None, done.stdout[-5000:] + done.stderr[-5000:]
    assert done.returncode == 0, done.stdout[-20000:]
    return int(made[1])


def test_a_few_requests(small_service: Served) -> None:
    options = ("--phases", "examples,fuzzing,stateful", "--max-examples", 8, "--generation-deterministic")
    assert fuzz(small_service, *options) >= 300


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_thousands_of_requests(small_service: Served) -> None:
    assert fuzz(small_service, "--max-examples", 30) >= 3000
