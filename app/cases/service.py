"""What can be known of cases."""

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.cases.schemas import case_file
from app.cases.views import CASE_ORDERS, CaseDetail, CasePage, CaseQuery, CaseSummary, StoredHistory
from app.db.models import Case, History, Study, StudyCase
from app.pagination import Order, fetch_page
from app.problems import not_found

ORDERS = {name: getattr(StudyCase if name == "position" else Case, name) for name in CASE_ORDERS}
SUMMARY = [getattr(Case, name) for name in CaseSummary.model_fields]  # without the inputs, of which a page has many


def list_page(session: Session, study_id: str, query: CaseQuery, max_page_size: int) -> CasePage:
    """A page of a study's cases.

    Raises
    ------
    Problem
        404 if there is no such study.
    """
    if session.scalar(select(Study.id).where(Study.id == study_id)) is None:
        raise not_found("study")
    statement = select(*SUMMARY).join(StudyCase, StudyCase.case_id == Case.id).where(StudyCase.study_id == study_id)
    for name in ("state", "slab", "irregularity", "percentile"):
        if (value := getattr(query, name)) is not None:
            statement = statement.where(getattr(Case, name) == value)
    if query.speed_kmh_min is not None:
        statement = statement.where(Case.speed_kmh >= query.speed_kmh_min)
    if query.speed_kmh_max is not None:
        statement = statement.where(Case.speed_kmh <= query.speed_kmh_max)
    order = Order((ORDERS[query.sort.removeprefix("-")], Case.id), descending=query.sort.startswith("-"))
    rows, cursor = fetch_page(session, statement, query, order, max_page_size)
    return CasePage(items=[CaseSummary.model_validate(row) for row in rows], next_cursor=cursor)


def get(session: Session, case_id: int) -> CaseDetail:
    """One case.

    Raises
    ------
    Problem
        404 if there is none.
    """
    case = session.get(Case, case_id)
    if case is None:
        raise not_found("case")
    history = session.get(History, case_id)
    summary = CaseSummary.model_validate(case)
    stored = None if history is None else StoredHistory.model_validate(history)
    inputs = case_file(case.inputs)
    return CaseDetail(**dict(summary), inputs=inputs, processing=case.processing, history=stored)
