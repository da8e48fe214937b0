"""Databases of a million made-up peaks: conditions by chance, values that grow with what such values grow with."""

import random
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

from sqlalchemy import Connection, Table, insert, text

import migrations
from app.access.caller import ANYBODY, Caller
from app.cases.repository import row_of
from app.cases.schemas import CaseFile
from app.db.models import ApiKey, Case, Peak, Study, StudyCase, StudyShare
from app.db.session import Database
from solver.channels import ALL_JOINTS, CHANNELS, Channel
from solver.observables import OBSERVABLES
from tests.conftest import Postgres

SIZES = {  # typical values
    **{"wheel_rail_force": 9e4, "wheel_rail_force_20hz": 8e4, "wheel_rail_force_quantile": 8.5e4},
    **{"wheel_rail_force_20hz_quantile": 7.5e4, "wheel_unloading": 0.3, "contact_loss": 0.1},
    **{"contact_loss_events": 1.0, "contact_loss_duration": 1e-3, "wheelset_acceleration": 40.0},
    **{"bogie_acceleration": 2.0, "car_body_acceleration": 0.2, "car_body_acceleration_comfort": 0.1},
    **{"sperling_index": 1.5, "rail_displacement": 1e-3, "slab_displacement": 6e-4, "base_displacement": 5e-4},
    **{"rail_acceleration": 300.0, "rail_acceleration_moving_frame": 200.0, "slab_acceleration": 20.0},
    **{"base_acceleration": 15.0, "slab_moment": 2e3, "roadbed_pressure": 4e4, "pad_force": 3e4, "pad_uplift": 2e3},
    **{"joint_opening": 1e-4, "joint_slope_jump": 1e-4, "joint_shear": 1e4},
}
SPEEDS_KMH = [160.0 + 10 * n for n in range(20)]
SLOWEST_KMH = 200.0
BATCH = 500  # cases per statement
_PEAKS = cast("Table", Peak.__table__)
# Studies, by what they hold: few cases, half of all, those with the slowest trains, and the rest.
FEW, HALF, SLOW, REST = (digit * 32 for digit in "0123")
FEW_CASES = 240
CALLERS = {  # each sees one of them
    "anybody": ANYBODY,
    **{f"key of {name}": Caller(key_id=n, scope="write") for n, name in enumerate(("few", "half", "slow"), 1)},
}


def channels() -> list[Channel]:
    """Quantities and positions of the peaks of a case."""
    found = list(CHANNELS)
    for name, each in OBSERVABLES.items():
        found += [replace(c, quantity=name, unit=each.unit) for c in found if c.quantity == each.of]
    return found


_CHANNELS = channels()
PEAKS_PER_CASE = sum(channel.position != ALL_JOINTS for channel in _CHANNELS)  # on a continuous slab


def fill(connection: Connection, rows: int) -> None:
    """Store cases with as many peaks, studies and keys."""
    chance = random.Random(1)  # noqa: S311 - not a secret
    case = CaseFile.model_validate({"speed_kmh": 300, "irregularity": {"kind": "none"}}).to_case()
    common = row_of(case, 0) | {"state": "succeeded"}
    cases: list[dict[str, Any]] = []
    while rows > 0:
        numbers = range(len(cases) + 1, len(cases) + 1 + BATCH)
        chosen = [common | _conditions(chance) | {"id": n, "digest": f"{n:064x}"} for n in numbers]
        peaks = [peak for each in chosen for peak in peaks_of(chance, each)]
        connection.execute(insert(Case), chosen)
        connection.execute(insert(Peak), peaks)
        rows -= len(peaks)
        cases += chosen
    _share_out(connection, chance, cases)


def _share_out(connection: Connection, chance: random.Random, cases: list[dict[str, Any]]) -> None:
    everything = [each["id"] for each in cases]
    held = {
        FEW: chance.sample(everything, min(FEW_CASES, len(cases))),
        HALF: chance.sample(everything, len(cases) // 2),
        SLOW: [each["id"] for each in cases if each["speed_kmh"] <= SLOWEST_KMH],
    }
    held[REST] = sorted(set(everything).difference(*held.values()))
    vary = {"sweep": {"kind": "product", "vary": {"track.pad_stiffness_n_per_m": [4e7, 6e7]}}}
    fields = {"labels": {}, "priority": 0, "keep_history": False, "request": vary, "cases_reused": 0}
    for key_id, (study, ids) in enumerate(held.items(), 1):
        connection.execute(insert(ApiKey).values(id=key_id, name=study, scope="write", hash=""))
        connection.execute(insert(Study).values(id=study, name=study, owner_id=key_id, **fields))
        places = [{"study_id": study, "case_id": n, "position": place} for place, n in enumerate(ids)]
        connection.execute(insert(StudyCase), places)
    connection.execute(insert(StudyShare).values(study_id=FEW, key_id=len(held)))


_WAVE = dict.fromkeys(("wavelength_m", "amplitude_mm"))
_SPECTRUM = dict.fromkeys(
    ("spectrum", "percentile", "wavelength_min_m", "wavelength_max_m", "seed", "realisation"),
)


def _conditions(chance: random.Random) -> dict[str, Any]:
    conditions = {"speed_kmh": chance.choice(SPEEDS_KMH), "slab": chance.choice(["continuous", "discontinuous"])}
    if chance.random() < 0.1:
        wave = {"wavelength_m": chance.choice([0.5, 1.0, 2.0]), "amplitude_mm": chance.choice([0.1, 0.3])}
        return {"irregularity": "harmonic", **conditions, **_SPECTRUM, **wave}
    spectrum = {
        "spectrum": "tb3352-ballastless",
        "percentile": chance.choice([25.0, 63.2, 90.0]),
        "wavelength_min_m": chance.choice([2.0, 30.0]),
        "wavelength_max_m": 120.0,
        "seed": 1,
        "realisation": chance.randrange(100),
    }
    return {"irregularity": "spectrum", **conditions, **_WAVE, **spectrum}


def peaks_of(chance: random.Random, case: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Columns of the peaks that a case may have; they grow with speed and with what it runs over."""
    of_case = {"case_id": case["id"], "speed_kmh": case["speed_kmh"], "percentile": case["percentile"]}
    rough = 2.0 + case["amplitude_mm"] if case["percentile"] is None else 1.0 + case["percentile"] / 100
    growth = (case["speed_kmh"] / 300) ** 1.5 * rough / 1.6
    for channel in _CHANNELS:
        if channel.position == ALL_JOINTS and case["slab"] == "continuous":
            continue
        peak = SIZES[channel.quantity] * growth * chance.gauss(1, 0.1)
        statistics = {"peak": peak, "maximum": peak, "minimum": -peak * chance.random(), "rms": peak / 3}
        statistics |= {"mean": peak * chance.gauss(0, 0.1), "std": peak / 3 * chance.gauss(1, 0.1)}
        place = {"time_s": chance.uniform(0, 3), "track_position_m": chance.uniform(0, 400)}
        yield of_case | vars(channel) | statistics | place


@contextmanager
def databases(rows: int) -> Iterator[dict[str, Database]]:
    """A SQLite file and a PostgreSQL cluster, filled alike."""
    with tempfile.TemporaryDirectory(prefix="pg") as folder:
        server = Postgres(Path(folder))
        urls = {"sqlite": f"sqlite:///{folder}/tracksweep.db", "postgresql": server.create_database()}
        try:
            opened = {name: filled(url, rows) for name, url in urls.items()}
            yield opened
            for database in opened.values():
                database.close()
        finally:
            server.stop()


def filled(url: str, rows: int) -> Database:
    """A new database."""
    began = time.perf_counter()
    migrations.upgrade(url)
    database = Database(url)
    with database.engine.begin() as connection:
        for index in _PEAKS.indexes:  # sorted once, rather than kept sorted by each row
            index.drop(connection)
        fill(connection, rows)
        for index in _PEAKS.indexes:
            index.create(connection)
    if database.engine.dialect.name == "postgresql":  # which does so by itself a minute later
        with database.engine.connect().execution_options(isolation_level="AUTOCOMMIT") as connection:
            connection.execute(text("VACUUM ANALYZE"))
    print(f"{database.engine.dialect.name}: {rows} peaks stored in {time.perf_counter() - began:.0f} s", flush=True)
    return database
