"""The schema's history, applied from the installed package: ``upgrade(url)``."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from alembic import command
from alembic.config import Config
from sqlalchemy import Connection, text

from app.db.session import create_engine_for

_LOCK = 7_305_118_203_714_511  # any number, as long as every migration takes the same


@contextmanager
def transaction(url: str) -> Iterator[Connection]:
    """A transaction that holds out every other migration of the same database.

    SQLite alters a table by building it anew and dropping the old one, which with foreign keys enforced would take
    all rows that refer to it along: they are not enforced here.
    """
    engine = create_engine_for(url, foreign_keys=False)
    try:
        with engine.begin() as connection:
            if connection.dialect.name == "postgresql":
                connection.execute(text("SELECT pg_advisory_xact_lock(:lock)"), {"lock": _LOCK})
            yield connection
    finally:
        engine.dispose()


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
        The database cannot be reached or stays locked.
    """
    with transaction(url) as connection:
        command.upgrade(config_for(connection), revision)
