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
{server_ms:.1f} ms for each case, as `python -m benchmarks.scale` found. Beyond, PostgreSQL is the first bottleneck:
give it more cores, or the table `peak` fewer indexes. A case takes {kb:.0f} kB of the database; a history of
{history:g} MB, if kept, goes to the store."""
SERVER_CORES = 8


def run() -> Result:
    """From the kept result."""
    scale, _ = read(RESULTS / "scale.json")
    server_ms, kb = scale.values["postgresql_ms_per_case"], scale.values["database_kb_per_case"]
    sustained = SERVER_CORES * 1e3 / server_ms
    head = [f"{seconds:g} s per case: {what}" for seconds in CASE_CPU_S for what in ("cases a day", "GB a day")]
    table = [["cores that compute", *head, "TB of histories a day, at most"]]
    for cores in CORES:
        row, most = [f"{cores:,}"], 0.0
        for seconds in CASE_CPU_S:
            rate = min(cores / seconds, sustained)
            most = max(most, rate)
            full = "" if rate < sustained else " (PostgreSQL is full)"
            row += [f"{rate * DAY_S:,.0f}{full}", f"{rate * DAY_S * kb / 1e6:,.1f}"]
        table.append([*row, f"{most * DAY_S * HISTORY_MB / 1e6:,.1f}"])
    return Result(
        title="Capacity",
        how=HOW.format(server_ms=server_ms, server_cores=SERVER_CORES, kb=kb, history=HISTORY_MB),
        command="python -m benchmarks.capacity",
        values={"sustained_cases_per_s": sustained}
        | {f"cores_at_which_postgresql_is_full_at_{seconds:g}_s": sustained * seconds for seconds in CASE_CPU_S},
        table=table,
    )


if __name__ == "__main__":
    publish("capacity", run())
