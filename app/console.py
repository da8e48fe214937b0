"""What people read on a terminal: tables with units, progress, and problems as field and bound."""

import math
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NoReturn

from rich.console import Console
from rich.table import Table

DONE, FAILED, WRONG_USAGE = 0, 1, 2

out = Console(width=None if sys.stdout.isatty() else 140)  # in a file, lines need not fit a window
err = Console(stderr=True)

# Unit of a peak, the unit people use, and the factor to it.
SHOWN_IN = {"m": ("mm", 1e3), "N": ("kN", 1e-3), "m/s^2": ("m/s²", 1.0), "1": ("–", 1.0)}
SIGNIFICANT_DIGITS = 4


def fail(message: object, exit_code: int = FAILED) -> NoReturn:
    """Print why and leave."""
    err.print(str(message), style="red", markup=False, highlight=False, soft_wrap=True)
    sys.exit(exit_code)


def fail_with_problems(summary: str, problems: Iterable[tuple[str, str]], exit_code: int = WRONG_USAGE) -> NoReturn:
    """Print what is wrong, one line per field, and leave."""
    fail("\n".join([summary, *(f"  {field}: {problem}" for field, problem in problems)]), exit_code)


def read_file(path: Path) -> bytes:
    """What a file holds, or the end of the program."""
    try:
        return path.read_bytes()
    except OSError as error:
        fail(f"Cannot read {path}: {error.strerror}.", WRONG_USAGE)


def shown_unit(unit: str) -> tuple[str, float]:
    """The unit people use for values in an SI unit, and the factor to it."""
    return SHOWN_IN.get(unit, (unit, 1.0))


def digits(value: float) -> str:
    """A value with four significant digits and no exponent."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    return f"{value:.{max(0, SIGNIFICANT_DIGITS - 1 - math.floor(math.log10(abs(value))))}f}"


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
        unit, factor = shown_unit(row["unit"])
        values = [digits(factor * row[key]) for key in ("peak", "maximum", "minimum", "rms")]
        table.add_row(
            *(f"{row[key]:g}" if isinstance(row[key], float) else str(row[key]) for key in conditions),
            row["quantity"].replace("_", " "),
            row["position"].replace("_", " "),
            *values,
            unit,
        )
    return table
