"""What the queue holds before a study is done: unknowns times time steps, by operator.

The statements are put together once: that takes longer than the database takes to answer.
"""

from typing import Any, NamedTuple

from sqlalchemy import ColumnElement, Select, and_, bindparam, case, func, or_, select
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


def _loads(session: Session, statement: Select[Any], **values: Any) -> list[Load]:
    return [Load(*row) for row in session.execute(statement, values)]


def _unfinished() -> Any:
    rest = case((Case.state == "running", 1 - Case.progress), else_=1.0)
    work = func.coalesce(Case.work, TYPICAL_WORK)
    columns = Case.operator_key, func.sum(rest).label("cases"), func.sum(rest * work).label("work")
    return select(*columns).where(Case.state.in_(UNFINISHED)).group_by(Case.operator_key)


def _comes_before(priority: Any, turn: Any) -> ColumnElement[bool]:
    """Whether a case is claimed before those of a turn."""
    sooner = or_(Case.priority > priority, and_(Case.priority == priority, Case.turn < turn))
    return or_(Case.state == "running", and_(Case.state == "queued", sooner))


_STUDY_ID: Any = bindparam("study_id")
_PRIORITY: Any = bindparam("priority")
_TURN: Any = bindparam("turn")
_OWN = select(StudyCase.case_id).where(StudyCase.study_id == _STUDY_ID)
_LEFT = _unfinished().join(StudyCase, StudyCase.case_id == Case.id).where(StudyCase.study_id == _STUDY_ID)
_BEFORE = _unfinished().where(_comes_before(_PRIORITY, _TURN))
_AHEAD = _BEFORE.where(Case.id.not_in(_OWN))
_LAST_TURN = select(func.max(Case.turn)).where(Case.id.in_(_OWN), Case.state == "queued", Case.priority == _PRIORITY)
