"""``tracksweep solve``: one case here and now, without a service."""

import os
from pathlib import Path

from rich.progress import Progress

from app.console import FAILED, WRONG_USAGE, err, fail, out, peaks_table
from solver.case import Case
from solver.errors import SolverError
from solver.peaks import peaks
from solver.processing import processing
from solver.simulate import Response, solve
from solver.version import SOLVER_VERSION
from worker.history import archive
from worker.peak import peak_at_boundary


def solve_here(case: Case) -> Response:
    """Solve one case, with a progress bar where somebody watches; or end the program with the reason."""
    with Progress(console=err, transient=True, disable=not err.is_terminal) as progress:
        task = progress.add_task("solving", total=1.0)
        (result,) = solve([case], on_progress=lambda fraction: progress.update(task, completed=fraction))
    if isinstance(result, SolverError):
        fail(f"{result.code}: {result}", FAILED)
    return result


def run(case: Case, histories: Path | None, as_json: bool) -> None:
    """Solve a case, keep its histories if asked, and print its peaks."""
    if histories is not None and not os.access(histories.parent, os.W_OK):  # said before the work, not after it
        fail(f"Cannot write {histories}.", WRONG_USAGE)
    response = solve_here(case)
    if histories is not None:
        histories.write_bytes(archive(response))
    rows = [peak_at_boundary(peak) for peak in peaks(response)]
    if as_json:
        digest = {"digest": case.digest(), "solver_version": SOLVER_VERSION, "time_step_s": response.time_step}
        out.print_json(data=digest | {"processing": processing(response), "peaks": rows})
    else:
        out.print(peaks_table(rows))
