"""How long the first page of peaks takes, of a million, in every order and with every filter; and what an export takes.

python -m benchmarks.peaks [--rows N]
"""

import argparse
import statistics
import time
from collections.abc import Iterable
from typing import Any

from app.access.caller import Caller
from app.db.session import Database
from app.peaks import repository
from app.peaks.export import as_csv, export
from app.peaks.schemas import COLUMNS, PeakFilters, PeakQuery
from benchmarks.million import CALLERS, FEW, FEW_CASES, HALF, SLOW, SLOWEST_KMH, databases
from benchmarks.results import Result, publish

ORDERS = [sign + column for column in COLUMNS for sign in ("", "-")]
FORCE = {"quantity": "wheel_rail_force"}
ALONE: list[dict[str, Any]] = [
    {},
    {"slab": "discontinuous"},
    {"irregularity": "harmonic"},
    {"spectrum": "tb3352-ballastless"},
    {"speed_kmh_min": 330.0},
    {"speed_kmh_max": 170.0},
    {"percentile": 90.0},
    {"wavelength_min_m": 2.0},
    {"wavelength_m": 0.5},
    {"study_id": FEW},
    {"study_id": HALF},
    {"study_id": SLOW},
]
WITHIN = [  # a quantity
    {"position": "wheelset_1"},
    {"value_min": 9e4, "value_max": 1e5},
    {"value_min": 1.1e5},
    {"value_max": 3e4},
    {"slab": "discontinuous", "percentile": 90.0},
    {"speed_kmh_min": 300.0, "speed_kmh_max": 300.0, "slab": "continuous", "percentile": 25.0},
    {"position": "wheelset_1", "study_id": SLOW},
    {"position": "car_body"},  # where there is none
]
ACROSS: list[dict[str, Any]] = [  # all quantities, which have different units
    {"position": "wheelset_1"},
    {"position": "pads"},
    {"value_min": 1e5},
    {"value_min": 1e4, "value_max": 2e4},
    {"value_max": 1e-4},
]
FILTERS = [*ALONE, *(FORCE | each for each in [*ALONE, *WITHIN]), *ACROSS]
KEYED = [{}, FORCE, FORCE | {"slab": "discontinuous"}, FORCE | {"speed_kmh_max": 170.0}, {"percentile": 90.0}]
SLOW_MS = 50.0

HOW = """{rows} made-up peaks of all quantities and positions; values grow with speed, percentile and amplitude. Of
every set of filters the first page of 100 is found in all {orders} orders, best of three: *median* and *slowest* are
over these, *order* is the slowest one. Keys see a study of {few} cases, of half of all cases, or of those up to
{slowest:g} km/h; anybody sees all. `slower_…` counts the combinations that take more than {slow:g} ms, with and
without a quantity among the filters. An export writes all peaks as CSV, in the order of their cases."""

Times = dict[str, float]


def first_page_ms(database: Database, query: PeakQuery, caller: Caller) -> float:
    """Best of three."""
    times = []
    for _ in range(3):
        began = time.perf_counter()
        with database.read() as session:
            repository.find_page(session, query, 500, caller)
        times.append(time.perf_counter() - began)
    return 1e3 * min(times)


def of_filters(database: Database, filters: dict[str, Any], caller: Caller) -> Times:
    """Milliseconds by order."""
    return {order: first_page_ms(database, PeakQuery(sort=order, **filters), caller) for order in ORDERS}


def words(filters: dict[str, Any]) -> str:
    """Filters to read."""
    said = [f"{name} = {str(value)[:4] + '…' if name == 'study_id' else value}" for name, value in filters.items()]
    return ", ".join(said) or "none"


def cells(times: Times) -> Iterable[str]:
    """Median, slowest and the order of that."""
    slowest = max(times, key=lambda order: times[order])
    return f"{statistics.median(times.values()):.0f}", f"{times[slowest]:.0f}", slowest


def run(rows: int) -> Result:
    """Measure on both databases."""
    with databases(rows) as opened:
        table = [
            ["who, filters", *(f"{name}, {what}" for name in opened for what in ("median ms", "slowest, ms", "order"))]
        ]
        all_times: dict[tuple[str, bool], list[float]] = {}
        for who, caller in CALLERS.items():
            for filters in FILTERS if who == "anybody" else KEYED:
                row = [f"{who}: {words(filters)}"]
                for name, database in opened.items():
                    times = of_filters(database, filters, caller)
                    row += cells(times)
                    all_times.setdefault((name, "quantity" in filters), []).extend(times.values())
                table.append(row)
                print("  ".join(row), flush=True)
        values = {f"export_s_{name}": _export_s(database) for name, database in opened.items()}
    for name in opened:
        for quantity, word in ((True, "with_a_quantity"), (False, "without")):
            times_of = all_times[name, quantity]
            values |= {
                f"median_ms_{name}_{word}": statistics.median(times_of),
                f"slowest_ms_{name}_{word}": max(times_of),
                f"combinations_{name}_{word}": len(times_of),
                f"slower_{name}_{word}": sum(each > SLOW_MS for each in times_of),
            }
    return Result(
        title="Peaks",
        how=HOW.format(rows=rows, orders=len(ORDERS), few=FEW_CASES, slowest=SLOWEST_KMH, slow=SLOW_MS),
        command="python -m benchmarks.peaks",
        values=values,
        table=table,
    )


def _export_s(database: Database) -> float:
    began = time.perf_counter()
    for _ in as_csv(export(database, PeakFilters())):
        pass
    return time.perf_counter() - began


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--rows", type=int, default=1_000_000)
    publish("peaks", run(parser.parse_args().rows))


if __name__ == "__main__":
    main()
