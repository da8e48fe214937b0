"""``tracksweep solve``: one case here and now, without a service."""

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError
from rich.progress import Progress

from app.cases.schemas import CaseFile
from app.console import FAILED, WRONG_USAGE, err, fail, fail_with_problems, out, peaks_table, read_file
from app.problems import pointer_to
from solver.case import Case
from solver.peaks import Peak, peaks
from solver.quantity import InvalidParameterError
from solver.simulate import Response, SolverError, solve
from solver.version import SOLVER_VERSION


def read_case(path: Path) -> Case:
    """The case of a file, or the end of the program with what is wrong in it."""
    text = read_file(path)
    try:
        return CaseFile.model_validate_json(text).to_case()
    except ValidationError as error:
        problems = [(_dotted(text, each["loc"]), each["msg"]) for each in error.errors()]
        fail_with_problems(f"{path} is not a valid case:", problems)
    except InvalidParameterError as error:
        fail_with_problems(f"{path} is not a valid case:", [(error.parameter, error.problem)])


def _dotted(text: bytes, loc: tuple[str | int, ...]) -> str:
    pointer = pointer_to(("body", *loc), json.loads(text)) if loc else ""
    return pointer.lstrip("/").replace("/", ".") or "the file"


def solve_here(case: Case) -> Response:
    """Solve one case, with a progress bar where somebody watches; or end the program with the reason."""
    with Progress(console=err, transient=True, disable=not err.is_terminal) as progress:
        task = progress.add_task("solving", total=1.0)
        (result,) = solve([case], on_progress=lambda fraction: progress.update(task, completed=fraction))
    if isinstance(result, SolverError):
        fail(f"{result.code}: {result}", FAILED)
    return result


def peak_at_boundary(peak: Peak) -> dict[str, Any]:
    """A peak by the names it has in the service's answers."""
    values = vars(peak).copy()
    return values | {"time_s": values.pop("time"), "track_position_m": values.pop("track_position")}


def write_histories(response: Response, path: Path) -> None:
    """The histories as one compressed NumPy archive, with quantities, positions and units beside the values."""
    channels = response.channels
    with path.open("wb") as file:
        np.savez_compressed(
            file,
            time_s=response.time,
            track_position_m=response.track_position,
            values=response.values,
            quantity=[channel.quantity for channel in channels],
            position=[channel.position for channel in channels],
            unit=[channel.unit for channel in channels],
        )


def run(path: Path, histories: Path | None, as_json: bool) -> None:
    """Solve the case of a file, keep its histories if asked, and print its peaks."""
    case = read_case(path)
    if histories is not None and not os.access(histories.parent, os.W_OK):  # said before the work, not after it
        fail(f"Cannot write {histories}.", WRONG_USAGE)
    response = solve_here(case)
    if histories is not None:
        write_histories(response, histories)
    rows = [peak_at_boundary(peak) for peak in peaks(response)]
    if as_json:
        digest = {"digest": case.digest(), "solver_version": SOLVER_VERSION, "time_step_s": response.time_step}
        out.print_json(data=digest | {"peaks": rows})
    else:
        out.print(peaks_table(rows))
