"""The article's studies through the service: from what is posted to what is kept."""

import os
import platform
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from importlib.metadata import version
from multiprocessing import get_context
from typing import Any

from app.remote import batch
from solver.version import SOLVER_VERSION
from worker.article import strip
from worker.article.reported import LONGEST_M, PERCENTILES, TABLE_1_BAND_M
from worker.article.results import Cases, Curve, Results
from worker.article.studies import Study

SHOWN_S, SHOWN_M = 0.5, 60.0  # of histories and of profiles
SHOWN = ("rail_displacement", "wheel_rail_force")
COMMAND = "tracksweep article"

Tell = Callable[[float, str], None]  # part done, and what was done last


def gather(url: str, wanted: Mapping[str, Study], trials: Sequence[strip.Trial], tell: Tell) -> Results:
    """Compute studies by a service, and what is apart from it.

    Parameters
    ----------
    url : str
        Of the service.
    wanted : mapping of str to dict
        Studies by name.
    trials : sequence
        Experiments with strips.
    tell : callable
        Called with the part done and what that was.
    """
    began, cases = time.monotonic(), {}
    with batch.Service(url) as service:
        for done, (name, study_id) in enumerate(batch.computed(service, wanted), 1):
            cases[name] = Cases.from_rows(batch.peaks(service, study_id))
            tell(done / len(wanted), name)
        profiles = {f"{percentile:g}": _profile(service, percentile) for percentile in PERCENTILES}
        histories = dict(_histories(service, cases))
    served = time.monotonic() - began
    # Fresh processes: a fork would share what Numba and BLAS hold.
    with ProcessPoolExecutor(os.cpu_count(), mp_context=get_context("spawn")) as pool:
        apart = list(pool.map(strip.experiment, trials))
    made = {"seconds": time.monotonic() - began, "seconds_served": served, **_software()}
    return Results(made=made, cases=cases, profiles=profiles, histories=histories, strip=apart)


def _profile(service: Any, percentile: float) -> Curve:
    band = {"min": TABLE_1_BAND_M, "max": LONGEST_M}
    sample = {"kind": "spectrum", "percentile": percentile, "wavelength_band_m": band}
    return _rounded(batch.heights(service, sample, SHOWN_M))


def _histories(service: Any, cases: dict[str, Cases]) -> Iterator[tuple[str, Curve]]:
    for study, axis in (("percentiles", "percentile"), ("bands", "wavelength_min_m")):
        of = cases[study]
        for value, case_id in zip(of[axis], of["case_id"], strict=True):
            for quantity in SHOWN:
                curve = batch.history(service, int(case_id), quantity, "wheelset_1", SHOWN_S)
                yield f"{study}, {value:g}, {quantity}", _rounded(curve)


def _rounded(curve: tuple[list[float], ...]) -> Curve:
    x, y = ([float(f"{value:.6g}") for value in values] for values in curve)
    return x, y


def _software() -> dict[str, str]:
    packages = {name: version(name) for name in ("tracksweep", "numpy", "scipy", "numba")}
    return {
        "command": COMMAND,
        "solver_version": SOLVER_VERSION,
        "software": ", ".join([f"Python {platform.python_version()}", *(f"{k} {v}" for k, v in packages.items())]),
        "cores": str(os.cpu_count()),
    }
