"""A service of a program's own, for as long as the program needs it."""

import json
import os
import signal
import subprocess
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from app.serve.service import PROGRAM

START_TIMEOUT_S = 120


def url_of(data: Path, pid: int) -> str | None:
    """Where the service with a process id serves a folder; None before it does."""
    try:
        note = json.loads((data / "serve.json").read_text())
    except FileNotFoundError:
        return None
    return str(note["url"]) if note["pid"] == pid else None


@contextmanager
def own_service(data: Path, *options: str, settings: Mapping[str, str] | None = None) -> Iterator[str]:
    """A service on a free port; its URL.

    Parameters
    ----------
    data : Path
        Its folder, made if missing. What it prints is in ``serve.log`` there.
    *options : str
        Of ``tracksweep serve``.
    settings : mapping of str to str, optional
        Its settings, in place of those of the environment.
    """
    data.mkdir(parents=True, exist_ok=True)
    environment = dict(os.environ)
    if settings is not None:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("TRACKSWEEP_")}
        environment |= settings
    command = [*PROGRAM, "serve", "--data", str(data), "--port", "0", *options]
    log = data / "serve.log"
    with (
        log.open("w") as output,
        subprocess.Popen(command, env=environment, stdout=output, stderr=output) as process,  # noqa: S603
    ):
        try:
            deadline = time.monotonic() + START_TIMEOUT_S
            while (url := url_of(data, process.pid)) is None:
                if process.poll() is not None or time.monotonic() > deadline:
                    raise SystemExit(f"The service does not start.\n{log.read_text()}")
                time.sleep(0.1)
            yield url
        finally:
            process.send_signal(signal.SIGINT)
