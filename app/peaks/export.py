"""Peaks as files, made while they are sent: neither the service nor the database client ever holds all rows.

They are read part by part, each from one state of the database and behind where the part before ended, and while a
part is sent no connection is held: a client may take its time. What is stored or deleted meanwhile may be in the file
or not; all else is in it once. If the database goes away, the answer breaks off without its end, which every HTTP
client notices.
"""

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from app.access.caller import ANYBODY, Caller
from app.db.models import Case
from app.db.session import Database
from app.peaks import repository
from app.peaks.schemas import COLUMNS, PeakFilters

ROWS_AT_ONCE = 5000


@dataclass(frozen=True)
class Export:
    """Peaks that pass some filters.

    Attributes
    ----------
    names : tuple of str
        Of its columns; the last are paths of parameters.
    parts : iterator of list of tuple
        Its rows, some at a time.
    """

    names: tuple[str, ...]
    parts: Iterator[list[Sequence[Any]]]


def export(database: Database, filters: PeakFilters, caller: Caller = ANYBODY, at_once: int = ROWS_AT_ONCE) -> Export:
    """The peaks with the conditions and parameters of their cases, and their digests."""
    with database.read() as session:
        paths = repository.parameters(session, filters, caller)
    names = (*COLUMNS, "case_digest", *paths)
    more: list[Any] = [Case.digest, *repository.values(paths)]

    def parts() -> Iterator[list[Sequence[Any]]]:
        place = None
        while True:
            with database.read() as session:
                rows, place = repository.find_some(session, filters, caller, more, at_once, place)
            yield [row[: len(names)] for row in rows]
            if place is None:
                return

    return Export(names, parts())


def as_csv(export: Export) -> Iterator[bytes]:
    """As CSV (RFC 4180) with a header; what does not apply is empty."""
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(export.names)
    for rows in export.parts:
        writer.writerows(rows)
        yield text.getvalue().encode()
        text.seek(0)
        text.truncate()
