"""Peaks of many cases as a table to read."""

from collections.abc import Sequence
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
    """Peaks with those conditions and parameters in which they differ, and their speed."""
    flat = [row | row.get("parameters", {}) for row in rows]
    headings = CONDITIONS | {path: path for row in rows for path in row.get("parameters", {})}
    differing = {key for key in headings if len({row[key] for row in flat}) > 1}
    return peaks_table(flat, {key: name for key, name in headings.items() if key == "speed_kmh" or key in differing})
