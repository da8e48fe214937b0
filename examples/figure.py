"""Peaks against speed, one panel per quantity."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from app.console import shown_unit

PANELS = {
    "wheel_rail_force": "Wheel–rail force",
    "rail_displacement": "Rail displacement",
    "rail_acceleration": "Rail acceleration",
    "car_body_acceleration": "Car body acceleration",
    "bogie_acceleration": "Bogie acceleration",
    "wheelset_acceleration": "Wheelset acceleration",
}
INK, ACCENT = "#333333", "#0b5394"


def draw_peaks_against_speed(rows: Iterable[dict[str, Any]], title: str, path: Path) -> None:
    """Draw each quantity's largest peak at any position against speed."""
    rows = list(rows)
    figure = Figure(figsize=(11, 6.2), layout="constrained")
    for axes, (quantity, name) in zip(figure.subplots(2, 3, sharex=True).flat, PANELS.items(), strict=True):
        _panel(axes, [row for row in rows if row["quantity"] == quantity], name)
    for axes in figure.axes[3:]:
        axes.set_xlabel("speed in km/h")
    figure.suptitle(title, x=0.012, ha="left", color=INK, fontsize=16, fontweight="bold")
    figure.savefig(path, dpi=150)


def _panel(axes: Axes, rows: list[dict[str, Any]], title: str) -> None:
    unit, factor = shown_unit(rows[0]["unit"])
    peaks: dict[float, float] = {}
    for row in rows:
        speed = row["speed_kmh"]
        peaks[speed] = max(peaks.get(speed, 0.0), row["peak"] * factor)
    speeds = sorted(peaks)
    axes.plot(speeds, [peaks[speed] for speed in speeds], "o-", color=ACCENT, linewidth=2, markersize=6)
    for speed in {speeds[0], max(peaks, key=peaks.__getitem__)}:
        axes.annotate(
            f"{peaks[speed]:.3g}",
            (speed, peaks[speed]),
            xytext=(0, 8),
            textcoords="offset points",
            ha="center",
            color=INK,
        )
    axes.set_title(f"{title} in {unit}", loc="left", color=INK, fontsize=11)
    axes.set_ylim(0, 1.18 * max(peaks.values()))
    axes.set_xticks(speeds)
    axes.margins(x=0.14)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color("#999999")
    axes.tick_params(colors=INK)
