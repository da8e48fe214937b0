"""Peaks in the database."""

from collections.abc import Callable, Iterator, Sequence
from operator import eq, ge, le
from typing import Any

from sqlalchemy import ColumnElement, Row, Select, cast, select
from sqlalchemy.orm import InstrumentedAttribute, Session
from sqlalchemy.sql.operators import in_op

from app.access import visibility
from app.access.caller import Caller
from app.db.models import CONDITIONS, Case, Peak, StudyCase
from app.pagination import Order, fetch_page
from app.peaks.schemas import COLUMNS, PeakFilters, PeakQuery

Column = InstrumentedAttribute[Any]

_COLUMNS: dict[str, Column] = {name: getattr(Case if name in CONDITIONS else Peak, name) for name in COLUMNS} | {
    "case_id": Case.id
}
_EQUAL = (
    *("quantity", "position", "slab", "irregularity", "spectrum"),
    *("wavelength_min_m", "wavelength_max_m", "wavelength_m"),
)


def find_page(
    session: Session, query: PeakQuery, max_page_size: int, caller: Caller
) -> tuple[Sequence[Row[Any]], str | None]:
    """A page of peaks with the conditions of their cases, and the next page's cursor."""
    statement, order = ordered(query, caller)
    return fetch_page(session, statement, query, order, max_page_size)


def ordered(filters: PeakFilters, caller: Caller) -> tuple[Select[Any], Order]:
    """The peaks that pass the filters, of cases that the caller sees, with the conditions of their cases, and the order
    they are wanted in.

    What both tables hold is asked of the one whose index gives the order, so that the other is looked up for few rows
    only: of cases in the order of a condition, their peaks one after the other; or of peaks in their own.
    """
    column = _COLUMNS[filters.sort.removeprefix("-")]
    by_case = column.class_ is Case
    case_id = _without_index(Case.id) if by_case else Case.id
    statement = select(*(each.label(name) for name, each in _COLUMNS.items())).join(Case, case_id == Peak.case_id)
    for tested, compare, value in _conditions(filters, Case if by_case else Peak):
        if value is not None:
            plain = not by_case or tested is column
            statement = statement.where(compare(tested if plain else _without_index(tested), value))
    statement = statement.where(*visibility.cases(caller, Case.id if by_case else Peak.case_id))
    columns = (column, Case.id, Peak.id) if by_case else (column, Peak.id)
    return statement, Order(tuple(dict.fromkeys(columns)), descending=filters.sort.startswith("-"))


def _without_index(column: Column) -> ColumnElement[Any]:
    """To PostgreSQL, the column. SQLite has no index for a cast: it then reads cases in order and looks up their peaks,
    rather than collect and sort all peaks of a quantity or all cases of a slab.
    """
    return cast(column, column.type)


def _conditions(
    filters: PeakFilters, table: type[Case] | type[Peak]
) -> Iterator[tuple[Column, Callable[[Any, Any], ColumnElement[bool]], Any]]:
    """What is tested, how, and against what."""
    for name in _EQUAL:
        yield _COLUMNS[name], eq, getattr(filters, name)
    yield table.percentile, eq, filters.percentile
    yield table.speed_kmh, ge, filters.speed_kmh_min
    yield table.speed_kmh, le, filters.speed_kmh_max
    yield Peak.peak, ge, filters.value_min
    yield Peak.peak, le, filters.value_max
    if filters.study_id is not None:
        of_study = select(StudyCase.case_id).where(StudyCase.study_id == filters.study_id)
        yield (Case.id if table is Case else Peak.case_id), in_op, of_study
