"""The state of the service as metrics, read when they are asked for: true for any number of processes and hosts.

Nothing here reads more rows than wait or run, and of those that wait only what the index of the queue holds.
"""

import shutil
import time
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from prometheus_client import CollectorRegistry, Metric
from prometheus_client.core import CounterMetricFamily, GaugeMetricFamily
from prometheus_client.registry import Collector
from sqlalchemy import func, select
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from app import log
from app.cases.queue import UNFINISHED
from app.context import Context
from app.db import tally
from app.db.models import Case, Verification, Worker
from app.db.types import Clock
from app.metrics import health

PREFIX = "tracksweep_"


class Counted(NamedTuple):
    """A metric of what is counted, with the values of its label that are shown from the start: what appears with its
    first count has not grown, for Prometheus.
    """

    metric: str
    text: str
    label: str | None = None
    values: tuple[str, ...] = ("",)


COUNTED: dict[tally.Name, Counted] = {
    "cases_requested": Counted("cases_requested", "Cases of new studies.", "answer", ("reused", "queued")),
    "cases_ended": Counted("cases_ended", "Cases that ended.", "state", ("succeeded", "failed", "cancelled")),
    "attempts_given_up": Counted(
        "attempts_given_up", "Attempts that were broken off.", "reason", ("poison", "time-limit", "memory-limit")
    ),
    "leases_expired": Counted("leases_expired", "Cases taken from workers that fell silent."),
    "solver_cpu_s": Counted("solver_cpu_seconds", "Processor time of computed cases."),
    "simulated_s": Counted("simulated_seconds", "Time that trains ran in computed cases."),
    "lanes": Counted("lanes", "Lanes of the blocks that workers began to compute.", "filled", ("yes", "no")),
}


class ServiceCollector(Collector):
    """What is read for one scrape."""

    def __init__(self, context: Context) -> None:
        self._context = context

    @classmethod
    def registry(cls, context: Context) -> CollectorRegistry:
        """With this collector alone."""
        registry = CollectorRegistry()
        registry.register(cls(context))
        return registry

    def describe(self) -> Iterable[Metric]:
        """Nothing, or it would be asked when it is registered."""
        return []

    def collect(self) -> Iterable[Metric]:
        """All of it; without the database, what is known without it."""
        parts = health.parts(self._context)
        yield _gauge("up", "Whether a part of the service answers.", "part", {k: v == "ok" for k, v in parts.items()})
        yield from self._disks()
        try:
            with self._context.database.read() as session:
                yield from [*_queue(session), *_counters(session)]
        except SQLAlchemyError as error:
            log.unavailable("database", error)

    def _disks(self) -> Iterable[Metric]:
        folders = {"data": self._context.settings.data_dir, "histories": self._context.histories.folder}
        disks = {name: shutil.disk_usage(path) for name, path in folders.items() if path is not None and path.exists()}
        free = {name: disk.free for name, disk in disks.items()}
        yield _gauge("disk_free_bytes", "Free space where a folder of the service lies.", "folder", free)
        size = {name: disk.total for name, disk in disks.items()}
        yield _gauge("disk_size_bytes", "Space where a folder of the service lies.", "folder", size)


def _queue(session: Session) -> Iterable[Metric]:
    by_state = select(Case.state, func.count(), func.min(Case.id)).where(Case.state.in_(UNFINISHED))
    rows = {row[0]: row for row in session.execute(by_state.group_by(Case.state))}
    counts = {state: rows[state][1] if state in rows else 0 for state in UNFINISHED}
    yield _gauge("cases", "Cases that wait or are computed.", "state", counts)
    first = rows["queued"][2] if "queued" in rows else None
    asked = session.scalar(select(Clock() - Case.created_at).where(Case.id == first))
    yield _gauge("queue_oldest_seconds", "Time since the oldest case that waits was first asked for.", value=asked)
    silent = session.scalar(select(Clock() - func.min(Case.heartbeat_at)).where(Case.state == "running"))
    yield _gauge("lease_age_seconds", "Time since the most silent worker that computes was heard of.", value=silent)
    there = session.scalar(select(func.count()).where(Worker.expires > Clock()))
    yield _gauge("workers", "Workers that are there.", value=there)
    due = select(func.count()).where(Verification.state.in_(UNFINISHED))
    yield _gauge("verifications", "Verifications that wait or are computed.", value=session.scalar(due))
    apart = time.time() - (session.scalar(select(Clock())) or 0.0)
    yield _gauge("clock_offset_seconds", "How far the clock of the API is ahead of the database's.", value=apart)


def _counters(session: Session) -> Iterable[Metric]:
    counts = tally.read(session)
    for name, counted in COUNTED.items():
        found = {label: value for (of, label), value in counts.items() if of == name}
        labels = None if counted.label is None else [counted.label]
        family = CounterMetricFamily(PREFIX + counted.metric, counted.text, labels=labels)
        for label, value in (dict.fromkeys(counted.values, 0.0) | found).items():
            family.add_metric([label] if labels else [], value)
        yield family


def _gauge(
    name: str,
    text: str,
    label: str | None = None,
    values: Mapping[Any, float] | None = None,
    *,
    value: float | None = 0,
) -> Metric:
    family = GaugeMetricFamily(PREFIX + name, text, labels=None if label is None else [label])
    for of, each in ({"": value or 0.0} if values is None else values).items():
        family.add_metric([] if label is None else [of], float(each))
    return family
