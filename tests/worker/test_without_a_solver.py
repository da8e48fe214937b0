"""A worker without a solver, in this process, on both databases."""

from sqlalchemy import select, update

from app.context import Context
from app.db.models import Event, Worker
from app.db.types import Clock
from app.studies import service
from tests.worker.conftest import Submit
from worker import presence
from worker.unable import UnableWorker


def test_it_leaves_cases_to_those_who_can(context: Context, submit: Submit) -> None:
    study = submit(200, 210)
    unable = UnableWorker(context.settings, ImportError("built for another machine"))
    with context.database.write() as session:
        presence.announce(session, "somebody", 60.0)
    assert unable.work() == 0
    with context.database.write() as session:
        session.execute(update(Worker).values(expires=Clock() - 1.0))
    assert unable.work() == 2
    unable.database.close()
    with context.database.read() as session:
        ended = service.get(session, study.id)
        assert (ended.state, ended.cases.failed) == ("failed", 2)
        kinds = session.scalars(select(Event.kind).order_by(Event.id)).all()
        assert kinds == ["state", "case", "case", "state", "done"]
