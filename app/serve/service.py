"""``tracksweep serve``: one data folder, one service on it."""

import asyncio
import fcntl
import json
import os
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import httpx

from app.metrics.together import counting_together
from app.serve.broker import broker_part
from app.serve.supervisor import Part, supervise
from app.settings import Settings

PROGRAM = (sys.executable, "-m", "worker.cli")


class CannotServeError(Exception):
    """The service cannot start as asked; the message says why."""


@contextmanager
def sole_owner(data: Path) -> Iterator[None]:
    """Hold the data folder; refuse if another service does. The lock ends with the process, however that ends."""
    with (data / "serve.lock").open("a+") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            lock.seek(0)
            raise CannotServeError(f"Another service runs on {data} (process {lock.read().strip()}).") from None
        lock.truncate(0)
        lock.write(str(os.getpid()))
        lock.flush()
        yield


def listen(host: str, port: int) -> socket.socket:
    """A socket that listens: opened before the API and outliving it, no request is refused while that restarts."""
    try:
        family = socket.AF_INET6 if ":" in host else socket.AF_INET
        return socket.create_server((host, port), family=family, backlog=2048)
    except OSError as error:
        raise CannotServeError(f"Cannot listen on {host}, port {port}: {error.strerror}.") from None


def url_of(listener: socket.socket) -> str:
    """Where a client on this machine reaches a listening socket."""
    host, port = listener.getsockname()[:2]
    host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(host, host)  # noqa: S104
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def serve(settings: Settings) -> None:
    """Run the service until a signal.

    Raises
    ------
    CannotServeError
        If the data folder or the port cannot be had, or the database cannot be migrated.
    PartFailedError
        If a part does not come up.
    """
    data = settings.data_dir.resolve()
    try:
        (data / "logs").mkdir(mode=0o700, parents=True, exist_ok=True)
    except OSError as error:
        raise CannotServeError(f"Cannot keep data in {data}: {error.strerror}.") from None
    with (
        sole_owner(data),
        listen(settings.host, settings.port) as listener,
        counting_together(settings.api_processes),
        _announcement(data, listener) as announce,
    ):
        os.environ["TRACKSWEEP_DATA_DIR"] = str(data)  # for every part, whatever folder it runs in
        for previous in (data / "logs").glob("*.log"):
            previous.replace(previous.with_suffix(".log.1"))
        _migrate(data / "logs" / "migrate.log")
        asyncio.run(supervise(_stages(settings, listener), data / "logs", announce))


def _stages(settings: Settings, listener: socket.socket) -> list[list[Part]]:
    """What runs, in the order of starting: the broker unless another is named, the API, the workers."""
    url = url_of(listener)

    async def api_ready() -> bool:
        with suppress(httpx.HTTPError):
            async with httpx.AsyncClient(trust_env=False, timeout=2) as client:
                return (await client.get(f"{url}/readyz")).is_success
        return False

    descriptor = listener.fileno()
    api = [
        Part(
            name=f"api-{n + 1}",
            command=[*PROGRAM, "api", "--fd", str(descriptor)],
            ready=api_ready,
            pass_fds=[descriptor],
        )
        for n in range(settings.api_processes)
    ]
    workers = [Part(name=f"worker-{n + 1}", command=[*PROGRAM, "worker"]) for n in range(settings.workers)]
    return [[] if settings.broker_url else [broker_part(settings)], api, workers]


def _migrate(log_file: Path) -> None:
    with log_file.open("wb") as output:
        code = subprocess.call([*PROGRAM, "migrate"], stdin=subprocess.DEVNULL, stdout=output, stderr=output)  # noqa: S603
    if code:
        raise CannotServeError(f"The database cannot be migrated.\n{log_file.read_text(errors='replace')}")


@contextmanager
def _announcement(data: Path, listener: socket.socket) -> Iterator[Callable[[], None]]:
    """Say where the service is, to the person who started it and, in ``serve.json``, to scripts."""
    url, note = url_of(listener), data / "serve.json"

    def announce() -> None:
        draft = note.with_suffix(".tmp")
        draft.write_text(json.dumps({"url": url, "pid": os.getpid()}))
        draft.replace(note)
        print(f"TrackSweep runs at {url} (the API is documented at {url}/docs).")
        print(f"Data and logs: {data}. Ctrl-C stops the service.", flush=True)

    note.unlink(missing_ok=True)  # of a service that was killed
    try:
        yield announce
    finally:
        note.unlink(missing_ok=True)
