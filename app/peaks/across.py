"""Peaks of all quantities in the order of a statistic, merged from those of each.

Their values have different units, so such an order means little, and an index for it would cost every case that is
written down as much as one within the quantities, which serves here, too (docs/decisions/0007).
"""

from collections.abc import Sequence
from operator import ge, gt, le, lt
from typing import Any

from sqlalchemy import Row, Select
from sqlalchemy.orm import Session

from app.db.models import Peak
from app.pagination import Order


def first_of_all(
    session: Session, part: Select[Any], order: Order, count: int, quantities: Sequence[Row[Any]]
) -> list[int]:
    """Identifiers of so many peaks.

    Parameters
    ----------
    session : Session
    part : Select
        Identifiers and places of no more than ``count`` peaks, in order, whatever their quantity.
    order : Order
        By a statistic.
    count : int
    quantities : sequence of Row
        Names and the values that their peaks begin with.
    """
    statistic, beyond, not_beyond = order.columns[0], *((lt, ge) if order.descending else (gt, le))
    found: list[Any] = []
    for each in sorted(quantities, key=lambda row: float(row.begin), reverse=order.descending):
        of_quantity = part.where(Peak.quantity == each.name)
        if len(found) == count:
            last = found[-1][1]
            if beyond(each.begin, last):  # and so do those that follow
                break
            of_quantity = of_quantity.where(not_beyond(statistic, last))
        found += session.execute(of_quantity)
        found = sorted(found, key=lambda row: tuple(row[1:]), reverse=order.descending)[:count]
    return [row.id for row in found]
