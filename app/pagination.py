"""Pages by keyset: a cursor says after which row the next page starts, and for which question."""

import hashlib
import json
import math
from base64 import urlsafe_b64decode, urlsafe_b64encode
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel, ConfigDict, Field
from sqlalchemy import ColumnElement, Row, Select, tuple_
from sqlalchemy.orm import InstrumentedAttribute, Session

from app.problems import invalid

DEFAULT_PAGE_SIZE = 100


class PageQuery(BaseModel):
    """Query parameters of every list. Those a subclass adds are filters."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False)

    page_size: int | None = Field(default=None, ge=1, description=f"Rows per page; {DEFAULT_PAGE_SIZE} if not given.")
    cursor: str | None = Field(default=None, max_length=2000, description="`next_cursor` of the page before.")

    def question(self) -> str:
        """Digest of the filters and the order: a cursor serves no other."""
        rest = self.model_dump_json(exclude={"page_size", "cursor"})
        return hashlib.sha256(rest.encode()).hexdigest()[:16]


@dataclass(frozen=True)
class Order:
    """By several columns in one direction, the last of them unique. Rows without the first come last in either.

    It is two queries, one for the rows that have the first column and one for the others: each reads an index from
    where the page before ended, which no database does for both at once.
    """

    columns: tuple[InstrumentedAttribute[Any], ...]
    descending: bool = False

    def parts(self, statement: Select[Any], after: Sequence[Any] | None = None) -> Iterator[Select[Any]]:
        """The rows of a statement in order, part by part, behind the row that has these values."""
        first, *rest = self.columns
        ordered = statement.order_by(*self.by(self.columns))
        if not self._nullable:
            yield ordered.where(*self._beyond(self.columns, after))
            return
        if after is None or after[0] is not None:
            yield ordered.where(first.is_not(None), *self._beyond(self.columns, after))
            after = None
        yield ordered.where(first.is_(None), *self._beyond(rest, after and after[1:]))

    def by(self, columns: Iterable[Any]) -> list[ColumnElement[Any]]:
        """These columns in the direction of the order."""
        return [column.desc() if self.descending else column.asc() for column in columns]

    def _beyond(
        self, columns: Sequence[InstrumentedAttribute[Any]], values: Sequence[Any] | None
    ) -> list[ColumnElement[bool]]:
        if values is None:
            return []
        here, there = tuple_(*columns), tuple(values)
        beyond = [here < there if self.descending else here > there]
        of_one = [column for column in columns if column.class_ is columns[0].class_]
        if len(of_one) < len(columns):  # said once more for an index, which is of one table
            here, there = tuple_(*of_one), there[: len(of_one)]
            beyond.append(here <= there if self.descending else here >= there)
        return beyond

    @property
    def _nullable(self) -> bool:
        return bool(self.columns[0].property.columns[0].nullable)

    def accepts(self, values: object) -> bool:
        """Whether a cursor's values can be compared with the columns."""
        if not isinstance(values, list) or len(values) != len(self.columns):
            return False
        first_fits = (values[0] is None and self._nullable) or _fits(self.columns[0], values[0])
        return first_fits and all(map(_fits, self.columns[1:], values[1:]))


Tell = Callable[[Select[Any], Order, int], Select[Any]]


def _fits(column: InstrumentedAttribute[Any], value: object) -> bool:
    kind = column.type.python_type
    if kind is int:
        return type(value) is int and abs(value) < 2**63
    if kind is float:
        return type(value) in (int, float) and math.isfinite(value)  # type: ignore[arg-type]  # narrowed by type()
    return isinstance(value, str) and "\0" not in value


def encode_cursor(question: str, values: Sequence[Any]) -> str:
    """An opaque cursor."""
    return urlsafe_b64encode(json.dumps([question, *values], separators=(",", ":")).encode()).decode()


def decode_cursor(cursor: str, question: str) -> list[Any]:
    """Values of a cursor.

    Raises
    ------
    Problem
        422 if it is not one of ours, or of another question.
    """
    try:
        asked, *values = json.loads(urlsafe_b64decode(cursor.encode()))
    except (ValueError, TypeError, RecursionError):
        raise invalid("/query/cursor", "cursor-unreadable", "The cursor is not one that a page gave.") from None
    if asked != question:
        raise invalid("/query/cursor", "cursor-of-other-query", "The cursor belongs to other filters or order.")
    return values


def fetch_page(
    session: Session,
    statement: Select[Any],
    query: PageQuery,
    order: Order,
    max_page_size: int,
    told: Tell = lambda part, *_: part,
) -> tuple[Sequence[Row[Any]], str | None]:
    """The rows of a filtered statement that fall on one page, and the cursor of the next page if there are more.

    For ``told`` see :func:`fetch`.

    Raises
    ------
    Problem
        422 for a page size above the limit or a cursor that does not fit.
    """
    page_size = query.page_size or min(DEFAULT_PAGE_SIZE, max_page_size)
    if page_size > max_page_size:
        raise invalid("/query/page_size", "page-size-over-limit", f"A page holds at most {max_page_size} rows.")
    question, after = query.question(), None
    if query.cursor is not None:
        after = decode_cursor(query.cursor, question)
        if not order.accepts(after):
            raise invalid("/query/cursor", "cursor-unreadable", "The cursor is not one that a page gave.")
    rows, place = fetch(session, statement, order, page_size, after, told)
    return rows, None if place is None else encode_cursor(question, place)


def fetch(
    session: Session,
    statement: Select[Any],
    order: Order,
    count: int,
    after: Sequence[Any] | None,
    told: Tell,
) -> tuple[Sequence[Row[Any]], Sequence[Any] | None]:
    """So many rows of a statement behind a place in an order, and the place of the last if there are more.

    Parameters
    ----------
    session : Session
    statement : Select
    order : Order
    count : int
    after : sequence, optional
        The place.
    told : callable
        Makes of a statement for some rows, which end in their places, the one for what is wanted of them, in the same
        order and with the same end. It is given the order, and how many rows there are at most, too.
    """
    places = [column.label(f"place_{n}") for n, column in enumerate(order.columns)]
    rows: list[Row[Any]] = []
    for part in order.parts(statement.add_columns(*places), after):
        if missing := count + 1 - len(rows):
            rows += session.execute(told(part.limit(missing), order, missing)).all()
    return rows[:count], rows[count - 1][-len(places) :] if len(rows) > count else None
