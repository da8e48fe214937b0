"""A few faults of every kind, as ``make chaos`` has many: the harness works, and so does the service."""

import json
import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

from solver.warm import warm
from tests.e2e.conftest import clean_environment

ROOT = Path(__file__).parents[2]
FAULTS = 20


@pytest.mark.parametrize("database", ["postgresql"])
def test_twenty_faults(database: str, tmp_path: Path) -> None:
    warm()  # before the clock of the service runs
    record = tmp_path / "record.jsonl"
    command = [sys.executable, "-m", "tests.chaos", "run", str(record), "--database", database, "--faults", str(FAULTS)]
    done = subprocess.run(command, cwd=ROOT, env=clean_environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr[-3000:]
    lines = [json.loads(line) for line in record.read_text().splitlines()]
    assert Counter(line["kind"] for line in lines)["fault"] == FAULTS
