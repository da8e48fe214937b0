"""Peaks against speed, one panel per quantity."""

from collections.abc import Mapping
from pathlib import Path

from matplotlib.axes import Axes
from matplotlib.figure import Figure

PANELS = (
    *("wheel_rail_force", "rail_displacement", "rail_acceleration"),
    *("car_body_acceleration", "bogie_acceleration", "wheelset_acceleration"),
)
INK, GREY, ACCENT = "#333333", "#999999", "#0b5394"


def draw(peaks: Mapping[tuple[str, str], Mapping[float, float]], title: str, path: Path) -> None:
    """Draw peaks, given by quantity and unit and then by speed in km/h."""
    figure = Figure(figsize=(11, 6.2), layout="constrained")
    panels = [(key, curve) for key, curve in peaks.items() if key[0] in PANELS]
    for axes, ((quantity, unit), curve) in zip(figure.subplots(2, 3, sharex=True).flat, panels, strict=True):
        _panel(axes, curve, f"{quantity.replace('_', ' ').capitalize()} in {unit}")
    for axes in figure.axes[3:]:
        axes.set_xlabel("speed in km/h", color=INK)
    figure.suptitle(title, x=0.012, ha="left", color=INK, fontsize=15, fontweight="bold")
    figure.savefig(path, dpi=150)


def _panel(axes: Axes, curve: Mapping[float, float], title: str) -> None:
    highest = max(curve, key=curve.__getitem__)
    axes.plot(list(curve), list(curve.values()), "o-", color=ACCENT, linewidth=2, markersize=6)
    axes.annotate(
        f"{curve[highest]:.3g}",
        (highest, curve[highest]),
        xytext=(0, 8),
        textcoords="offset points",
        ha="center",
        color=INK,
    )
    axes.set_title(title, loc="left", color=INK, fontsize=11)
    axes.set_ylim(0, 1.18 * curve[highest])
    axes.set_xticks(list(curve))
    axes.margins(x=0.1)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color(GREY)
    axes.tick_params(colors=INK)
