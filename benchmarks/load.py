"""How quickly the API answers while both workers compute.

python -m benchmarks.load [--clients N] [--turns N] [--pause S] [--api-processes N]
"""

import argparse
import time
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import httpx
import numpy as np

from benchmarks.results import Result, publish
from benchmarks.served import served, submit
from benchmarks.service import study

BUSY = study(64, {"settle_s": 0.5, "window_s": 3.0})
CASES = 100  # of every study that a client creates

HOW = """`tracksweep serve` with two workers, both computing all the time, and {processes} processes that answer.
{clients} clients at once take {turns} turns each: in every turn they list studies and peaks, get a study, its cases
and one case, and in every fifth they create a study of {cases} new cases. Between two requests a client thinks for
{pause:g} s on average. Milliseconds are from request to answer, over one connection per client."""


def harmonic(cases: int, salt: float) -> dict[str, Any]:
    """A study of as many cases that nobody has asked for before."""
    amplitudes = [round(1e-4 + 1e-6 * n + salt, 12) for n in range(cases)]
    irregularity = {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": amplitudes}
    sweep = {"kind": "product", "speed_kmh": [300], "irregularity": irregularity}
    return {"name": f"{cases} cases", "sweep": sweep, "priority": -1}


def ask(url: str, study_id: str, client: int, turns: int, pause: float) -> dict[str, list[float]]:
    """Take a client's turns; seconds by operation."""
    rng = np.random.default_rng(client)
    seconds: dict[str, list[float]] = defaultdict(list)
    with httpx.Client(base_url=url, trust_env=False, timeout=60) as http:

        def call(name: str, method: str, path: str, **more: Any) -> Any:
            time.sleep(rng.exponential(pause))
            began = time.perf_counter()
            answer = http.request(method, path, **more)
            seconds[name].append(time.perf_counter() - began)
            return answer.raise_for_status().json()

        for turn in range(turns):
            call("list_studies", "GET", "/v1/studies")
            call("get_study", "GET", f"/v1/studies/{study_id}")
            cases = call("list_cases", "GET", f"/v1/studies/{study_id}/cases")["items"]
            call("get_case", "GET", f"/v1/cases/{cases[turn % len(cases)]['id']}")
            call("list_peaks", "GET", "/v1/peaks", params={"quantity": "wheel_rail_force", "sort": "-peak"})
            if (turn + client) % 5 == 0:
                body = harmonic(CASES, 1e-3 * (client + 1) + 1e-8 * (turn + 1))
                call(f"create_study of {CASES} cases", "POST", "/v1/studies", json=body)
    return seconds


def run(clients: int, turns: int, pause: float, processes: int) -> Result:
    """Load a service."""
    with served(2, TRACKSWEEP_API_PROCESSES=str(processes)) as url:
        busy = submit(url, BUSY)
        while httpx.get(f"{url}/v1/studies/{busy}", trust_env=False).json()["cases"]["running"] == 0:
            time.sleep(0.2)
        with ThreadPoolExecutor(clients) as pool:
            asked = list(pool.map(lambda client: ask(url, busy, client, turns, pause), range(clients)))
    seconds = {name: 1e3 * np.concatenate([each[name] for each in asked]) for name in asked[0]}
    table = [["operation", "times", "median, ms", "95 %, ms", "largest, ms"]]
    for name, values in seconds.items():
        middle, high = np.quantile(values, [0.5, 0.95])
        table.append([name, str(len(values)), f"{middle:.0f}", f"{high:.0f}", f"{values.max():.0f}"])
    reads = np.concatenate([values for name, values in seconds.items() if "create" not in name])
    creates = next(values for name, values in seconds.items() if "create" in name)
    return Result(
        title="Answers under load",
        how=HOW.format(processes=processes, clients=clients, turns=turns, pause=pause, cases=CASES),
        command="python -m benchmarks.load",
        values={
            "p95_read_ms": float(np.quantile(reads, 0.95)),
            "p95_create_100_cases_ms": float(np.quantile(creates, 0.95)),
        },
        table=table,
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--clients", type=int, default=20)
    parser.add_argument("--turns", type=int, default=20)
    parser.add_argument("--pause", type=float, default=0.5, help="seconds between two requests of a client")
    parser.add_argument("--api-processes", type=int, default=2)
    options = parser.parse_args()
    publish("load", run(options.clients, options.turns, options.pause, options.api_processes))


if __name__ == "__main__":
    main()
