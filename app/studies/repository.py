"""Studies in the database. A study's state is derived here, from its cases, and nowhere else."""

from collections.abc import Sequence
from typing import Any, get_args

from sqlalchemy import ColumnElement, Row, Select, and_, bindparam, case, func, or_, select
from sqlalchemy.orm import Session, defer

from app.db.models import ApiKey, Case, CaseState, Study, StudyCase
from app.pagination import Order, fetch_page
from app.studies.schemas import StudyQuery

ORDERS = {"created_at": Study.created_at, "name": Study.name, "priority": Study.priority}


def overview(*of: ColumnElement[bool]) -> Select[Any]:
    """Studies with ``total``, a count per case state, ``progress``, ``state`` and ``owner``.

    Parameters
    ----------
    *of
        Conditions on ``StudyCase.study_id``: whose cases are counted.
    """
    done = case((Case.state == "running", Case.progress), (Case.state == "queued", 0.0), else_=1.0)
    tally = (
        select(
            StudyCase.study_id,
            func.count().label("total"),
            *(func.count().filter(Case.state == state).label(state) for state in get_args(CaseState)),
            func.avg(done).label("progress"),
        )
        .join(Case, Case.id == StudyCase.case_id)
        .where(*of)
        .group_by(StudyCase.study_id)
        .subquery()
    )
    n = tally.c
    unfinished = n.queued + n.running > 0
    state = case(
        (Study.cancel_requested_at.is_not(None), "cancelled"),
        (and_(unfinished, or_(n.running > 0, Study.started_at.is_not(None))), "running"),
        (unfinished, "queued"),
        (n.succeeded == n.total, "succeeded"),
        (n.succeeded > 0, "partially_failed"),
        else_="failed",
    )
    columns = [column for column in n if column.name != "study_id"]
    owner = select(ApiKey.name).where(ApiKey.id == Study.owner_id).scalar_subquery()
    return select(Study, *columns, state.label("state"), owner.label("owner")).join(tally, n.study_id == Study.id)


# Put together once: that takes longer than the database takes to answer.
_ONE = overview(StudyCase.study_id == bindparam("study_id"))
_PAGE = overview(StudyCase.study_id.in_(bindparam("ids", expanding=True))).options(defer(Study.request))  # large ones


def find(session: Session, study_id: str) -> Row[Any] | None:
    """The overview of one study."""
    return session.execute(_ONE, {"study_id": study_id}).one_or_none()


def state(session: Session, study_id: str) -> str:
    """The state of a study that is there."""
    return str(session.execute(_ONE, {"study_id": study_id}).one().state)


def find_page(
    session: Session, query: StudyQuery, max_page_size: int, *visible: ColumnElement[bool]
) -> tuple[Sequence[Row[Any]], str | None]:
    """The overviews of a page of visible studies, and the next page's cursor."""
    chosen = select(Study.id).where(*visible)
    if query.created_after is not None:
        chosen = chosen.where(Study.created_at > query.created_after.timestamp())
    if query.name is not None:
        chosen = chosen.where(Study.name.icontains(query.name, autoescape=True))
    if query.state is not None:
        derived = overview().subquery()
        chosen = chosen.where(Study.id.in_(select(derived.c.id).where(derived.c.state == query.state)))
    order = Order((ORDERS[query.sort.removeprefix("-")], Study.id), descending=query.sort.startswith("-"))
    keys, cursor = fetch_page(session, chosen, query, order, max_page_size)
    ids = [key.id for key in keys]
    rows = {row.Study.id: row for row in session.execute(_PAGE, {"ids": ids})}
    return [rows[study_id] for study_id in ids], cursor
