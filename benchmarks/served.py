"""A service on a folder of its own, for as long as a benchmark needs it."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.serve.own import own_service
from tracksweep_client import Service


@contextmanager
def served(workers: int, **settings: str) -> Iterator[str]:
    """Serve an empty folder by some workers, with some settings; the service's URL."""
    with (
        tempfile.TemporaryDirectory(prefix="tracksweep-") as folder,
        own_service(Path(folder), "--workers", str(workers), settings=settings) as url,
    ):
        yield url


@dataclass(frozen=True, kw_only=True)
class Run:
    """What computing a study took.

    Attributes
    ----------
    wall_s : float
        From the first case that was begun to the last that was finished, by the database's clock.
    cpu_s : float
        Processor time of all cases, from claimed inputs to peaks.
    cases, workers : int
        How many there were, and how many workers computed any.
    """

    wall_s: float
    cpu_s: float
    cases: int
    workers: int


def submit(url: str, study: dict[str, Any]) -> str:
    """Post a study; its id."""
    with Service(url) as service:
        return service.submit(study).id


def finish(url: str, study_id: str) -> Run:
    """Wait for a study to end."""
    with Service(url) as service:
        ended = service.wait(study_id)
        cases = list(service.cases(study_id))
    if ended.state != "succeeded":
        raise SystemExit(f"the study “{ended.name}” ended as {ended.state}: nothing to compare")
    began = min(case.started_at for case in cases)
    ends = max(case.finished_at for case in cases)
    return Run(
        wall_s=(ends - began).total_seconds(),
        cpu_s=sum(case.cpu_s for case in cases),
        cases=len(cases),
        workers=len({case.worker for case in cases}),
    )
