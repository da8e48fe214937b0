"""The schema's history, applied from the installed package: ``upgrade(url)``."""

import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from alembic import command
from alembic.config import Config
from sqlalchemy import Connection, text
from sqlalchemy.exc import OperationalError

from app.db.session import create_engine_for

# Who waits for a table that somebody reads lets nobody else read it meanwhile: better give up soon.
LOCK_TIMEOUT_MS = 5_000
STATEMENT_TIMEOUT_MS = 15 * 60_000  # an index on millions of peaks takes minutes

_LOCK = 7_305_118_203_714_511  # any number, as long as every migration takes the same
_BLOCKED = {"55P03": "waited for a lock", "57014": "took", sqlite3.SQLITE_BUSY: "waited for the write lock"}


class BlockedError(Exception):
    """A migration that gave up; nothing was changed."""


@contextmanager
def transaction(url: str) -> Iterator[Connection]:
    """A transaction that holds out every other migration of the same database.

    SQLite alters a table by building it anew and dropping the old one, which with foreign keys enforced would take
    all rows that refer to it along: they are not enforced here.

    Raises
    ------
    BlockedError
        If somebody else uses the database in a way that leaves no room.
    """
    engine = create_engine_for(url, foreign_keys=False)
    try:
        with engine.begin() as connection:
            if connection.dialect.name == "postgresql":
                connection.execute(text("SET LOCAL lock_timeout = 0"))  # another migration has time-outs of its own
                connection.execute(text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": _LOCK})
                connection.execute(text(f"SET LOCAL lock_timeout = {LOCK_TIMEOUT_MS}"))
                connection.execute(text(f"SET LOCAL statement_timeout = {STATEMENT_TIMEOUT_MS}"))
            yield connection
    except OperationalError as error:
        if (why := _why_blocked(error)) is None:
            raise
        raise BlockedError(
            f"The migration {why} for too long and was given up; nothing was changed. Somebody reads or writes the "
            "database: try again later, or stop the service, and whatever else is connected, first."
        ) from error
    finally:
        engine.dispose()


def _why_blocked(error: OperationalError) -> str | None:
    code = getattr(error.orig, "sqlstate", None) or getattr(error.orig, "sqlite_errorcode", None)
    return _BLOCKED.get(code)


def config_for(connection: Connection) -> Config:
    """Alembic's configuration, on a connection that is already open."""
    config = Config()
    config.set_main_option("script_location", str(Path(__file__).parent))
    config.attributes["connection"] = connection
    return config


def upgrade(url: str, revision: str = "head") -> None:
    """Bring a database to a revision, all or nothing. Safe to run from several processes at once: the second waits.

    Parameters
    ----------
    url : str
        SQLAlchemy URL of the database; a SQLite file is created when missing.
    revision : str
        Where to stop.

    Raises
    ------
    sqlalchemy.exc.OperationalError
        The database cannot be reached.
    BlockedError
        It stays locked.
    """
    with transaction(url) as connection:
        command.upgrade(config_for(connection), revision)
