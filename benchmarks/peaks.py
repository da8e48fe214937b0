"""How long the first page of peaks takes, of a million: ``python -m benchmarks.peaks [--rows N]``."""

import argparse
import random
import statistics
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, insert, text

import migrations
from app.access.caller import ANYBODY
from app.cases.repository import row_of
from app.cases.schemas import CaseFile
from app.db.models import Case, Peak, Study, StudyCase
from app.db.session import Database
from app.peaks import repository
from app.peaks.schemas import PeakQuery
from tests.conftest import Postgres

WHEELSETS = [f"wheelset_{n}" for n in range(1, 5)]
PLACES = ["joint_middle", "slab_middle"]
QUANTITIES = {  # typical size, positions
    "wheel_rail_force": (9e4, WHEELSETS),
    "wheel_rail_force_20hz": (8e4, WHEELSETS),
    "wheel_unloading": (0.2, WHEELSETS),
    "wheelset_acceleration": (40.0, WHEELSETS),
    "contact_loss": (0.01, WHEELSETS),
    "bogie_acceleration": (2.0, ["bogie_1", "bogie_2"]),
    "car_body_acceleration": (0.2, ["car_body"]),
    "sperling_index": (1.5, ["car_body"]),
    "rail_displacement": (1e-3, PLACES),
    "rail_acceleration": (300.0, PLACES),
    "slab_acceleration": (20.0, PLACES),
    "base_acceleration": (5.0, PLACES),
    "pad_force": (3e4, ["pad"]),
    "joint_shear": (1e4, ["joint"]),
    "joint_opening": (1e-4, ["joint"]),
}
PEAKS_PER_CASE = sum(len(positions) for _, positions in QUANTITIES.values())
SPEEDS_KMH = [160.0 + 10 * n for n in range(20)]
BATCH = 500  # cases per statement
SLOW_S = 0.3
ORDERS = [
    sign + column for column in ("peak", "std", "speed_kmh", "percentile", "case_id", "seed") for sign in ("", "-")
]
STUDIES = {"0" * 32: 240, "1" * 32: 10_000}  # cases of each

FORCE = {"quantity": "wheel_rail_force"}
FILTERS: list[dict[str, Any]] = [
    {},
    FORCE,
    FORCE | {"position": "wheelset_1", "slab": "continuous"},
    FORCE | {"slab": "discontinuous", "percentile": 90.0},
    FORCE | {"speed_kmh_max": 170.0},  # against the grain: where forces are least
    FORCE | {"speed_kmh_min": 300.0, "speed_kmh_max": 300.0, "slab": "continuous", "percentile": 25.0},
    FORCE | {"value_min": 9e4, "value_max": 1e5},
    FORCE | {"irregularity": "harmonic"},
    FORCE | {"study_id": "0" * 32},
    FORCE | {"study_id": "1" * 32},
    {"quantity": "joint_opening", "wavelength_min_m": 2.0},
    {"slab": "discontinuous"},
    {"percentile": 90.0, "speed_kmh_min": 340.0},
    {"irregularity": "harmonic"},
    {"study_id": "0" * 32},
    {"study_id": "1" * 32},
]


def fill(connection: Connection, rows: int) -> None:
    """Cases of random conditions with peaks that grow with speed."""
    chance = random.Random(1)  # noqa: S311 - not a secret
    case = CaseFile.model_validate({"speed_kmh": 300, "irregularity": {"kind": "none"}}).to_case()
    common = row_of(case, 0) | {"state": "succeeded"}
    cases = rows // PEAKS_PER_CASE
    for first in range(1, cases + 1, BATCH):
        numbers = range(first, min(first + BATCH, cases + 1))
        chosen = [common | _conditions(chance) | {"id": n, "digest": f"{n:064x}"} for n in numbers]
        connection.execute(insert(Case), chosen)
        connection.execute(insert(Peak), [peak for each in chosen for peak in peaks_of(chance, each)])
    for study, size in STUDIES.items():
        fields = {"name": "A study", "labels": {}, "priority": 0, "keep_history": False, "request": {}}
        connection.execute(insert(Study).values(id=study, cases_reused=0, **fields))
        members = chance.sample(range(1, cases + 1), min(size, cases))
        places = [{"study_id": study, "case_id": n, "position": place} for place, n in enumerate(members)]
        connection.execute(insert(StudyCase), places)


def _conditions(chance: random.Random) -> dict[str, Any]:
    conditions = {"speed_kmh": chance.choice(SPEEDS_KMH), "slab": chance.choice(["continuous", "discontinuous"])}
    if chance.random() < 0.1:
        wave = {"wavelength_m": chance.choice([0.5, 1.0, 2.0]), "amplitude_mm": chance.choice([0.1, 0.3])}
        return conditions | {"irregularity": "harmonic"} | wave
    return conditions | {
        "irregularity": "spectrum",
        "spectrum": "tb3352-ballastless",
        "percentile": chance.choice([25.0, 63.2, 90.0]),
        "wavelength_min_m": chance.choice([2.0, 30.0]),
        "wavelength_max_m": 120.0,
        "seed": 1,
        "realisation": chance.randrange(100),
    }


def peaks_of(chance: random.Random, case: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Columns of the peaks that a case may have; they grow with speed."""
    of_case = {"case_id": case["id"], "speed_kmh": case["speed_kmh"], "percentile": case["percentile"]}
    faster = (case["speed_kmh"] / 300) ** 1.5
    for quantity, (size, positions) in QUANTITIES.items():
        for position in positions:
            peak = size * faster * chance.gauss(1, 0.1)
            statistics_ = {"peak": peak, "maximum": peak, "minimum": -peak * chance.random()}
            statistics_ |= {
                "mean": peak * chance.gauss(0, 0.1),
                "std": peak / 3 * chance.gauss(1, 0.1),
                "rms": peak / 3,
            }
            place = {"time_s": chance.uniform(0, 3), "track_position_m": chance.uniform(0, 400)}
            yield of_case | {"quantity": quantity, "position": position, "unit": "N"} | statistics_ | place


@contextmanager
def databases(rows: int) -> Iterator[dict[str, Database]]:
    """A SQLite file and a PostgreSQL cluster, filled alike."""
    with tempfile.TemporaryDirectory(prefix="pg") as folder:
        server = Postgres(Path(folder))
        urls = {"sqlite": f"sqlite:///{folder}/tracksweep.db", "postgresql": server.create_database()}
        try:
            opened = {}
            for name, url in urls.items():
                began = time.perf_counter()
                migrations.upgrade(url)
                opened[name] = Database(url)
                with opened[name].engine.begin() as connection:
                    fill(connection, rows)
                if name == "postgresql":  # which does so by itself a minute later
                    with opened[name].engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
                        connection.execute(text("VACUUM ANALYZE"))
                print(f"{name}: {rows} peaks stored in {time.perf_counter() - began:.0f} s", flush=True)
            yield opened
            for database in opened.values():
                database.close()
        finally:
            server.stop()


def first_page_ms(database: Database, query: PeakQuery) -> float:
    """Best of three, unless it is slow."""
    times: list[float] = []
    while len(times) < 3 and max(times, default=0.0) < SLOW_S:
        began = time.perf_counter()
        with database.read() as session:
            repository.find_page(session, query, 500, ANYBODY)
        times.append(time.perf_counter() - began)
    return 1e3 * min(times)


def main() -> None:
    """Print, per set of filters, how long the first page takes: the median over all orders, and the slowest."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=int, default=1_000_000)
    arguments = parser.parse_args()
    with databases(arguments.rows) as opened:
        for name, database in opened.items():
            print(f"\n{name}: first page of 100, ms")
            print(f"{'-peak':>8}{'median':>8}{'slowest':>8}  order of the slowest, filters")
            for filters in FILTERS:
                times = {order: first_page_ms(database, PeakQuery(sort=order, **filters)) for order in ORDERS}
                slowest = max(times, key=lambda order: times[order])
                columns = times["-peak"], statistics.median(times.values()), times[slowest]
                print("".join(f"{ms:8.1f}" for ms in columns), f" {slowest}, {filters}", flush=True)


if __name__ == "__main__":
    main()
