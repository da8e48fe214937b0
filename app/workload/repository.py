"""The queue in the database."""

from collections import Counter
from datetime import UTC, datetime

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.access import visibility
from app.access.caller import Caller
from app.db.models import Case, Worker
from app.db.types import Clock
from app.workload.schemas import QueueInfo, RunningCase, Throughput, WorkerInfo

MINUTE_S, HOUR_S = 60.0, 3600.0
SHOWN = [getattr(Case, name) for name in RunningCase.model_fields]  # without the inputs, which are large
LATEST = 10_000  # cases that are looked at for the throughput: there is no index of all by when they were finished


def look(session: Session, caller: Caller) -> QueueInfo:
    """The queue as it is now."""
    oldest = select(func.count(), func.min(Case.created_at)).where(Case.state == "queued")
    queued, since = session.execute(oldest).one()
    running = Counter(session.scalars(select(Case.worker).where(Case.state == "running")))
    return QueueInfo(
        queued=queued,
        running=running.total(),
        oldest_queued_at=None if since is None else datetime.fromtimestamp(since, UTC),
        throughput=_throughput(session),
        workers=_workers(session, caller, running),
    )


def _workers(session: Session, caller: Caller, running: Counter[str | None]) -> list[WorkerInfo]:
    running_ones = select(Case.worker, *SHOWN).where(Case.state == "running")
    visible = running_ones.where(*visibility.cases(caller, Case.id)).order_by(Case.id)
    cases: dict[str | None, list[RunningCase]] = {}
    for case in session.execute(visible):
        cases.setdefault(case.worker, []).append(RunningCase.model_validate(case))
    there = session.execute(select(Worker.name, Worker.draining).where(Worker.expires > Clock()).order_by(Worker.name))
    return [
        WorkerInfo(name=name, draining=draining, running=running[name], cases=cases.get(name, []))
        for name, draining in there
    ]


def _throughput(session: Session) -> Throughput:
    latest = select(Case.state, Case.finished_at, Case.cpu_s).order_by(Case.id.desc()).limit(LATEST).subquery()
    done = latest.c.state.in_(["succeeded", "failed"]), latest.c.finished_at > Clock() - HOUR_S
    lately = func.count().filter(latest.c.finished_at > Clock() - MINUTE_S)
    row = session.execute(select(func.count(), lately, func.sum(latest.c.cpu_s)).where(*done)).one()
    return Throughput(last_hour=row[0], last_minute=row[1], cpu_s_last_hour=row[2] or 0.0)
