"""Peaks in the database."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import ColumnElement, Row, select
from sqlalchemy.orm import Session

from app.db.models import Case, Peak, StudyCase
from app.pagination import Order, fetch_page
from app.peaks.schemas import COLUMNS, PeakFilters

_COLUMNS = {name: getattr(Peak if hasattr(Peak, name) else Case, name) for name in COLUMNS}
_EQUAL = (
    *("quantity", "position", "slab", "irregularity", "spectrum", "percentile"),
    *("wavelength_min_m", "wavelength_max_m", "wavelength_m"),
)


def find_page(session: Session, filters: PeakFilters, max_page_size: int) -> tuple[Sequence[Row[Any]], str | None]:
    """A page of peaks with the conditions of their cases, and the next page's cursor."""
    columns = [column.label(name) for name, column in _COLUMNS.items()]
    statement = select(*columns).join(Case, Case.id == Peak.case_id).where(*_conditions(filters))
    order = Order(_COLUMNS[filters.sort.removeprefix("-")], Peak.id, descending=filters.sort.startswith("-"))
    return fetch_page(session, statement, filters, order, max_page_size)


def _conditions(filters: PeakFilters) -> list[ColumnElement[bool]]:
    at_least = {Case.speed_kmh: filters.speed_kmh_min, Peak.peak: filters.value_min}
    at_most = {Case.speed_kmh: filters.speed_kmh_max, Peak.peak: filters.value_max}
    conditions = [_COLUMNS[name] == value for name in _EQUAL if (value := getattr(filters, name)) is not None]
    conditions += [column >= value for column, value in at_least.items() if value is not None]
    conditions += [column <= value for column, value in at_most.items() if value is not None]
    if filters.study_id is not None:
        of_study = select(StudyCase.case_id).where(StudyCase.study_id == filters.study_id)
        conditions.append(Peak.case_id.in_(of_study))
    return conditions
