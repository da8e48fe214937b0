"""Peaks in the database."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, select
from sqlalchemy.orm import Session

from app.access import visibility
from app.access.caller import Caller
from app.db.models import Case, Peak, Study
from app.pagination import Order, Tell, fetch, fetch_page
from app.peaks.across import first_of_all
from app.peaks.plan import COLUMNS, Plan, plan
from app.peaks.schemas import PeakFilters, PeakQuery
from app.problems import not_found
from app.studies.sweep.vary import PARAMETERS
from app.studies.varying import varied_paths

Place = Sequence[Any]


def find_page(
    session: Session, query: PeakQuery, max_page_size: int, caller: Caller
) -> tuple[list[dict[str, Any]], str | None]:
    """A page of peaks with the conditions and parameters of their cases, and the next page's cursor."""
    paths = parameters(session, query, caller)
    found = plan(session, query, caller)
    told = _telling(session, found, values(paths))
    rows, cursor = fetch_page(session, found.statement, query, found.order, max_page_size, told)
    begin, end = len(COLUMNS), len(COLUMNS) + len(paths)
    return [
        dict(zip(COLUMNS, row[:begin], strict=True)) | {"parameters": dict(zip(paths, row[begin:end], strict=True))}
        for row in rows
    ], cursor


def of_case(session: Session, case_id: int) -> Sequence[Peak]:
    """All peaks of a case.

    Raises
    ------
    Problem
        404 if there is no such case.
    """
    if session.scalar(select(Case.id).where(Case.id == case_id)) is None:
        raise not_found("case")
    return session.scalars(select(Peak).where(Peak.case_id == case_id).order_by(Peak.id)).all()


def find_some(
    session: Session,
    filters: PeakFilters,
    caller: Caller,
    more: Sequence[ColumnElement[Any]],
    count: int,
    after: Place | None,
) -> tuple[Sequence[Row[Any]], Place | None]:
    """So many peaks behind a place, with more of their cases, and the place of the last if there are others.

    The columns of the rows are followed by their places.
    """
    found = plan(session, filters, caller)
    return fetch(session, found.statement, found.order, count, after, _telling(session, found, more))


def _telling(session: Session, found: Plan, more: Sequence[ColumnElement[Any]]) -> Tell:
    def told(part: Select[Any], order: Order, count: int) -> Select[Any]:
        if found.quantities is not None:
            ids = first_of_all(session, part, order, count, found.quantities)
            part = select(*part.selected_columns).where(Peak.id.in_(ids))
        keys = part.subquery()
        places = [column for column in keys.c if column.name != Peak.id.name]
        wanted = select(*COLUMNS.values(), *more, *places).join(keys, keys.c.id == Peak.id)
        return wanted.join(Case, Case.id == Peak.case_id).order_by(*order.by(places))

    return told


def parameters(session: Session, filters: PeakFilters, caller: Caller) -> list[str]:
    """Paths of the parameters that are asked for or, if none is, that the study of the filters varies."""
    if filters.parameter or filters.study_id is None:
        return list(dict.fromkeys(filters.parameter))
    study = select(Study.request).where(Study.id == filters.study_id, *visibility.studies(caller))
    request = session.scalar(study)
    return [] if request is None else varied_paths(request)


def values(paths: Sequence[str]) -> list[ColumnElement[Any]]:
    """Parameters in the inputs of a case."""
    found = []
    for path in paths:
        value = Case.inputs[PARAMETERS[path].inside]
        found.append(value.as_integer() if PARAMETERS[path].type is int else value.as_float())
    return found
