"""Peaks as files, made while they are sent: neither the service nor the database client ever holds all rows.

All rows come from one statement, so from one state of the database. If the database goes away, the answer breaks off
without its end, which every HTTP client notices.
"""

import csv
import io
from collections.abc import Iterator
from typing import Any

from sqlalchemy import Row

from app.access.caller import ANYBODY, Caller
from app.db.models import Case
from app.db.session import Database
from app.peaks import repository
from app.peaks.schemas import COLUMNS, PeakFilters

NAMES = (*COLUMNS, "case_digest")
ROWS_AT_ONCE = 5000


def rows(
    database: Database, filters: PeakFilters, caller: Caller = ANYBODY, at_once: int = ROWS_AT_ONCE
) -> Iterator[list[Row[Any]]]:
    """The peaks with the columns ``NAMES``, some at a time."""
    statement, order = repository.ordered(filters, caller)
    statement = statement.add_columns(Case.digest.label("case_digest")).execution_options(yield_per=at_once)
    with database.read() as session:
        for part in order.parts(statement):
            with session.execute(part) as found:
                for batch in found.partitions():
                    yield list(batch)


def as_csv(batches: Iterator[list[Row[Any]]]) -> Iterator[bytes]:
    """As CSV (RFC 4180) with a header; what does not apply is empty."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(NAMES)
    for batch in batches:
        writer.writerows(batch)
        yield text.getvalue().encode()
        text.seek(0)
        text.truncate()
    yield text.getvalue().encode()
