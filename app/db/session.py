"""Transactions: one per request or task, to read or to write."""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from threading import Lock
from typing import Any

from sqlalchemy import Connection, Engine, create_engine, event, make_url
from sqlalchemy.orm import Session, sessionmaker

from app.db import tally

BUSY_TIMEOUT_MS = 30_000  # what a writer waits for another before it gives up
SILENCE_MS = 25_000  # after which a peer on the network counts as gone

_READING: dict[str, dict[str, Any]] = {
    "sqlite": {"read_only": True},
    "postgresql": {"postgresql_readonly": True, "isolation_level": "REPEATABLE READ"},
}


class Database:
    """The two doors to a database.

    ``with database.write() as session`` is a transaction that commits when the block ends and rolls back if it
    raises; ``with database.read() as session`` sees one state of the database, changes nothing and, on SQLite,
    never waits for a writer.

    Parameters
    ----------
    url : str
        SQLAlchemy URL: ``sqlite:///FILE`` or ``postgresql+psycopg://…``.
    pause_s : float, optional
        PostgreSQL ends a transaction that does nothing for so long: whose it is was stopped or cut off, and others
        wait for its locks.
    """

    def __init__(self, url: str, pause_s: float = 0.0) -> None:
        self.engine = create_engine_for(url, pause_s=pause_s)
        self._writers = sessionmaker(self.engine, expire_on_commit=False)
        self._readers = sessionmaker(self.engine.execution_options(**_READING[self.engine.dialect.name]))
        # SQLite's own waiting looks again after ever longer pauses, so of many threads some would wait for seconds.
        self._turn = Lock() if self.engine.dialect.name == "sqlite" else nullcontext()

    @contextmanager
    def write(self) -> Iterator[Session]:
        """A transaction that may change things."""
        with self._turn, self._writers.begin() as session:
            yield session
            tally.write(session)

    @contextmanager
    def read(self) -> Iterator[Session]:
        """A transaction that only looks."""
        with self._readers() as session:
            yield session

    def close(self) -> None:
        """Close the connections that nobody uses."""
        self.engine.dispose()


def create_engine_for(url: str, *, foreign_keys: bool = True, pause_s: float = 0.0) -> Engine:
    """The engine for a URL; ``foreign_keys=False`` leaves them unenforced where the database allows (SQLite)."""
    if make_url(url).get_backend_name() == "sqlite":
        return _create_sqlite_engine(url, foreign_keys=foreign_keys)
    return _create_postgresql_engine(url, pause_s)


def _create_sqlite_engine(url: str, *, foreign_keys: bool) -> Engine:
    """An engine whose transactions are real.

    The driver's own transaction handling begins one only at the first write, after the reads it was based on:
    two read-modify-writes then overwrite each other. So the driver is told to keep out of it, and a transaction
    that may write takes the write lock at its start.
    """
    # More connections than there are threads to serve requests: none waits for another to come back.
    engine = create_engine(url, pool_size=5, max_overflow=50)

    @event.listens_for(engine, "connect")
    def configure(connection: Any, record: object) -> None:
        connection.isolation_level = None
        connection.execute(f"PRAGMA busy_timeout = {BUSY_TIMEOUT_MS}")
        connection.execute(f"PRAGMA foreign_keys = {foreign_keys:d}")
        _write_ahead(connection)

    @event.listens_for(engine, "begin")
    def begin(connection: Connection) -> None:
        read_only = connection.get_execution_options().get("read_only", False)
        connection.exec_driver_sql("BEGIN" if read_only else "BEGIN IMMEDIATE")

    return engine


def _write_ahead(connection: sqlite3.Connection) -> None:
    """Of several who open a new database at once one changes its journal; the others are refused, not made to wait."""
    deadline = time.monotonic() + BUSY_TIMEOUT_MS / 1000
    while True:
        try:
            connection.execute("PRAGMA journal_mode = WAL")
        except sqlite3.OperationalError as error:
            if error.sqlite_errorcode != sqlite3.SQLITE_BUSY or time.monotonic() > deadline:
                raise
            time.sleep(0.01)
        else:
            return


def _create_postgresql_engine(url: str, pause_s: float) -> Engine:
    """An engine that notices a server that went away, and does not wait for ever. The server notices, too, when this
    host is cut off, and gives up the locks of whatever was going on.
    """
    silence = {"tcp_keepalives_idle": 10, "tcp_keepalives_interval": 5, "tcp_keepalives_count": 3}
    of_server = silence | {
        "tcp_user_timeout": SILENCE_MS,
        "lock_timeout": BUSY_TIMEOUT_MS,
        "idle_in_transaction_session_timeout": round(1000 * pause_s),
    }
    connect_args = {
        "connect_timeout": 5,
        "options": " ".join(f"-c {name}={value}" for name, value in of_server.items()),
        "tcp_user_timeout": SILENCE_MS,
        **{name.removeprefix("tcp_"): value for name, value in silence.items()},
    }
    return create_engine(
        url, pool_size=5, max_overflow=10, pool_timeout=10, pool_pre_ping=True, connect_args=connect_args
    )
