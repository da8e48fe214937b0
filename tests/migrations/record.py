"""Records the database of a release, with what its service answers: ``python -m tests.migrations.record NAME``.

Run it once when a release changes the schema; the files in ``databases/`` stay as they are from then on. With
``--source`` another release's sources are run, for example those of a tag, unpacked to a folder.
"""

import argparse
import json
import os
import socket
import sqlite3
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

from tests.conftest import BINARIES, Postgres
from tests.e2e.conftest import SMALL, Served, tracksweep

DATABASES = Path(__file__).parent / "databases"
WAVE = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]}
BAND = {"min": 2, "max": 30}
SPECTRUM = {"kind": "spectrum", "percentile": [25], "wavelength_band_m": [BAND], "seed": 7}
COMPUTED = [
    {
        "name": "Both slabs",
        "labels": {"line": "test"},
        "sweep": {"kind": "product", "speed_kmh": [300], "slab": ["continuous", "discontinuous"], "irregularity": WAVE},
        "track": {"pad_stiffness_n_per_m": 5e7},
        "numerics": SMALL,
        "keep_history": True,
    },
    {
        "name": "A spectrum",
        "sweep": {"kind": "product", "speed_kmh": [250], "irregularity": SPECTRUM},
        "numerics": SMALL,
    },
]
PROFILE = "x_m,eta_mm\n" + "".join(f"{n / 4},{0.1 * (n % 5)}\n" for n in range(100))
LEFT_QUEUED = {
    "name": "Queued when the release ended",
    "sweep": {"kind": "product", "speed_kmh": [200], "irregularity": WAVE},
    "numerics": SMALL,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("name", help="Of the release, for example 0.1.0.")
    parser.add_argument("--source", type=Path, default=Path.cwd(), help="Folder of its sources.")
    arguments = parser.parse_args()
    folder = DATABASES / arguments.name
    folder.mkdir(parents=True)
    with tempfile.TemporaryDirectory(prefix="rec") as scratch:
        data = Path(scratch) / "sqlite"
        answers = record(arguments.source, data, "")
        with closing(sqlite3.connect(data / "tracksweep.db")) as database:
            dump = "\n".join(database.iterdump())
        write(folder, "sqlite", dump, answers)
    with tempfile.TemporaryDirectory(prefix="rec") as scratch:
        (Path(scratch) / "pg").mkdir()
        server = Postgres(Path(scratch) / "pg")
        try:
            url = server.create_database()
            answers = record(arguments.source, Path(scratch) / "data", url)
            command = [BINARIES / "pg_dump", "--inserts", "--no-owner", "--dbname", url.replace("+psycopg", "")]
            dump = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            write(folder, "postgresql", dump, answers)
        finally:
            server.stop()


def record(source: Path, data: Path, url: str) -> dict[str, Any]:
    """Have the release compute some studies and leave one queued. Returns what it answers, by path."""
    with running(source, data, url, workers=1) as service:
        for body in COMPUTED:
            assert service.ended(service.submit(body))["state"] == "succeeded"
        profile = service.http.post("/v1/profiles", content=PROFILE, headers={"Content-Type": "text/csv"})
        if profile.is_success:  # since 0.2
            over = {"kind": "measured", "profile_id": profile.json()["id"]}
            sweep = {"kind": "product", "speed_kmh": [250], "irregularity": over}
            measured = service.submit({"name": "A measured profile", "sweep": sweep, "numerics": SMALL})
            assert service.ended(measured)["state"] == "succeeded"
            tracksweep(
                "keys", "create", "anna", "--scope", "write", TRACKSWEEP_DATA_DIR=data, TRACKSWEEP_DATABASE_URL=url
            )
            service.http.put(f"/v1/studies/{measured}/shares/anna").raise_for_status()
    with running(source, data, url, workers=0) as service:
        service.submit(LEFT_QUEUED)
        studies = service.get("/v1/studies")["items"]
        paths = ["/v1/studies?sort=created_at", "/v1/peaks?quantity=wheel_rail_force&page_size=50"]
        for study in studies:
            paths += [f"/v1/studies/{study['id']}", f"/v1/studies/{study['id']}/cases"]
            paths += [f"/v1/cases/{case['id']}" for case in service.cases(study["id"])]
        return {path: service.http.get(path).raise_for_status().json() for path in paths}


@contextmanager
def running(source: Path, data: Path, url: str, workers: int) -> Iterator[Served]:
    """The service of the sources in a folder."""
    before = Path.cwd()
    os.chdir(source)  # where Python looks for modules first
    try:
        service = Served(data, "--workers", str(workers), TRACKSWEEP_DATABASE_URL=url)
        try:
            yield service
            service.stop()
        finally:
            service.http.close()
            service.process.kill()
    finally:
        os.chdir(before)


def write(folder: Path, kind: str, dump: str, answers: dict[str, Any]) -> None:
    for suffix, text in (("sql", dump), ("json", json.dumps(answers, indent=1) + "\n")):
        anywhere = text.replace(f"{socket.gethostname()}:", "host:")  # workers are named after their machine
        (folder / f"{kind}.{suffix}").write_text(anywhere)


if __name__ == "__main__":
    main()
