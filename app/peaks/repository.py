"""Peaks in the database."""

from collections.abc import Sequence
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, String, cast, select
from sqlalchemy.orm import InstrumentedAttribute, Session

from app.db.models import CONDITIONS, Case, Peak, StudyCase
from app.pagination import Order, fetch_page
from app.peaks.schemas import COLUMNS, PeakFilters, PeakQuery

_COLUMNS: dict[str, InstrumentedAttribute[Any]] = {
    name: getattr(Case if name in CONDITIONS else Peak, name) for name in COLUMNS
}
_EQUAL = ("position", "slab", "irregularity", "spectrum", "wavelength_min_m", "wavelength_max_m", "wavelength_m")


def find_page(session: Session, query: PeakQuery, max_page_size: int) -> tuple[Sequence[Row[Any]], str | None]:
    """A page of peaks with the conditions of their cases, and the next page's cursor."""
    statement, order = ordered(query)
    return fetch_page(session, statement, query, order, max_page_size)


def ordered(filters: PeakFilters) -> tuple[Select[Any], Order]:
    """The peaks that pass the filters, with the conditions of their cases, and the order they are wanted in.

    What both tables hold is asked of the one whose index gives the order, so that the other is looked up for few rows
    only: of cases in the order of a condition, their peaks one after the other; or of peaks in their own.
    """
    name = filters.sort.removeprefix("-")
    by_case = name in CONDITIONS
    columns = (Case.id, Peak.id) if by_case else (Peak.id,)
    statement = (
        select(*(column.label(name) for name, column in _COLUMNS.items()))
        .join(Case, Case.id == Peak.case_id)
        .where(*_conditions(filters, Case if by_case else Peak))
    )
    if filters.quantity is not None:
        # For PostgreSQL the cast is nothing. It keeps SQLite from collecting all peaks of a quantity to sort them.
        quantity = cast(Peak.quantity, String) if by_case else Peak.quantity
        statement = statement.where(quantity == filters.quantity)
    return statement, Order((_COLUMNS[name], *columns), descending=filters.sort.startswith("-"))


def _conditions(filters: PeakFilters, table: type[Case] | type[Peak]) -> list[ColumnElement[bool]]:
    at_least = {table.speed_kmh: filters.speed_kmh_min, Peak.peak: filters.value_min}
    at_most = {table.speed_kmh: filters.speed_kmh_max, Peak.peak: filters.value_max}
    equal = {_COLUMNS[name]: getattr(filters, name) for name in _EQUAL} | {table.percentile: filters.percentile}
    conditions = [column == value for column, value in equal.items() if value is not None]
    conditions += [column >= value for column, value in at_least.items() if value is not None]
    conditions += [column <= value for column, value in at_most.items() if value is not None]
    if filters.study_id is not None:
        of_study = select(StudyCase.case_id).where(StudyCase.study_id == filters.study_id)
        conditions.append(Peak.case_id.in_(of_study))
    return conditions
