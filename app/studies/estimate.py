"""What a study would take, told before it is created."""

from collections.abc import Iterable, Iterator
from typing import Any

from pydantic import BaseModel, Field
from sqlalchemy import Row, select
from sqlalchemy.orm import Session

from app.access.caller import ANYBODY, Caller
from app.cases.queue import UNFINISHED, batches, next_turn
from app.cases.repository import work
from app.context import Context
from app.db.models import Case as CaseRow
from app.db.models import History
from app.studies import forecast, loads, service
from app.studies.caveats import Caveat, caveats
from app.studies.schemas import FinishEstimate, StudyRequest
from solver.case import Case
from solver.version import SOLVER_VERSION


class EstimatedCases(BaseModel):
    """How many cases a study would have, and what is known of them already."""

    total: int
    computed: int = Field(description="Already computed.")
    failed: int = Field(description="Already tried in vain; they stay failed unless the study is retried.")
    in_flight: int = Field(description="Queued or running for another study.")
    new: int = Field(description="To be computed for this study.")


class CpuEstimate(BaseModel):
    """Processor time of the new cases, s."""

    expected_s: float
    least_s: float
    most_s: float
    basis: forecast.Basis = Field(
        description="From what it was told: computed cases of the same track, speed and numerics; any computed cases, "
        "by unknowns and steps; or a benchmark, where none was computed yet."
    )


class StudyEstimate(BaseModel):
    """What a study would take."""

    cases: EstimatedCases
    cpu: CpuEstimate
    queue_cpu_s: float = Field(description="Expected processor time of what is computed before the study's last case.")
    workers: int = Field(description="How many workers are there to compute.")
    finish: FinishEstimate | None = Field(description="Null when there is nothing to compute, or no worker.")
    warnings: list[Caveat]


def estimate(context: Context, request: StudyRequest, caller: Caller = ANYBODY) -> StudyEstimate:
    """What a study would take if it were created now. Nothing is stored.

    Raises
    ------
    Problem
        As creating it would.
    """
    cases = service.expand(context, request, caller)
    by_digest = {case.digest(): case for case in cases}
    with context.database.read() as session:
        known = {row.digest: row for row in _known(session, by_digest)}
        lacking = {
            d for d, row in known.items() if request.keep_history and row.state == "succeeded" and row.key is None
        }
        new = [d for d in by_digest if d in lacking or d not in known or known[d].state == "cancelled"]
        states = [row.state for digest, row in known.items() if digest not in lacking]
        counts = EstimatedCases(
            total=len(by_digest),
            computed=states.count("succeeded"),
            failed=states.count("failed"),
            in_flight=sum(states.count(state) for state in UNFINISHED),
            new=len(new),
        )
        own, basis = forecast.cpu_s(session, [_load(by_digest[digest]) for digest in new])
        end = next_turn(session, request.priority, caller.key_id) + len(by_digest)
        before, _ = forecast.cpu_s(session, loads.before_turn(session, request.priority, end))
        shared = [row.digest for row in known.values() if row.state == "queued" and _later(row, request.priority, end)]
        forward, _ = forecast.cpu_s(session, [_load(by_digest[digest]) for digest in shared])
        finish = forecast.finish(session, own + before + forward) if counts.new + counts.in_flight else None
        workers = forecast.count_workers(session)
    return StudyEstimate(
        cases=counts,
        cpu=CpuEstimate(expected_s=own.expected, least_s=own.least, most_s=own.most, basis=basis),
        queue_cpu_s=before.expected,
        workers=workers,
        finish=finish,
        warnings=caveats(cases, "preset" if isinstance(request.sweep, str) else request.sweep.kind),
    )


def _load(case: Case) -> loads.Load:
    return loads.Load(case.operator_key(), 1.0, work(case))


def _known(session: Session, digests: Iterable[str]) -> Iterator[Row[Any]]:
    columns: list[Any] = [CaseRow.digest, CaseRow.state, CaseRow.priority, CaseRow.turn, History.key]
    stored = select(*columns).outerjoin(History, History.case_id == CaseRow.id)
    for some in batches(digests):
        yield from session.execute(stored.where(CaseRow.digest.in_(some), CaseRow.solver_version == SOLVER_VERSION))


def _later(row: Row[Any], priority: int, turn: int) -> bool:
    """Whether a queued case does not come before a turn yet: the study would bring it forward."""
    return (-int(row.priority), int(row.turn)) >= (-priority, turn)
