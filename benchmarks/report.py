"""Write ``benchmarks/README.md`` and its pictures from what is kept in ``benchmarks/results/``.

python -m benchmarks.report
"""

import re
from pathlib import Path
from typing import Any

from benchmarks.results import RESULTS, Result, read
from solver.verification.finding import Curve, Plot
from solver.verification.report import write_picture

ORDER = (
    *("contenders", "growth", "floor", "choices", "memory", "service"),
    *("load", "page", "large", "programme", "rolland_peer", "peaks", "scale", "capacity"),
)

HEADER = """# Benchmarks

    make bench              # all but those below
    make bench-programme    # the article's whole programme, through the service
    make bench-rolland      # beside a public peer, which is installed for it
    .venv/bin/python -m benchmarks.scale     # on hosts of a network of their own, as root
    .venv/bin/python -m benchmarks.capacity  # what follows from that

Each part can be run alone, by the command under its title, on a machine that does nothing else. It prints its figures
as lines `name = value` and keeps them in `results/`; `python -m benchmarks.report` writes this page from there. Other
machines give other times; ratios are of one run, whose parts are interleaved.
"""


def section(name: str, result: Result, machine: dict[str, str], folder: Path) -> str:
    """One benchmark in Markdown; its pictures go to the folder ``results``."""
    text = f"\n## {result.title}\n\n    {result.command}\n\n{result.how.strip()}\n\n"
    if result.table:
        head, *rows = result.table
        text += f"| {' | '.join(head)} |\n|---{'|---:' * (len(head) - 1)}|\n"
        text += "".join(f"| {' | '.join(row)} |\n" for row in rows) + "\n"
    text += "".join(f"    {key} = {value:.4g}\n" for key, value in result.values.items())
    for number, plot in enumerate(result.plots, 1):
        picture = folder / "results" / f"{name}-{number}.svg"
        write_picture(picture, as_plot(plot))
        text += f"\n![{plot['y_label']} over {plot['x_label']}]({picture.parent.name}/{picture.name})\n"
    return text + f"\nMeasured on {machine['processor']}; caches {machine['caches']}; {machine['software']}.\n"


def as_plot(plot: dict[str, Any]) -> Plot:
    """A plot as the verification report draws them."""
    return Plot(**plot | {"curves": tuple(Curve(**curve) for curve in plot["curves"])})


def write(results: Path, folder: Path) -> Path:
    """Write ``README.md`` and pictures into a folder from the results kept in another."""
    parts = [HEADER]
    for name in ORDER:
        if (path := results / f"{name}.json").exists():
            parts.append(section(name, *read(path), folder))
    page = folder / "README.md"
    page.write_text(re.sub(r"\n{3,}", "\n\n", "".join(parts)))
    return page


def main() -> None:
    """Write the page."""
    print(f"Report: {write(RESULTS, RESULTS.parent)}")


if __name__ == "__main__":
    main()
