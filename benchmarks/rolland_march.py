"""A rail on discrete supports by `rolland`, run by its own environment; see :mod:`benchmarks.rolland_peer`.

    PYTHON -m benchmarks.rolland_march

Prints one line of JSON. Nothing but the standard library and rolland is imported here.
"""

import json
import time
from importlib.metadata import version
from typing import Any

from devito import Operator
from rolland import CFSPML, Deflection, DiscrPad, DomSetup, SimplePeriodicSlabSingleRailTrack, deflection
from rolland.database.rail.db_rail import UIC60
from rolland.excitation import RandomForce

SPACING, PADS = 0.65, 216  # m; 140 m of track
FIELDS = 7  # unknowns of the rail at a grid point: three displacements, three rotations, warping
seconds: list[float] = []


class TimedOperator:
    """Devito's operator, applied once to be compiled and once more to be timed."""

    def __init__(self, expressions: list[Any]) -> None:
        self.operator = Operator(expressions)

    def apply(self, **given: Any) -> None:
        """As Devito's."""
        self.operator.apply(**given)
        start = time.perf_counter()
        self.operator.apply(**given)
        seconds.append(time.perf_counter() - start)


def main() -> None:
    """March rolland's default grid and step under a moving force."""
    deflection.Operator = TimedOperator
    pad = DiscrPad(sp_z=6e7, sp_y=6e7, sp_x=6e7, dp_z=5e4, dp_y=5e4, dp_x=5e4, dp_xr=0.0, wdthp=0.16)
    track = SimplePeriodicSlabSingleRailTrack(rail=UIC60, pad=pad, distance=SPACING, num_mount=PADS, z_f=0.076, y_f=0.0)
    domain = DomSetup(track=track, bound=CFSPML(), req_simt=0.1)
    force = RandomForce(v=350 / 3.6, F_stat_z=7e4, F_stat_y=0.0)
    Deflection(discr=domain, excit=force, store="excit")
    found = {
        "seconds": seconds[-1],
        "unknowns": FIELDS * domain.nx,
        "steps": domain.nt,
        "time_step": domain.dt,
        "length": track.l_track,
        "software": ", ".join(f"{name} {version(name)}" for name in ("rolland", "devito")),
    }
    print(json.dumps(found))


if __name__ == "__main__":
    main()
