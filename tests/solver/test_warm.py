"""Compiling ahead."""

import subprocess
import sys

PROGRAM = """
from dataclasses import replace
from solver.case import Case, Harmonic, Numerics
from solver.catalogue import TRACKS, VEHICLES
from solver.march import march
from solver.simulate import Response, solve
from solver.warm import warm

warm()
warmed = march.signatures
assert len(warmed) == 2, warmed
case = Case(
    speed=80.0,
    irregularity=Harmonic(wavelength=1.0, amplitude=1e-4),
    track=TRACKS["crts2"].values,
    vehicle=VEHICLES["crh3"].values,
    numerics=Numerics(settle=0.3, window=0.02),
)
for slab in ("continuous", "discontinuous"):
    for cases in (1, 3):
        assert all(isinstance(outcome, Response) for outcome in solve([replace(case, slab=slab)] * cases))
assert march.signatures == warmed, march.signatures
"""


def test_nothing_is_left_to_compile_when_a_worker_has_warmed_up() -> None:
    """In a process of its own, as other tests compile other widths."""
    subprocess.run([sys.executable, "-c", PROGRAM], check=True, timeout=280)
