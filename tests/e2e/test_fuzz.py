"""Requests made from the OpenAPI document: no 5xx, no status, media type or body that the document does not tell of, no
request refused that it allows, none accepted that it does not.

What is left out, and why, is said where it is left out: in ``schemathesis.toml`` and ``fuzz_hooks.py``. Paths outside
the document (``/healthz``, ``/docs``, …) are not asked for, and no keys are sent, as the loopback asks for none:
``tests/app/test_access.py`` is about them.
"""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests.e2e.conftest import Served, clean_environment, served

ROOT = Path(__file__).parents[2]
SMALL = dict.fromkeys(("TRACKSWEEP_READS_PER_MINUTE", "TRACKSWEEP_WRITES_PER_MINUTE"), "0") | {
    "TRACKSWEEP_MAX_CASES_PER_STUDY": "100"
}
PROGRAM = Path(sys.executable).parent / "schemathesis"
CONFIG = ROOT / "tests/e2e/schemathesis.toml"
QUICK = """
[[operations]]
include-operation-id = ["create_study", "estimate_study"]
phases.coverage.enabled = false  # which makes thousands of requests of each
"""


def fuzz(service: Served, config: Path, *options: object) -> int:
    """How many requests were made; fails if one of them was answered in a way that the document does not say."""
    command = [PROGRAM, "--config-file", config, "run", "--no-color", *options]
    command.append(f"{service.http.base_url}/openapi.json")
    kept = str(ROOT / ".hypothesis")  # tables of characters, which take seconds to make
    environment = clean_environment() | {"NO_PROXY": "*", "PYTHONPATH": str(ROOT), "HYPOTHESIS_STORAGE_DIRECTORY": kept}
    done = subprocess.run(
        [str(part) for part in command], cwd=service.data, env=environment, capture_output=True, text=True, check=False
    )
    made = re.search(r"^  (\d+) generated", done.stdout, re.MULTILINE)
    assert made is not None, done.stdout[-5000:] + done.stderr[-5000:]
    assert done.returncode == 0, done.stdout[-20000:]
    return int(made[1])


def test_the_bounds_of_every_field_and_a_few_requests_at_random(tmp_path: Path) -> None:
    """The same ones in every run; nobody computes."""
    config = tmp_path / "quick.toml"
    config.write_text(CONFIG.read_text() + QUICK)
    options = ("--phases", "coverage,fuzzing,stateful", "--max-examples", 3, "--generation-deterministic")
    with served(tmp_path / "data", "--workers", "0", **SMALL) as service:
        assert fuzz(service, config, *options) >= 1500


@pytest.mark.slow
@pytest.mark.timeout(1800)
def test_thousands_of_requests(tmp_path: Path) -> None:
    """Others in every run, while workers compute what was accepted."""
    with served(tmp_path / "data", "--workers", "2", **SMALL) as service:
        assert fuzz(service, CONFIG, "--max-examples", 100) >= 10_000
