"""Cases that break what computes them, under the real supervisor."""

import sys
from pathlib import Path

from tests.e2e.conftest import served, study
from tests.e2e.poisoned import FILLS, HANGS, HOLDS, KILLS, MEMORY_MB

POISONED = [sys.executable, "-m", "tests.e2e.poisoned"]


def test_poison_fails_with_its_reason_and_takes_no_neighbour_along(tmp_path: Path) -> None:
    """All in one batch: after the first death each is tried alone."""
    limits = {"CASE_TIME_LIMIT_S": "1", "CASE_MEMORY_MB": str(MEMORY_MB), "LEASE_S": "1"}
    environment = {f"TRACKSWEEP_{name}": value for name, value in limits.items()}
    sick, well = [KILLS, HANGS, HOLDS, FILLS], [0.1, 0.3, 0.4]
    body = study(300, window_s=0.05, time_step_s=5e-4)
    body["sweep"]["irregularity"]["amplitude_mm"] = [*sick, *well]
    with served(tmp_path / "data", "--workers", "1", program=POISONED, **environment) as service:
        ended = service.ended(service.submit(body))
        assert (ended["state"], ended["cases"]["succeeded"]) == ("partially_failed", len(well))
        cases = {case["amplitude_mm"]: case for case in service.cases(ended["id"])}
    assert {cases[amplitude]["attempt"] for amplitude in sick} == {3}
    codes = {amplitude: cases[amplitude]["error"]["code"] for amplitude in sick}
    assert codes == {KILLS: "poison", HANGS: "time-limit", HOLDS: "poison", FILLS: "memory-limit"}
    assert "fell silent" in cases[HOLDS]["error"]["detail"]
    assert all(cases[amplitude]["attempt"] <= 2 for amplitude in well)
    # Where it hung is in the log, although the hanging thread never let another one speak.
    assert "in hold" in "".join(log.read_text() for log in (tmp_path / "data" / "logs").glob("worker-*.log"))
