"""The report, written from results by the template beside this file: every number in it is an expression there."""

from pathlib import Path
from typing import Any

import jinja2

from app.console import digits
from app.studies.presets import PRESETS
from solver.case import Numerics
from solver.catalogue import TRACKS
from worker.article import conclusion, outcome, reported, strip, studies
from worker.article.claims import ALIKE, SLABS, verdicts
from worker.article.figures import LOOKED_AT, TITLES, label, p2, write_pictures
from worker.article.hypotheses import AS_DESCRIBED, HYPOTHESES, PER_RAD_FACTOR
from worker.article.results import Results

FAR = 100.0  # what is that far off tells of an instability only
TEMPLATE = Path(__file__).with_name("report.md.j2")


def write_report(folder: Path, results: Results) -> Path:
    """Write ``article.md`` and its pictures.

    Parameters
    ----------
    folder : Path
        Created if missing.
    results : Results
    """
    write_pictures(folder / "article", results)
    path = folder / "article.md"
    path.write_text(render(results))
    return path


def render(results: Results) -> str:
    """The report as Markdown."""
    environment = jinja2.Environment(  # noqa: S701 - Markdown, of numbers
        undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    environment.filters |= {"digits": minus, "percent": percent, "near": near, "rms": rms}
    functions = {
        name: _bound(getattr(outcome, name), results)
        for name in ("sample", "single", "under", "residual", "dynamic_ratio", "elasticities", "numerics_errors")
    }
    known: dict[str, Any] = {
        "results": results,
        "verdicts": verdicts(results),
        "speeds": outcome.speeds(results),
        "difference": outcome.joint_differences,
        "shown": outcome.shown,
        "unit": outcome.unit_of,
    }
    constants = {
        name: getattr(module, name)
        for module in (reported, studies, strip, outcome, conclusion)
        for name in dir(module)
        if name.isupper()
    }
    known |= {
        "HYPOTHESES": HYPOTHESES,
        "AS_DESCRIBED": AS_DESCRIBED,
        "PER_RAD_FACTOR": PER_RAD_FACTOR,
        "SLABS": SLABS,
        "TITLES": TITLES,
    }
    known |= conclusion.facts(results, known["verdicts"]) | {"ALIKE": ALIKE, "factor": outcome.factor_of}
    known |= {"preset": _numerics_of, "default_step": Numerics().time_step, "track": TRACKS["crts2"].values}
    known |= {"LOOKED_AT": LOOKED_AT, "label": label, "p2": p2(), "parameters": studies.parameters()}
    known["unfounded"] = conclusion.unfounded(known, known["p2"])
    return environment.from_string(TEMPLATE.read_text()).render(**constants | functions | known)


def _numerics_of(study: str) -> dict[str, Any]:
    return PRESETS[studies.PRESETS[study]].study["numerics"]


def _bound(function: Any, results: Results) -> Any:
    return lambda *arguments: function(results, *arguments)


def minus(number: float) -> str:
    """A number's digits, as it is written in text."""
    return digits(number).replace("-", "−")


def percent(part: float, places: int = 1) -> str:
    """A part of one in percent, with its sign."""
    return f"{100 * part:+.{places}f}".replace("-", "−")


def near(part: float | None) -> str:
    """The same in whole percent, bold where it is within reach."""
    if part is None:
        return "diverges"
    if part > FAR:
        return f"> +{100 * FAR:.0f}"
    text = percent(part, 0)
    return f"**{text}**" if abs(part) <= outcome.NEAR else text


def rms(part: float | None) -> str:
    """A root mean square in whole percent."""
    if part is None:
        return ""
    return f"> {100 * FAR:.0f}" if part > FAR else f"{100 * part:.0f}"
