"""Peaks by the names they have outside."""

from typing import Any

from solver.peaks import Peak


def peak_at_boundary(peak: Peak) -> dict[str, Any]:
    """A peak by the names it has in the database and in the service's answers."""
    values = vars(peak).copy()
    return values | {"time_s": values.pop("time"), "track_position_m": values.pop("track_position")}
