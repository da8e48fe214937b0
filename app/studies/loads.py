"""What the queue holds before a study is done: unknowns times time steps, by operator.

The statements are put together once: that takes longer than the database takes to answer.
"""

from typing import Any, NamedTuple

from sqlalchemy import (
    ColumnElement,
    CompoundSelect,
    Executable,
    Select,
    and_,
    bindparam,
    case,
    func,
    or_,
    select,
    union_all,
)
from sqlalchemy.orm import Session

from app.cases.queue import UNFINISHED
from app.db.models import Case, Study, StudyCase

TYPICAL_WORK = 6e8  # of a case stored before its work was: default numerics


class Load(NamedTuple):
    """Cases of one operator that are to come, and their unknowns times steps. Of running ones, what is left."""

    operator: str
    cases: float
    work: float


def left(session: Session, study_id: str) -> list[Load]:
    """What is left of a study."""
    return _loads(session, _LEFT, study_id=study_id)


def ahead(session: Session, study: Study) -> list[Load]:
    """What others have running, or in the queue before the last case of a study."""
    own = {"study_id": study.id, "priority": study.priority}
    return _loads(session, _AHEAD, **own, turn=session.scalar(_LAST_TURN, own) or 0)


def before_turn(session: Session, priority: int, turn: int) -> list[Load]:
    """What is running, or in the queue before a turn."""
    return _loads(session, _BEFORE, priority=priority, turn=turn)


def _loads(session: Session, statement: Executable, **values: Any) -> list[Load]:
    return [Load(*row) for row in session.execute(statement, values)]


_STUDY_ID: Any = bindparam("study_id")
_PRIORITY: Any = bindparam("priority")
_TURN: Any = bindparam("turn")
_OWN = select(StudyCase.case_id).where(StudyCase.study_id == _STUDY_ID)
_WORK = func.coalesce(Case.work, TYPICAL_WORK)


def _sums(cases: Any, work: Any, *of: ColumnElement[bool]) -> Any:
    return select(Case.operator_key, cases, work).where(*of).group_by(Case.operator_key)


def _before(*of: ColumnElement[bool]) -> CompoundSelect[Any]:
    """What is claimed before those of a turn. Of queued cases an index knows all that is asked."""
    rest = 1 - Case.progress
    sooner = or_(Case.priority > _PRIORITY, and_(Case.priority == _PRIORITY, Case.turn < _TURN))
    running = _sums(func.sum(rest), func.sum(rest * _WORK), Case.state == "running", *of)
    queued = _sums(func.count(), func.sum(_WORK), Case.state == "queued", sooner, *of)
    return union_all(running, queued)


def _left() -> Select[Any]:
    rest = case((Case.state == "running", 1 - Case.progress), else_=1.0)
    own = StudyCase.study_id == _STUDY_ID, Case.state.in_(UNFINISHED)
    return _sums(func.sum(rest), func.sum(rest * _WORK), *own).join(StudyCase, StudyCase.case_id == Case.id)


_LEFT = _left()
_BEFORE = _before()
_AHEAD = _before(Case.id.not_in(_OWN))
_LAST_TURN = select(func.max(Case.turn)).where(Case.id.in_(_OWN), Case.state == "queued", Case.priority == _PRIORITY)
