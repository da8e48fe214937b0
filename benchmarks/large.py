"""What the largest study takes of the API, and one that is too large.

python -m benchmarks.large
"""

import os
import random
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import httpx
import psutil
from sqlalchemy import insert, select, update

import migrations
from app.db.models import Case, Peak, StudyCase
from app.db.session import Database
from app.serve.service import listen, url_of
from benchmarks.million import BATCH, PEAKS_PER_CASE, peaks_of
from benchmarks.results import Result, publish

SIZES = (1_000, 10_000)
TOO_MANY = 1_000_000
LOOK_EVERY_S = 0.002

HOW = """A study is created, listed in pages of 500 cases, exported and deleted, on SQLite; nothing computes meanwhile.
Before it is exported each of its cases gets {peaks} peaks. Then a product of {too_many} cases is refused. For every
operation there is a new process of the API, which has answered one small request before: *MB* is by how much its
resident size grows at most. Exporting as Parquet loads Arrow, which takes most of what is told of it."""


@contextmanager
def api(data: Path) -> Iterator[tuple[httpx.Client, psutil.Process]]:
    """A new process of the API on a folder, which has answered a request, and a client of it."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("TRACKSWEEP_")}
    with listen("127.0.0.1", 0) as listener, (data / "api.log").open("a") as log:
        descriptor = listener.fileno()
        command = [sys.executable, "-m", "worker.cli", "api", "--fd", str(descriptor)]
        environment["TRACKSWEEP_DATA_DIR"] = str(data)
        with (
            subprocess.Popen(command, env=environment, pass_fds=[descriptor], stdout=log, stderr=log) as process,  # noqa: S603
            httpx.Client(base_url=url_of(listener), trust_env=False, timeout=300) as http,
        ):
            try:
                http.get("/v1/studies").raise_for_status()
                yield http, psutil.Process(process.pid)
            finally:
                process.terminate()


class Handling:
    """A study and what was done with it.

    Attributes
    ----------
    data : Path
        Folder of the service.
    took : dict
        By operation, seconds and megabytes.
    """

    def __init__(self, data: Path) -> None:
        self.data = data
        self.took: dict[str, tuple[float, float]] = {}

    @contextmanager
    def step(self, name: str) -> Iterator[httpx.Client]:
        """Measure what is asked of a new process."""
        with api(self.data) as (http, process):
            before = most = process.memory_info().rss
            done = threading.Event()

            def look() -> None:
                nonlocal most
                while not done.wait(LOOK_EVERY_S):
                    most = max(most, process.memory_info().rss)

            watcher = threading.Thread(target=look)
            watcher.start()
            began = time.perf_counter()
            try:
                yield http
                took = time.perf_counter() - began
            finally:
                done.set()
                watcher.join()
            self.took[name] = took, (most - before) / 1e6


def study(cases: int) -> dict[str, Any]:
    """A product of as many cases."""
    amplitudes = [round(0.1 + 1e-6 * n, 6) for n in range(cases // 100)]
    irregularity = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": amplitudes}
    sweep = {"kind": "product", "speed_kmh": [160 + n for n in range(100)], "irregularity": irregularity}
    return {"name": f"{cases} cases", "sweep": sweep}


def handled(cases: int) -> dict[str, tuple[float, float]]:
    """Seconds and megabytes that a study takes, by operation."""
    with tempfile.TemporaryDirectory(prefix="tracksweep-") as folder:
        url = f"sqlite:///{folder}/tracksweep.db"
        migrations.upgrade(url)
        handling = Handling(Path(folder))
        with handling.step("create") as http:
            created = http.post("/v1/studies", json=study(cases)).raise_for_status().json()
        path = f"/v1/studies/{created['id']}"
        with handling.step("list") as http:
            query, listed = {"page_size": "500"}, 0
            while query.get("cursor", "") is not None:
                page = http.get(f"{path}/cases", params=query).raise_for_status().json()
                query, listed = query | {"cursor": page["next_cursor"]}, listed + len(page["items"])
        if listed != cases:
            raise SystemExit(f"{listed} of {cases} cases are listed")
        with closing(Database(url)) as database:
            compute(database, created["id"])
        for kind in ("csv", "parquet"):
            with (
                handling.step(f"export as {kind}") as http,
                http.stream("GET", f"/v1/peaks.{kind}", params={"study_id": created["id"]}) as answer,
            ):
                exported = sum(map(len, answer.raise_for_status().iter_raw()))
            if exported < 16 * cases * PEAKS_PER_CASE:
                raise SystemExit(f"{exported} bytes are exported")
        with handling.step("delete") as http:
            http.delete(path).raise_for_status()
        with handling.step(f"refuse {TOO_MANY} cases") as http:
            if http.post("/v1/studies", json=study(TOO_MANY)).status_code != httpx.codes.UNPROCESSABLE_ENTITY:
                raise SystemExit(f"{TOO_MANY} cases are not refused")
        return handling.took


def compute(database: Database, study_id: str) -> None:
    """Give the cases of a study peaks, as workers would."""
    chance = random.Random(1)  # noqa: S311 - not a secret
    columns = Case.id, Case.speed_kmh, Case.slab, Case.percentile, Case.amplitude_mm
    of_study = select(*columns).join(StudyCase, StudyCase.case_id == Case.id).where(StudyCase.study_id == study_id)
    with database.write() as session:
        cases = session.execute(of_study).mappings().all()
        for first in range(0, len(cases), BATCH):
            peaks = [peak for case in cases[first : first + BATCH] for peak in peaks_of(chance, case)]
            session.execute(insert(Peak), peaks)
        session.execute(update(Case).values(state="succeeded"))


def run() -> Result:
    """Handle studies of all sizes."""
    found = {cases: handled(cases) for cases in SIZES}
    table = [["operation", *(f"{cases} cases, {unit}" for cases in SIZES for unit in ("s", "MB"))]]
    for name in found[SIZES[0]]:
        of_sizes = [found[cases][name] for cases in SIZES]
        table.append([name, *(cell for took, mb in of_sizes for cell in (f"{took:.2f}", f"{mb:.0f}"))])
    largest = found[SIZES[-1]]
    refused_s, refused_mb = largest[f"refuse {TOO_MANY} cases"]
    return Result(
        title="The largest study",
        how=HOW.format(peaks=PEAKS_PER_CASE, too_many=TOO_MANY),
        command="python -m benchmarks.large",
        values={
            "create_10000_cases_s": largest["create"][0],
            "largest_growth_mb": max(mb for _, mb in largest.values()),
            "refuse_1000000_cases_ms": 1e3 * refused_s,
            "refuse_1000000_cases_mb": refused_mb,
        },
        table=table,
    )


if __name__ == "__main__":
    publish("large", run())
