"""A short run of the harness. `make chaos` has the long ones, and its controls."""

import subprocess
import sys
from pathlib import Path

from solver.warm import warm
from tests.chaos.record import read

FAULTS = 20


def test_a_few_faults_break_no_rule(tmp_path: Path) -> None:
    warm()  # the harness looks at clocks
    record = tmp_path / "record.jsonl"
    command = [sys.executable, "-m", "tests.chaos", "run", str(record), "--database", "postgresql"]
    done = subprocess.run([*command, "--faults", str(FAULTS)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert sum(line["kind"] == "fault" for line in read(record)) == FAULTS
