"""``tracksweep verify``: the solver beside answers found in other ways."""

from pathlib import Path

from rich.progress import Progress

from app.console import FAILED, err, fail, out
from solver.verification.checks import CHECKS
from solver.verification.report import write_report
from solver.verification.run import run_checks


def run(folder: Path | None, quick: bool) -> None:
    """Run the checks, say how each ended, write the report, and end the program with 1 if a tolerance is missed."""
    chosen = [check for check in CHECKS if check.quick or not quick]
    found = []
    with Progress(console=err, transient=True, disable=not err.is_terminal) as progress:
        task = progress.add_task("checking", total=len(chosen))
        for check, finding, seconds in run_checks(chosen):
            found.append((check, finding))
            progress.advance(task)
            verdict = "kept" if finding.passed else "MISSED"
            out.print(f"{verdict:6s}  {len(finding.rows):3d} numbers  {seconds:4.0f} s  {check.title}")
            for row in finding.rows:
                if not row.passed:
                    out.print(f"          {row.what}: {', '.join(cell for cell in row.cells() if cell)}")
    found.sort(key=lambda each: chosen.index(each[0]))
    if folder is not None:
        out.print(f"Report: {write_report(folder, found)}")
    if not all(finding.passed for _, finding in found):
        fail("A tolerance is missed.", FAILED)
