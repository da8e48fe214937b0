"""What a service of many cores can do, from what the queue sustains: `results/scale.json`.

python -m benchmarks.capacity
"""

from benchmarks.results import RESULTS, Result, publish, read

CORES = (2, 16, 100, 1000, 10_000)
CASE_CPU_S = (0.3, 3.0, 30.0)
HISTORY_MB = 2.0  # of 50 000 samples of ten channels
DAY_S = 86400.0

HOW = """Computed, not measured. Cores that need *t* s of processor time for a case finish cores/*t* cases per second,
until that is what the database sustains on a machine of its own: {server_cores} cores of PostgreSQL, which takes
{server_ms:.1f} ms for each case and {alive_ms:.2f} ms a second for each worker, as `python -m benchmarks.scale` found.
Workers, one per core, say that they live every second, but every {sparing:g} s to a database that is busy. Beyond,
PostgreSQL is the first bottleneck: give it more cores, and `TRACKSWEEP_WRITERS` with them (two for each core were
measured, on two cores), or the table `peak` fewer indexes. A case takes
{kb:.0f} kB of the database; a history of {history:g} MB, if kept, goes to the store."""
SERVER_CORES = 8
SPARING_S = 5.0  # a third of a lease


def _sustained(cores: int, server_ms: float, alive_ms: float) -> float:
    """Cases per second for which PostgreSQL has the time that hearing of so many workers leaves."""
    return max(SERVER_CORES * 1e3 - cores * alive_ms / SPARING_S, 0.0) / server_ms


def run() -> Result:
    """From the kept result."""
    scale, _ = read(RESULTS / "scale.json")
    server_ms, kb = scale.values["postgresql_ms_per_case"], scale.values["database_kb_per_case"]
    alive_ms = scale.values["postgresql_ms_per_worker_and_s"]
    head = [f"{seconds:g} s per case: {what}" for seconds in CASE_CPU_S for what in ("cases a day", "GB a day")]
    table = [["cores that compute", *head, "TB of histories a day, at most"]]
    for cores in CORES:
        row, most, sustained = [f"{cores:,}"], 0.0, _sustained(cores, server_ms, alive_ms)
        for seconds in CASE_CPU_S:
            rate = min(cores / seconds, sustained)
            most = max(most, rate)
            full = "" if rate < sustained else " (PostgreSQL is full)"
            row += [f"{rate * DAY_S:,.0f}{full}", f"{rate * DAY_S * kb / 1e6:,.1f}"]
        table.append([*row, f"{most * DAY_S * HISTORY_MB / 1e6:,.1f}"])
    return Result(
        title="Capacity",
        how=HOW.format(
            server_ms=server_ms,
            alive_ms=alive_ms,
            sparing=SPARING_S,
            server_cores=SERVER_CORES,
            kb=kb,
            history=HISTORY_MB,
        ),
        command="python -m benchmarks.capacity",
        values={f"sustained_cases_per_s_with_{cores}_cores": _sustained(cores, server_ms, alive_ms) for cores in CORES},
        table=table,
    )


if __name__ == "__main__":
    publish("capacity", run())
