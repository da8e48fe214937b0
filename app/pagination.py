"""Pages by keyset: a cursor says after which row the next page starts, and for which question."""

import hashlib
import json
import math
from base64 import urlsafe_b64decode, urlsafe_b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import BaseModel, ConfigDict, Field
from sqlalchemy import ColumnElement, Row, Select, and_, false, or_
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
    """By one column, then by a unique key. Missing values come last, in either direction."""

    column: InstrumentedAttribute[Any]
    key: InstrumentedAttribute[Any]
    descending: bool = False

    def clauses(self) -> list[ColumnElement[Any]]:
        """For ORDER BY."""
        missing_last = [self.column.is_(None)] if self._nullable else []
        return [*missing_last, *(c.desc() if self.descending else c.asc() for c in (self.column, self.key))]

    def after(self, value: Any, key: Any) -> ColumnElement[bool]:
        """For WHERE: the rows after the one with these values."""
        column = self.column
        further_key = self.key < key if self.descending else self.key > key
        if value is None:
            return and_(column.is_(None), further_key)
        further = column < value if self.descending else column > value
        missing = column.is_(None) if self._nullable else false()
        return or_(further, and_(column == value, further_key), missing)

    @property
    def _nullable(self) -> bool:
        return bool(self.column.property.columns[0].nullable)

    def accepts(self, value: object, key: object) -> bool:
        """Whether a cursor's values can be compared with the columns."""
        return ((value is None and self._nullable) or _fits(self.column, value)) and _fits(self.key, key)


def _fits(column: InstrumentedAttribute[Any], value: object) -> bool:
    kind = column.type.python_type
    if kind is int:
        return type(value) is int and abs(value) < 2**63
    if kind is float:
        return type(value) in (int, float) and math.isfinite(value)  # type: ignore[arg-type]  # narrowed by type()
    return isinstance(value, str) and "\0" not in value


def encode_cursor(question: str, value: object, key: object) -> str:
    """An opaque cursor."""
    return urlsafe_b64encode(json.dumps([question, value, key], separators=(",", ":")).encode()).decode()


def decode_cursor(cursor: str, question: str) -> tuple[Any, Any]:
    """Value and key of a cursor.

    Raises
    ------
    Problem
        422 if it is not one of ours, or of another question.
    """
    try:
        asked, value, key = json.loads(urlsafe_b64decode(cursor.encode()))
    except (ValueError, TypeError, RecursionError):
        raise invalid("/query/cursor", "cursor-unreadable", "The cursor is not one that a page gave.") from None
    if asked != question:
        raise invalid("/query/cursor", "cursor-of-other-query", "The cursor belongs to other filters or order.")
    return value, key


def fetch_page(
    session: Session, statement: Select[Any], query: PageQuery, order: Order, max_page_size: int
) -> tuple[Sequence[Row[Any]], str | None]:
    """The rows of a filtered statement that fall on one page, and the cursor of the next page if there are more.

    Raises
    ------
    Problem
        422 for a page size above the limit or a cursor that does not fit.
    """
    page_size = query.page_size or min(DEFAULT_PAGE_SIZE, max_page_size)
    if page_size > max_page_size:
        raise invalid("/query/page_size", "page-size-over-limit", f"A page holds at most {max_page_size} rows.")
    question = query.question()
    if query.cursor is not None:
        value, key = decode_cursor(query.cursor, question)
        if not order.accepts(value, key):
            raise invalid("/query/cursor", "cursor-unreadable", "The cursor is not one that a page gave.")
        statement = statement.where(order.after(value, key))
    statement = statement.add_columns(order.column.label("sort_value"), order.key.label("sort_key"))
    rows = session.execute(statement.order_by(*order.clauses()).limit(page_size + 1)).all()
    if len(rows) <= page_size:
        return rows, None
    last = rows[page_size - 1]
    return rows[:page_size], encode_cursor(question, last.sort_value, last.sort_key)
