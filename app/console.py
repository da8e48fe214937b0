"""What people read on a terminal: tables with units, progress, and problems as field and bound."""

import math
import sys
from collections.abc import Iterable, Mapping
from typing import Any, NoReturn

from rich.console import Console
from rich.table import Table

DONE, FAILED, WRONG_USAGE = 0, 1, 2

out = Console()
err = Console(stderr=True)

# Unit of a peak, what people call it, and how many of the latter make one of the former.
SHOWN_IN = {"m": ("mm", 1e3), "N": ("kN", 1e-3), "m/s^2": ("m/s²", 1.0)}
SIGNIFICANT_DIGITS = 4


def fail(message: object, exit_code: int = FAILED) -> NoReturn:
    """Print why and leave."""
    err.print(str(message), style="red", markup=False, highlight=False, soft_wrap=True)
    sys.exit(exit_code)


def fail_with_problems(summary: str, problems: Iterable[tuple[str, str]], exit_code: int = WRONG_USAGE) -> NoReturn:
    """Print what is wrong, one line per field, and leave."""
    fail("\n".join([summary, *(f"  {field}: {problem}" for field, problem in problems)]), exit_code)


def shown(value: float, unit: str) -> tuple[str, str]:
    """A value in the unit people use, with four digits, and that unit."""
    name, factor = SHOWN_IN.get(unit, (unit, 1.0))
    value *= factor
    if value == 0 or not math.isfinite(value):
        return f"{value:g}", name
    return f"{value:.{max(0, SIGNIFICANT_DIGITS - 1 - math.floor(math.log10(abs(value))))}f}", name


def peaks_table(rows: Iterable[Mapping[str, Any]], conditions: Mapping[str, str] | None = None) -> Table:
    """Peaks as a table: the columns ``conditions`` (key to heading) first, then quantity, position and values."""
    conditions = conditions or {}
    table = Table(box=None, pad_edge=False)
    for heading in conditions.values():
        table.add_column(heading, justify="right")
    for heading in ("quantity", "position"):
        table.add_column(heading)
    for heading in ("peak", "maximum", "minimum", "rms"):
        table.add_column(heading, justify="right")
    table.add_column("unit")
    for row in rows:
        values = [shown(row[key], row["unit"])[0] for key in ("peak", "maximum", "minimum", "rms")]
        table.add_row(
            *(f"{row[key]:g}" if isinstance(row[key], float) else str(row[key]) for key in conditions),
            row["quantity"].replace("_", " "),
            row["position"].replace("_", " "),
            *values,
            shown(0, row["unit"])[1],
        )
    return table
