"""A worker that cannot compute, as its solver cannot be loaded: it says so of every case, rather than let them wait."""

from sqlalchemy import select
from sqlalchemy.exc import SQLAlchemyError

from app import log
from app.db.models import Case
from app.db.session import Database
from app.settings import Settings
from solver.version import SOLVER_VERSION
from worker import lease, presence

AT_ONCE = 100  # others are to get a word in


class UnableWorker:
    """Stands in for a worker.

    Parameters
    ----------
    settings : Settings
    reason : Exception
        What loading the solver ended in.
    """

    def __init__(self, settings: Settings, reason: Exception) -> None:
        self.database = Database(settings.resolved_database_url, settings.lease_s)
        self._detail = f"The solver cannot be loaded: {type(reason).__name__}: {reason}"

    def work(self) -> int:
        """Fail what is queued, unless there is a worker that can compute it. Returns how many cases."""
        failed = 0
        try:
            while count := self._fail_some():
                failed += count
        except SQLAlchemyError as error:
            log.unavailable("database", error)
        return failed

    def _fail_some(self) -> int:
        with self.database.write() as session:
            if presence.count_with(session, presence.own_name()) > 1:
                return 0
            own = Case.state == "queued", Case.solver_version == SOLVER_VERSION
            queued = select(Case.id).where(*own).order_by(Case.digest).limit(AT_ONCE)
            ids = session.scalars(queued.with_for_update(skip_locked=True, key_share=True)).all()
            for case_id in ids:
                lease.refuse(session, case_id, "solver-unavailable", self._detail)
            return len(ids)
