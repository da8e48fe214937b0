"""A speed sweep from beginning to end: serve, submit over HTTP, wait, print, draw.

Run it by ``make demo``. Everything it makes lies in ``demo/``; a second run finds its cases already computed.
"""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from app.console import out
from app.remote.client import Service
from app.remote.progress import follow
from app.remote.tables import table, write_csv
from examples.figure import draw_peaks_against_speed

STUDY = Path(__file__).parent / "speed_sweep.json"
DEMO = Path("demo")
DATA = DEMO / "data"
START_TIMEOUT_S = 120


def url_of(data: Path, pid: int) -> str | None:
    """Where the service with a process id serves a folder; None before it does."""
    try:
        note = json.loads((data / "serve.json").read_text())
    except FileNotFoundError:
        return None
    return str(note["url"]) if note["pid"] == pid else None


@contextmanager
def served(data: Path) -> Iterator[str]:
    """A service on a free port, for as long as the block runs; its URL."""
    command = [sys.executable, "-m", "worker.cli", "serve", "--data", str(data), "--port", "0"]
    log = DEMO / "serve.log"
    with log.open("w") as output, subprocess.Popen(command, stdout=output, stderr=output) as process:
        try:
            deadline = time.monotonic() + START_TIMEOUT_S
            while (url := url_of(data, process.pid)) is None:
                if process.poll() is not None or time.monotonic() > deadline:
                    raise SystemExit(f"The service does not start.\n{log.read_text()}")
                time.sleep(0.1)
            yield url
        finally:
            process.send_signal(signal.SIGINT)


def main() -> None:
    """Run the study of ``speed_sweep.json``."""
    DEMO.mkdir(exist_ok=True)
    print("Starting a service on", DATA)
    with served(DATA) as url, Service(url) as service:
        study = service.submit(json.loads(STUDY.read_text()))
        print(f"Submitted the study “{study['name']}” to {url}")
        if study["cases_reused"]:
            print(f"{study['cases_reused']} of {study['cases']['total']} cases were already computed")
        study = follow(service.watch(study["id"]))
        rows = list(service.peaks(study_id=study["id"], sort="speed_kmh"))

    out.print(table(rows))
    write_csv(DEMO / "peaks.csv", rows)
    draw_peaks_against_speed(rows, f"{study['name']}: largest peaks", DEMO / "peaks_vs_speed.png")
    print(f"Wrote {DEMO / 'peaks.csv'} and {DEMO / 'peaks_vs_speed.png'}")
    if study["state"] != "succeeded":
        raise SystemExit(f"The study ended as {study['state']}.")


if __name__ == "__main__":
    main()
