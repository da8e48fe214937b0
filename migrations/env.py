"""What Alembic runs: inside the transaction of :func:`migrations.upgrade`, or in one of its own for a developer.

``TRACKSWEEP_DATABASE_URL=sqlite:///scratch.db alembic revision --autogenerate -m "…"`` writes a revision.
"""

from alembic import context
from sqlalchemy import Connection

from app.db.models import Base
from app.settings import Settings
from migrations import transaction


def _run(connection: Connection) -> None:
    context.configure(
        connection=connection,
        target_metadata=Base.metadata,
        render_as_batch=True,
        transactional_ddl=True,  # SQLite can, whatever Alembic assumes of it
    )
    context.run_migrations()


if (given := context.config.attributes.get("connection")) is not None:
    _run(given)
else:
    with transaction(Settings().resolved_database_url) as own:
        _run(own)
