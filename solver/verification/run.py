"""Run checks side by side, one per processor core."""

import os
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from multiprocessing import get_context

from solver.verification.finding import Check, Finding


def run_checks(checks: Sequence[Check], processes: int | None = None) -> Iterator[tuple[Check, Finding, float]]:
    """Findings, each with its processor time in s, as they come.

    Parameters
    ----------
    checks : sequence of Check
    processes : int, optional
        As many as there are cores unless given.
    """
    # Fresh processes: a fork would share what Numba and BLAS hold.
    with ProcessPoolExecutor(processes or os.cpu_count(), mp_context=get_context("spawn")) as pool:
        futures = {pool.submit(_timed, check): check for check in checks}
        for future in as_completed(futures):
            finding, seconds = future.result()
            yield futures[future], finding, seconds


def _timed(check: Check) -> tuple[Finding, float]:
    began = time.process_time()
    return check.run(), time.process_time() - began
