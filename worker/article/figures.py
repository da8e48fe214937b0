"""Pictures of the report: the same bytes for the same numbers, in colours that all eyes tell apart."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from app.studies.resonance import p2_hz
from solver.catalogue import TRACKS, VEHICLES
from worker.article.claims import PEAKS, SLABS
from worker.article.conclusion import GROUPS
from worker.article.hypotheses import HYPOTHESES
from worker.article.outcome import elasticities, residual, sample, shown, speeds, unit_of
from worker.article.reported import BANDS_M, PERCENTILES, SPEEDS_KMH, TABLE_1_TARGETS, TABLE_2_TARGETS
from worker.article.results import Results
from worker.article.studies import WAVELENGTHS_M, parameters

BLUE, ORANGE, GREEN, PINK, SKY, INK = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#333333"  # Okabe and Ito
FITS = 10_000  # larger numbers find no room in a field
COLOURS = (BLUE, ORANGE, GREEN, PINK, SKY)
STYLE: Any = {
    "svg.hashsalt": "tracksweep",
    "svg.fonttype": "none",
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.alpha": 0.3,
    "figure.constrained_layout.use": True,
}
TITLES = {
    "rail_acceleration": "rail acceleration",
    "slab_acceleration": "slab acceleration",
    "base_acceleration": "base acceleration",
    "wheel_rail_force": "wheel–rail force",
    "car_body_acceleration": "car-body acceleration",
    "rail_displacement": "rail displacement",
    "pad_force": "pad force",
}
LOOKED_AT = tuple(TITLES)


def label(column: str) -> str:
    """Name and unit."""
    return f"{TITLES[column]}, {unit_of(column)}"


def p2() -> float:
    """Frequency at which the wheel of the article's car bounces on its track, Hz."""
    return p2_hz(TRACKS["crts2"].values, VEHICLES["crh3"].values)


def _figure(rows: int, columns: int, size: tuple[float, float], **options: Any) -> tuple[Figure, Any]:
    figure = Figure(figsize=size)
    return figure, figure.subplots(rows, columns, **options)


def peaks_against_speed(results: Results) -> Figure:
    """Figs. 5 to 9."""
    figure, panels = _figure(2, 3, (9, 5), sharex=True)
    for axes, column in zip(panels.flat, LOOKED_AT, strict=False):
        for slab, colour, marker in zip(SLABS, COLOURS, "os", strict=False):
            cases = speeds(results).where(slab=slab)
            axes.plot(cases["speed_kmh"], shown(cases, column), marker=marker, color=colour, label=f"{slab} slab")
        axes.set(title=label(column), xticks=SPEEDS_KMH)
        axes.set_ylim(bottom=0)
    for axes in panels[1]:
        axes.set_xlabel("speed, km/h")
    panels[0, 0].legend(frameon=False)
    return figure


def samples(results: Results) -> Figure:
    """Fig. 10."""
    figure, axes = _figure(1, 1, (9, 2.6))
    for (percentile, (x, y)), colour in zip(results.profiles.items(), COLOURS, strict=False):
        axes.plot(x, y, color=colour, label=f"{percentile} %", linewidth=1)
    axes.set(xlabel="position along the track, m", ylabel="height, mm (down)")
    axes.legend(frameon=False, ncols=3, loc="upper right")
    return figure


def _histories(results: Results, study: str, values: Sequence[float], unit: str) -> Figure:
    figure, panels = _figure(2, 1, (9, 4.6), sharex=True)
    for axes, column, factor in zip(panels, ("rail_displacement", "wheel_rail_force"), (1e3, 1e-3), strict=True):
        for value, colour in zip(values, COLOURS, strict=False):
            time, history = results.histories[f"{study}, {value:g}, {column}"]
            axes.plot(time, factor * np.array(history), color=colour, label=f"{value:g}{unit}", linewidth=0.9)
        axes.set_ylabel(label(column))
    panels[1].set_xlabel("time, s")
    panels[0].legend(frameon=False, ncols=len(values), loc="upper right")
    return figure


def percentiles(results: Results) -> Figure:
    """Fig. 11."""
    return _histories(results, "percentiles", PERCENTILES, " %")


def bands(results: Results) -> Figure:
    """Fig. 12."""
    return _histories(results, "bands", BANDS_M, "–30 m")


def ensembles(results: Results) -> Figure:
    """Every realisation, and the article's one."""
    figure, panels = _figure(1, 2, (9, 3.6))
    scatter = np.random.Generator(np.random.PCG64(1))
    for axes, column in zip(panels, ("rail_displacement", "wheel_rail_force"), strict=True):
        targets = [target for target in TABLE_1_TARGETS + TABLE_2_TARGETS if target.quantity == column]
        for place, target in enumerate(targets):
            values = sample(results, target).values
            axes.plot(place + scatter.uniform(-0.25, 0.25, len(values)), values, ".", color=BLUE, markersize=3)
            axes.plot([place - 0.35, place + 0.35], 2 * [values.mean()], color=INK, linewidth=2)
            axes.plot(place, target.value, "D", color=ORANGE, markersize=6)
        axes.set_xticks(range(len(targets)), [target.short for target in targets], rotation=45)
        axes.set_title(f"{label(column)} — Table 1 | Table 2")
        axes.axvline(2.5, color=INK, linewidth=0.5)
    dots = [axes.plot([], [], style, color=colour)[0] for style, colour in ((".", BLUE), ("-", INK), ("D", ORANGE))]
    panels[1].legend(dots, ["ours, one realisation each", "their mean", "the article"], frameon=False)
    return figure


def _matrix(axes: Axes, values: np.ndarray[Any, Any], rows: Sequence[str], columns: Sequence[str], most: float) -> Any:
    image = axes.imshow(values, cmap="PuOr", vmin=-most, vmax=most, aspect="auto")
    axes.set_xticks(range(len(columns)), columns, rotation=90)
    axes.set_yticks(range(len(rows)), rows)
    axes.grid(visible=False)
    for row, column in np.argwhere(np.isfinite(values)):
        value = values[row, column]
        colour = "white" if abs(value) > 0.75 * most else INK
        axes.text(
            column,
            row,
            f"{value:.2g}" if abs(value) < 1 else f"{value:.0f}",
            ha="center",
            va="center",
            color=colour,
            fontsize=6,
        )
    return image


def hypotheses(results: Results) -> Figure:
    """Residuals of every hypothesis, percent."""
    figure, axes = _figure(1, 1, (10, 7))
    targets = [target for group in GROUPS.values() for target in group]
    found = [[residual(results, each, target) for target in targets] for each in HYPOTHESES]
    values = 100 * np.array(found, float)  # where a run diverged, not a number
    columns = [f"{TITLES[t.quantity]}, {t.short}" for t in targets]
    image = _matrix(axes, values, [each.name for each in HYPOTHESES], columns, 50.0)
    figure.colorbar(image, label="ours less the article's, %", shrink=0.5, extend="both")
    return figure


def sweep(results: Results) -> Figure:
    """What lies between the article's five speeds."""
    figure, panels = _figure(2, 2, (9, 5.6), sharex=True)
    cases = results.cases["sweep"]
    for axes, column in zip(panels.flat, ("wheel_rail_force", *PEAKS[:3]), strict=True):
        for slab, colour in zip(SLABS, COLOURS, strict=False):
            of = cases.where(slab=slab)
            axes.plot(of["speed_kmh"], shown(of, column), color=colour, label=f"{slab} slab")
            five = np.isin(of["speed_kmh"], SPEEDS_KMH)
            axes.plot(of["speed_kmh"][five], shown(of, column)[five], "o", color=colour, markersize=5)
        for metres, name in ((1.0, "wave on P2"), (0.65, "pads on P2")):
            speed = 3.6 * metres * p2()
            axes.axvline(speed, color=INK, linewidth=0.8, linestyle=":")
            axes.annotate(name, (speed, 1), xycoords=("data", "axes fraction"), rotation=90, va="top", ha="right")
        axes.set_title(label(column))
        axes.set_ylim(bottom=0)
    panels[0, 0].legend(frameon=False, loc="lower right")
    for axes in panels[1]:
        axes.set_xlabel("speed, km/h (dots: the article's five)")
    return figure


def force_map(results: Results) -> Figure:
    """Peak force over speed and wavelength."""
    figure, axes = _figure(1, 1, (7.5, 4.8))
    cases = results.cases["map"]
    x = np.unique(cases["speed_kmh"])
    force, lost = (np.empty((len(WAVELENGTHS_M), len(x))) for _ in range(2))
    for row, wavelength in enumerate(WAVELENGTHS_M):
        of = cases.where(wavelength_m=wavelength)
        force[row], lost[row] = shown(of, "wheel_rail_force"), of["contact_loss"]
    levels = np.arange(70, 50 * np.ceil(force.max() / 50) + 1, 10)
    filled = axes.contourf(x, WAVELENGTHS_M, force, levels=levels, cmap="cividis")
    axes.contour(x, WAVELENGTHS_M, lost, levels=[1e-9], colors=ORANGE, linewidths=1.5)
    axes.plot(x, x / 3.6 / p2(), "--", color="white", linewidth=1.5)
    axes.plot(SPEEDS_KMH, [1.0] * len(SPEEDS_KMH), "o", color="white", markersize=5)
    axes.set_yscale("log")
    axes.set_yticks([0.5, 0.7, 1, 1.5, 2, 3, 4], ["0.5", "0.7", "1", "1.5", "2", "3", "4"])
    axes.minorticks_off()
    axes.set_ylim(WAVELENGTHS_M[0], WAVELENGTHS_M[-1])
    axes.set(xlabel="speed, km/h", ylabel="wavelength, m")
    axes.grid(visible=False)
    figure.colorbar(filled, label="peak wheel–rail force, kN")
    return figure


def sensitivities(results: Results) -> Figure:
    """Elasticities over waves and over the spectrum."""
    figure, panels = _figure(1, 2, (10, 7), sharey=True)
    rows = [path.split(".", 1)[1].replace("_", " ") for path in parameters()]
    for axes, excitation in zip(panels, ("wave", "spectrum"), strict=True):
        values = [
            [100 * elasticities(results, path, column, excitation).mean for column in LOOKED_AT]
            for path in parameters()
        ]
        image = _matrix(axes, np.array(values), rows, [TITLES[column] for column in LOOKED_AT], 60.0)
        axes.set_title({"wave": "wave of 1 m", "spectrum": "mean spectrum"}[excitation])
    figure.colorbar(image, ax=panels, label="% of the peak per 100 % of the parameter", shrink=0.5, extend="both")
    return figure


PICTURES: dict[str, Callable[[Results], Figure]] = {
    "speeds": peaks_against_speed,
    "samples": samples,
    "percentiles": percentiles,
    "bands": bands,
    "ensembles": ensembles,
    "hypotheses": hypotheses,
    "sweep": sweep,
    "map": force_map,
    "sensitivities": sensitivities,
}


def write_pictures(folder: Path, results: Results) -> None:
    """Draw all of them."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in PICTURES.items():
        with mpl.rc_context(STYLE):
            draw(results).savefig(folder / f"{name}.svg", metadata={"Date": None})
