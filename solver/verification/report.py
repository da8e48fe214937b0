"""The report: one section per check, with a table and a picture."""

import re
from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from solver.verification.finding import Check, Finding, Plot
from solver.version import SOLVER_VERSION

HEADER = """# Verification

What the solver answers beside answers found in other ways. Written by

    tracksweep verify

(or `make verify`), which fails when a tolerance is missed. Solver version {version}. {verdict}

"""


def write_report(folder: Path, found: Sequence[tuple[Check, Finding]]) -> Path:
    """Write ``verification.md`` and its pictures.

    Parameters
    ----------
    folder : Path
        Created if missing.
    found : sequence of (Check, Finding)

    Returns
    -------
    Path
        The report.
    """
    folder.mkdir(parents=True, exist_ok=True)
    pictures = folder / "verification"
    for stale in pictures.glob("*.svg"):
        stale.unlink()
    rows = [row for _, finding in found for row in finding.rows]
    missed = sum(not row.passed for row in rows)
    verdict = f"{len(found)} checks, {len(rows)} numbers, " + (
        f"**{missed} missed**." if missed else "all within tolerance."
    )
    text = HEADER.format(version=SOLVER_VERSION, verdict=verdict)
    text += "| check | numbers | largest difference | verdict |\n|---|---|---|---|\n"
    text += "".join(_summary(check, finding) for check, finding in found)
    text += "".join(_section(pictures, check, finding) for check, finding in found)
    path = folder / "verification.md"
    path.write_text(text)
    return path


def _anchor(title: str) -> str:
    """As Markdown renderers make anchors of headings."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def _summary(check: Check, finding: Finding) -> str:
    differences = [abs(row.difference) for row in finding.rows if hasattr(row, "difference")]
    largest = f"{100 * max(differences):.2g} %" if differences else ""
    verdict = "kept" if finding.passed else "**missed**"
    return f"| [{check.title}](#{_anchor(check.title)}) | {len(finding.rows)} | {largest} | {verdict} |\n"


def _section(pictures: Path, check: Check, finding: Finding) -> str:
    text = f"\n## {check.title}\n\n{check.how}\n\n"
    text += "| what | ours | expected | difference | tolerance | verdict |\n|---|---|---|---|---|---|\n"
    for row in finding.rows:
        verdict = "kept" if row.passed else "**missed**"
        text += f"| {row.what} | {' | '.join(row.cells())} | {verdict} |\n"
    for number, plot in enumerate(finding.plots):
        path = pictures / f"{_anchor(check.title)}-{number + 1}.svg"
        write_picture(path, plot)
        text += f"\n![{plot.y_label} over {plot.x_label}]({pictures.name}/{path.name})\n"
    return text


def write_picture(path: Path, plot: Plot) -> None:
    """Draw a plot into an SVG file: the same bytes for the same numbers, and text as text."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with mpl.rc_context({"svg.hashsalt": "tracksweep", "svg.fonttype": "none", "font.size": 9}):
        _draw(plot).savefig(path, bbox_inches="tight", metadata={"Date": None})


def _draw(plot: Plot) -> Figure:
    figure = Figure(figsize=(6.5, 3.2))
    axes = figure.subplots()
    for curve in plot.curves:
        axes.plot(np.asarray(curve.x), np.asarray(curve.y), curve.style, label=curve.label or None, linewidth=1)
    if plot.logarithmic:
        axes.set_yscale("log")
        if plot.x_label.endswith((", m", ", s")):
            axes.set_xscale("log")
    axes.set(xlabel=plot.x_label, ylabel=plot.y_label)
    axes.grid(alpha=0.3, which="both")
    axes.legend(fontsize=7)
    return figure
