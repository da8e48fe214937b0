"""Places for those who add peaks to PostgreSQL.

All of them write to the same pages of the same indexes. The more do it at once, the more of the server's time goes into
waiting for one another, so that more is done if some stand in line (`python -m benchmarks.scale`).
"""

import secrets

import structlog
from sqlalchemy import func, select, text
from sqlalchemy.exc import OperationalError
from sqlalchemy.orm import Session

PATIENCE_MS = 1000  # then one goes on without: who has a place may be cut off, and hold it until the server notices

_LOCK = 1_302_518_641  # the first of an advisory lock's two keys; any number
_AS_BEFORE = text("SET LOCAL lock_timeout TO DEFAULT")
_LOCK_NOT_AVAILABLE = "55P03"

log = structlog.get_logger()


def take(session: Session, places: int) -> None:
    """Wait for a place, though not for long, and keep it until the transaction ends. SQLite has one writer anyway.

    Nothing depends on it but speed.
    """
    if session.get_bind().dialect.name != "postgresql":
        return
    try:
        with session.begin_nested():
            session.execute(text(f"SET LOCAL lock_timeout = {PATIENCE_MS}"))
            session.execute(select(func.pg_advisory_xact_lock(_LOCK, secrets.randbelow(places))))
            session.execute(_AS_BEFORE)
    except OperationalError as error:
        if getattr(error.orig, "sqlstate", None) != _LOCK_NOT_AVAILABLE:
            raise
        log.info("all places taken for long")
