"""Peaks of many cases as a table to read and as a file to go on with."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from rich.table import Table

from app.console import peaks_table

# Conditions of a case, as a heading names them.
CONDITIONS = {
    "speed_kmh": "km/h",
    "slab": "slab",
    "irregularity": "irregularity",
    "spectrum": "spectrum",
    "percentile": "percentile",
    "wavelength_min_m": "from m",
    "wavelength_max_m": "to m",
    "realisation": "realisation",
    "wavelength_m": "wavelength m",
    "amplitude_mm": "amplitude mm",
}


def table(rows: Sequence[dict[str, Any]]) -> Table:
    """Peaks with those conditions in which they differ, and their speed."""
    shown = {key: name for key, name in CONDITIONS.items() if key == "speed_kmh" or len({row[key] for row in rows}) > 1}
    return peaks_table(rows, shown)


def write_csv(path: Path, rows: Iterable[dict[str, Any]]) -> None:
    """Peaks with everything that is known of them; the column ``unit`` is of ``peak``, ``maximum`` and so on."""
    rows = list(rows)
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, fieldnames=list(rows[0]) if rows else [])
        writer.writeheader()
        writer.writerows(rows)
