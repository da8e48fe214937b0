"""Studies cancelled while a worker computes them, or before."""

import sqlite3
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest

from tests.e2e.conftest import SECONDS_LONG, Served, served, study, until


@pytest.fixture
def service(tmp_path: Path) -> Iterator[Served]:
    with served(tmp_path / "data", "--workers", "1") as service:
        yield service


def stored(data: Path) -> dict[str, list[Any]]:
    """All rows that tell of studies and cases, and all objects."""
    tables = ("study", "case", "peak", "history", "event")
    with closing(sqlite3.connect(data / "tracksweep.db")) as database:
        rows = {table: database.execute(f'SELECT * FROM "{table}" ORDER BY 1').fetchall() for table in tables}
    return rows | {"objects": sorted(file.name for file in (data / "histories").rglob("*.npz*"))}


def test_cancelled_studies_end_at_once_and_nothing_is_written_of_them_later(service: Served) -> None:
    """Nineteen of twenty within two seconds: where a promise is a time, a test has to look at the clock."""
    studies = [
        service.submit(study(speed, window_s=SECONDS_LONG) | {"keep_history": True}) for speed in range(200, 400, 10)
    ]
    took = []
    for number, study_id in enumerate(studies):
        if number % 5 == 0:  # the worker has moved on to it
            until(lambda: service.cases(study_id)[0]["progress"] > 0)  # noqa: B023
        began = time.monotonic()
        service.http.post(f"/v1/studies/{study_id}/cancel").raise_for_status()
        until(lambda: service.get(f"/v1/studies/{study_id}")["state"] == "cancelled")  # noqa: B023
        took.append(time.monotonic() - began)
    assert sorted(took)[-2] < 2
    before = stored(service.data)
    assert before["peak"] == before["history"] == before["objects"] == []

    service.ended(service.submit(study(400)))  # the worker has heard of it by now
    after = stored(service.data)
    last = max(row[0] for row in before["case"])
    for table in ("study", "case", "event"):
        assert set(before[table]) <= set(after[table])
    ((case_id, *_),) = set(after["case"]) - set(before["case"])
    assert case_id > last
    assert after["objects"] == []
