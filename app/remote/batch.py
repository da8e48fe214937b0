"""Studies of a script that needs all of them: posted together, awaited one by one, read as columns."""

import csv
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tracksweep_client import Service
from tracksweep_client.generated.api.histories import get_history
from tracksweep_client.generated.api.irregularities import preview_irregularity
from tracksweep_client.generated.models import HistoryView, IrregularityPreview, PreviewRequest

DIVERGED = "diverged"

__all__ = ["BatchError", "Service", "computed", "heights", "history", "peaks"]


class BatchError(Exception):
    """A study did not succeed."""


def computed(service: Service, studies: Mapping[str, Mapping[str, Any]]) -> Iterator[tuple[str, str]]:
    """Names and ids of studies, each when it has ended. Cases without a finite answer are left out of their peaks.

    Raises
    ------
    BatchError
        If one failed for another reason.
    """
    ids = {name: service.submit(study).id for name, study in studies.items()}
    for name, study_id in ids.items():
        ended = service.wait(study_id, progress=False)
        failed = list(service.cases(study_id, state="failed")) if ended.cases.failed else []
        if ended.cases.cancelled or any(not case.error or case.error.code != DIVERGED for case in failed):
            raise BatchError(f"The study “{name}” ended as {ended.state}.")
        yield name, study_id


def peaks(service: Service, study_id: str) -> list[dict[str, str]]:
    """All peaks of a study with the conditions of their cases, a row each."""
    with tempfile.NamedTemporaryFile(suffix=".csv") as file:
        service.save_peaks(Path(file.name), study_id=study_id)
        with Path(file.name).open(newline="") as rows:
            return list(csv.DictReader(rows))


def history(service: Service, case_id: int, quantity: str, position: str, seconds: float) -> tuple[list[float], ...]:
    """Times, s, and values, SI, of the beginning of a stored history, thinned out between its peaks."""
    view = get_history.sync(
        case_id, client=service.client, quantity=[quantity], position=[position], time_max_s=seconds, max_points=300
    )
    assert isinstance(view, HistoryView)  # noqa: S101 - for the type checker: problems are raised
    (channel,) = view.channels
    return channel.time_s, channel.values


def heights(service: Service, irregularity: Mapping[str, Any], length_m: float) -> tuple[list[float], ...]:
    """Positions, m, and heights, mm, of an irregularity."""
    body = PreviewRequest.from_dict({"irregularity": dict(irregularity), "length_m": length_m, "max_points": 400})
    preview = preview_irregularity.sync(client=service.client, body=body)
    assert isinstance(preview, IrregularityPreview)  # noqa: S101 - for the type checker: problems are raised
    return preview.profile.positions_m, preview.profile.heights_mm
