"""The log of a process."""

import json
import subprocess
import sys
from pathlib import Path

SCRIPT = """
import logging, sqlite3, structlog
from app import log
log.configure()
log.configure_libraries()
for _ in range(100):
    log.unavailable("database", sqlite3.OperationalError("gone\\nfishing"))
    log.unavailable("broker", OSError("gone"))
structlog.get_logger().warning("mine")
try:
    1 / 0
except ZeroDivisionError:
    logging.getLogger("theirs").exception("theirs")
print("alive")
"""


def run(log: Path) -> None:
    """Run the script above with its log in a file."""
    with log.open("w") as errors:
        done = subprocess.run([sys.executable, "-c", SCRIPT], stdout=subprocess.PIPE, stderr=errors, check=False)
    assert done.stdout == b"alive\n"


def test_an_entry_is_a_line_and_what_is_away_is_told_once_a_second(tmp_path: Path) -> None:
    run(tmp_path / "log")
    entries = [json.loads(line) for line in (tmp_path / "log").read_text().splitlines()]
    assert [entry["event"] for entry in entries] == ["database unavailable", "broker unavailable", "mine", "theirs"]
    assert entries[0]["error"] == "OperationalError: gone\nfishing"
    assert "ZeroDivisionError" in entries[3]["exception"]


def test_nobody_fails_for_want_of_a_line_in_the_log() -> None:
    run(Path("/dev/full"))
