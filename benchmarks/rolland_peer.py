"""A public peer beside ours: `rolland`, finite differences of a rail on discrete supports.

    python -m benchmarks.rolland_peer PYTHON [--rounds N]

``PYTHON`` is that of an environment with rolland; ``make bench-rolland`` makes one.
"""

import argparse
import json
import os
import statistics
import subprocess
import time
from typing import Any

from benchmarks.article import article_case
from benchmarks.results import Result, publish
from solver.block import Block
from solver.track import NODE

FULL, STEPS = 8, 400

HOW = """{software}, compiled by the machine's C compiler, on one core: a rail with seven unknowns per grid point
(vertical, lateral and axial motion, rotations, warping) on pads {spacing:.2f} m apart on a rigid slab, {length:.0f} m
of it, under a moving force, on its default grid and with its default step of {step:.0e} s, as short as an explicit
scheme needs it. Only marching is timed, on its second go. Ours is a whole step with three beams, vehicle, contact and
recording.

It solves other equations than ours and has more of them per metre of rail, so what is compared is the time per unknown
and step, and the time per metre of track and simulated second, which counts the length of the step. Ours takes turns
with it; medians over {rounds} rounds."""


def theirs(python: str) -> dict[str, Any]:
    """One run of rolland."""
    # One thread, and nothing but the result on standard output.
    environment = os.environ | {"OMP_NUM_THREADS": "1", "DEVITO_LOGGING": "ERROR"}
    command = [python, "-m", "benchmarks.rolland_march"]
    done = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)  # noqa: S603
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def run(python: str, rounds: int) -> Result:
    """Time both in turns."""
    blocks = {lanes: Block([article_case()] * lanes) for lanes in (1, FULL)}
    peers, seconds = [], {lanes: [] for lanes in blocks}
    for _ in range(rounds):
        peers.append(theirs(python))
        for lanes, block in blocks.items():
            block.advance(20)
            start = time.perf_counter()
            block.advance(STEPS)
            seconds[lanes].append((time.perf_counter() - start) / STEPS / lanes)
    peer = sorted(peers, key=lambda each: each["seconds"])[rounds // 2]
    case, model = blocks[1].case, blocks[1].model
    unknowns, length = NODE * model.cells * case.numerics.elements_per_pad, model.cells * case.track.pad_spacing
    rows = {"rolland": (peer["seconds"] / peer["steps"], peer["unknowns"], peer["length"], peer["time_step"])}
    for lanes, values in seconds.items():
        name = "ours, all lanes" if lanes == FULL else "ours, one case"
        rows[name] = statistics.median(values), unknowns, length, case.time_step
    per_unknown = {name: 1e9 * step / count for name, (step, count, _, _) in rows.items()}
    per_metre = {name: 1e3 * step / metres / dt for name, (step, _, metres, dt) in rows.items()}
    table = [["", "unknowns", "step, s", "ns per unknown and step", "ms per metre and simulated second"]]
    table += [
        [name, f"{count}", f"{dt:.1e}", f"{per_unknown[name]:.3g}", f"{per_metre[name]:.3g}"]
        for name, (_, count, _, dt) in rows.items()
    ]
    one, full = per_unknown["ours, one case"], per_unknown["ours, all lanes"]
    how = HOW.format(
        software=peer["software"],
        spacing=case.track.pad_spacing,
        length=peer["length"],
        step=peer["time_step"],
        rounds=rounds,
    )
    return Result(
        title="A public peer",
        how=how,
        command="make bench-rolland",
        values={
            "ratio_rolland_per_unknown_full_lanes": per_unknown["rolland"] / full,
            "ratio_rolland_per_unknown_one_case": per_unknown["rolland"] / one,
            "ratio_rolland_per_metre_full_lanes": per_metre["rolland"] / per_metre["ours, all lanes"],
            "ratio_rolland_per_metre_one_case": per_metre["rolland"] / per_metre["ours, one case"],
        },
        table=table,
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("python", help="Python of an environment with rolland")
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    publish("rolland_peer", run(options.python, options.rounds))


if __name__ == "__main__":
    main()
