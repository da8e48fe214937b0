"""How the peaks that pass the filters are found in the order that is wanted: see docs/decisions/0007.

Filters that must not choose the index are put on a cast, and sets are asked whether that they hold something IS TRUE.
SQLite has no index for either, and PostgreSQL looks into such a set instead of joining it.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from operator import eq, ge, le
from typing import Any

from sqlalchemy import CTE, ColumnElement, Row, Select, cast, exists, func, literal, select
from sqlalchemy.orm import InstrumentedAttribute, Session, aliased

from app.access import visibility
from app.access.caller import Caller
from app.db.models import CONDITIONS, STATISTICS, Case, Peak, StudyCase
from app.pagination import Order
from app.peaks.schemas import COLUMNS as NAMES
from app.peaks.schemas import PeakFilters

# So many are sooner read and sorted than met with in an order:
FEW_CASES = 200
FEW_PEAKS = 5_000  # each with its case
FEW_ENTRIES = 100_000  # of an index that holds all that is asked

Column = InstrumentedAttribute[Any]
Conditions = list[ColumnElement[bool]]

COLUMNS: dict[str, Column] = {name: getattr(Case if name in CONDITIONS else Peak, name) for name in NAMES} | {
    "case_id": Case.id
}
OF_CASES = ("slab", "irregularity", "spectrum", "wavelength_min_m", "wavelength_max_m", "wavelength_m")
WITHIN_QUANTITIES = set(STATISTICS) - {Peak.peak.key}  # that have no index across quantities
BESIDE = {Case.speed_kmh: Peak.speed_kmh, Case.percentile: Peak.percentile}  # what peaks hold of their cases, too


@dataclass(frozen=True)
class Plan:
    """Identifiers of the peaks that pass, of cases that the caller sees, and the order they are wanted in.

    Attributes
    ----------
    statement : Select
    order : Order
    quantities : sequence of Row, optional
        Quantities that come into question, with the value that each begins with, if their peaks are in that order one
        quantity at a time only.
    """

    statement: Select[Any]
    order: Order
    quantities: Sequence[Row[Any]] | None = None


def plan(session: Session, filters: PeakFilters, caller: Caller) -> Plan:
    """How peaks are found."""
    column, descending = COLUMNS[filters.sort.removeprefix("-")], filters.sort.startswith("-")
    if column is Peak.unit and filters.quantity is not None:
        column = Peak.quantity  # all of which have one unit
    order = Order(_places(column), descending)
    of_cases, beside = _of_cases(filters, caller), _beside(Case, filters)
    passing = select(Case.id).where(*of_cases, *beside)
    if of_cases or beside:
        few = session.scalars(passing.limit(FEW_CASES + 1)).all()
        if len(few) <= FEW_CASES:
            return Plan(_case_by_case(filters).where(Case.id.in_(few)), order)
    within = _within(Case.id, passing) if of_cases or beside else []
    if column.key not in STATISTICS and (filters.value_min is not None or filters.value_max is not None):
        valued = select(Peak.id).where(*_of_peaks(filters, Peak.quantity, Peak.peak))
        size = session.scalar(select(func.count()).select_from(valued.limit(FEW_ENTRIES + 1).subquery())) or 0
        if column in BESIDE and size <= FEW_ENTRIES:
            places = BESIDE[column], Peak.case_id, Peak.id
            return Plan(_in_order(Peak.peak, filters, of_cases), Order(places, descending))
        if size <= FEW_PEAKS:
            found = select(Peak.id).join(Case, Case.id == _unindexed(Peak.case_id))
            return Plan(found.where(Peak.id.in_(valued), *_of_peaks(filters), *within), order)
    if column.class_ is Case:
        return Plan(_case_by_case(filters).where(*within), order)
    found = _in_order(column, filters, of_cases)
    if column.key in WITHIN_QUANTITIES and filters.quantity is None:
        return Plan(found, order, session.execute(_begins(column, filters, descending)).all())
    return Plan(found.where(*_begin(column, filters, descending)), order)


def _places(column: Column) -> tuple[Column, ...]:
    """The column and what distinguishes rows that are equal in it, as some index has them."""
    columns = (column, Case.id, Peak.id) if column.class_ is Case else (column, Peak.id)
    return (column, Peak.position, Peak.id) if column is Peak.quantity else tuple(dict.fromkeys(columns))


def _case_by_case(filters: PeakFilters) -> Select[Any]:
    """Peaks of one case after the other; of no case, if there is none of the quantity at the position."""
    found = select(Peak.id).join(Case, _unindexed(Case.id) == Peak.case_id).where(*_of_peaks(filters))
    any_peak = aliased(Peak)
    names = (any_peak.quantity, eq, filters.quantity), (any_peak.position, eq, filters.position)
    return found.where(exists(select(any_peak.id).where(*_where(names)).correlate(None)))


def _in_order(column: Column, filters: PeakFilters, of_cases: Conditions) -> Select[Any]:
    """Peaks in the order of an index that holds this column and most of what is asked."""
    found = select(Peak.id).where(*_of_peaks(filters, Peak.quantity, column), *_beside(Peak, filters))
    return found.where(*(_within(Peak.case_id, select(Case.id).where(*of_cases)) if of_cases else []))


def _begin(column: Column, filters: PeakFilters, descending: bool) -> Conditions:
    """Where to begin in the order of a column: at the first value that a quantity has which comes into question.

    Quantities have values of very different size. Those of the only ones that occur at a position, or reach a value,
    may lie behind those of all others.
    """
    if column is Peak.unit or not _asked(filters):
        return []
    begins = _begins(column, filters, descending).subquery()
    begin = select((func.max if descending else func.min)(begins.c.begin)).scalar_subquery()
    return [(le if descending else ge)(column, begin)]


def _begins(column: Column, filters: PeakFilters, descending: bool) -> Select[Any]:
    """Quantities that come into question, each with the value that it begins with in the order of a column."""
    quantities, extreme = _quantities(filters), func.max if descending else func.min
    of_quantity = Peak.quantity == quantities.c.name
    first = select(extreme(column)).where(of_quantity).correlate(quantities).scalar_subquery()
    some = exists().where(of_quantity, *_asked(filters)).correlate(quantities)
    return select(quantities.c.name, first.label("begin")).where(some)


def _asked(filters: PeakFilters) -> Conditions:
    """What is asked of peaks, but for the quantity."""
    return _of_peaks(filters, Peak.position, Peak.peak, but=Peak.quantity)


def _quantities(filters: PeakFilters) -> CTE:
    """The quantity asked for or, from one to the next in an index, all that there are."""
    if filters.quantity is not None:
        return select(literal(filters.quantity).label("name")).cte("quantities")
    found = select(func.min(Peak.quantity).label("name")).cte("quantities", recursive=True)
    following = select(func.min(Peak.quantity)).where(Peak.quantity > found.c.name).scalar_subquery()
    return found.union_all(select(following).where(found.c.name.is_not(None)))


def _of_cases(filters: PeakFilters, caller: Caller) -> Conditions:
    """What is asked of cases, but for what peaks hold too."""
    conditions = _where((COLUMNS[name], eq, getattr(filters, name)) for name in OF_CASES)
    if filters.study_id is not None:
        conditions.append(Case.id.in_(select(StudyCase.case_id).where(StudyCase.study_id == filters.study_id)))
    if not caller.is_admin:
        conditions.append(Case.id.in_(visibility.case_ids(caller)))
    return conditions


def _beside(table: type[Case] | type[Peak], filters: PeakFilters) -> Conditions:
    speed = table.speed_kmh
    tests = (speed, ge, filters.speed_kmh_min), (speed, le, filters.speed_kmh_max)
    return _where((*tests, (table.percentile, eq, filters.percentile)))


def _of_peaks(filters: PeakFilters, *by_index: Column, but: Column | None = None) -> Conditions:
    """What is asked of peaks themselves."""
    tests = (
        (Peak.quantity, eq, filters.quantity),
        (Peak.position, eq, filters.position),
        (Peak.peak, ge, filters.value_min),
        (Peak.peak, le, filters.value_max),
    )
    asked = (test for test in tests if test[0] is not but)
    return _where((c if c in by_index else _unindexed(c), compare, value) for c, compare, value in asked)


def _where(tests: Iterable[tuple[Any, Callable[[Any, Any], Any], Any]]) -> Conditions:
    return [compare(column, value) for column, compare, value in tests if value is not None]


def _within(column: Column, ids: Select[Any]) -> Conditions:
    return [column.in_(ids).is_(True)]


def _unindexed(column: Column) -> ColumnElement[Any]:
    return cast(column, column.type)
