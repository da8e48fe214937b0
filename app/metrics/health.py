"""Whether the parts of the service answer."""

from sqlalchemy import text
from sqlalchemy.exc import SQLAlchemyError

from app import log
from app.context import Context
from app.db.models import SCHEMA
from app.storage import STORE_ERRORS

OK, AWAY, OUTDATED = "ok", "away", "outdated"
NOT_READY = {
    AWAY: "The database does not answer. Try again later.",
    OUTDATED: "The database has the tables of an older release: run `tracksweep migrate`.",
}


def parts(context: Context) -> dict[str, str]:
    """The state of database and broker, and of the store: whether histories can be written. May take seconds."""
    return {
        "database": database(context),
        "broker": OK if context.doorbell.answers() else AWAY,
        "histories": _histories(context),
    }


def database(context: Context) -> str:
    """Whether it answers, and has the tables of this release or of a newer one, as in an upgrade under way."""
    try:
        with context.database.read() as session:
            revision = session.scalar(text("SELECT version_num FROM alembic_version"))
    except SQLAlchemyError as error:
        log.unavailable("database", error)
        return AWAY
    return OK if str(revision) >= SCHEMA else OUTDATED


def _histories(context: Context) -> str:
    try:
        context.histories.probe()
    except STORE_ERRORS as error:
        log.unavailable("history store", error)
        return AWAY
    return OK
