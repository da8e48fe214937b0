"""``tracksweep article``: from nothing to the report."""

import os
import tempfile
from pathlib import Path

import httpx
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

from app.console import FAILED, WRONG_USAGE, err, fail, out
from app.remote.batch import BatchError
from app.serve.own import own_service
from worker.article import strip
from worker.article.gathered import gather
from worker.article.report import write_report
from worker.article.results import Results
from worker.article.studies import studies

RESULTS = Path("article", "results.json")
PATIENT = {"TRACKSWEEP_LEASE_S": "600"}  # where nobody else is there to take over, a busy machine is no reason to


def run(folder: Path, url: str | None, rewrite: bool) -> None:
    """Compute everything by a service, keep the results, and write the report; or write it from kept results."""
    kept = folder / RESULTS
    if rewrite:
        if not kept.exists():
            fail(f"There is no {kept} to write the report from.", WRONG_USAGE)
    else:
        try:
            results = _by(url) if url is not None else _by_own_service()
        except (BatchError, httpx.HTTPError) as error:
            fail(error, FAILED)
        kept.parent.mkdir(parents=True, exist_ok=True)
        results.write(kept)
        out.print(f"Computed in {results.made['seconds'] / 60:.1f} min.")
    out.print(f"Report: {write_report(folder, Results.read(kept))}")


def _by_own_service() -> Results:
    with tempfile.TemporaryDirectory(prefix="tracksweep-") as data:
        workers = str(os.cpu_count() or 1)
        with own_service(Path(data), "--workers", workers, settings=PATIENT) as url:
            return _by(url)


def _by(url: str) -> Results:
    columns = BarColumn(), TextColumn("{task.description}"), TimeElapsedColumn()
    with Progress(*columns, console=err, transient=True, disable=not err.is_terminal) as progress:
        task = progress.add_task("studies", total=1.0)
        return gather(
            url, studies(), strip.PLAN, lambda done, what: progress.update(task, completed=done, description=what)
        )
