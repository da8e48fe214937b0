"""Several hosts: one is cut off, one dies, and it costs time only."""

import signal

import pytest
from sqlalchemy import func, select

from app.db.models import Case, Peak
from app.db.session import Database
from tests.cluster import cluster
from tests.e2e.conftest import study, until

CASES = 24
PATIENCE_S = 240.0


@pytest.mark.slow
def test_a_host_that_is_cut_off_and_one_that_dies_cost_time_only() -> None:
    with cluster(4, TRACKSWEEP_LEASE_S="3") as made:
        database = Database(made.local_url)
        workers = [made.start_worker(host) for host in made.others]

        def holders() -> set[str]:
            return {worker["name"] for worker in made.workers() if worker["running"]}

        def submit(slowest: float) -> str:
            request = study(*(slowest + n for n in range(CASES)), window_s=5.0)
            return str(made.http.post("/v1/studies", json=request).raise_for_status().json()["id"])

        def ended(study_id: str) -> bool:
            return made.http.get(f"/v1/studies/{study_id}").json()["finished_at"] is not None

        name_of = {host.name: f"vm:{process.pid}" for host, process in zip(made.others, workers, strict=True)}
        until(lambda: len(made.workers()) == len(workers), PATIENCE_S)
        first = submit(200.0)
        until(lambda: len(holders()) == len(workers), PATIENCE_S)
        apart, dead = made.others[:2]
        apart.cut_off()
        workers[1].send_signal(signal.SIGKILL)
        until(lambda: ended(first), PATIENCE_S)
        with database.read() as session:
            tried = {row.id: row.attempt for row in session.execute(select(Case.id, Case.attempt))}
            peaks = session.scalars(select(func.count()).select_from(Peak).group_by(Peak.case_id)).all()
        assert len(tried) == len(peaks) == CASES
        assert len(set(peaks)) == 1
        assert sorted(tried.values())[-2:] == [2, 2]  # what the two had begun
        apart.reconnect()
        second = submit(300.0)
        until(lambda: ended(second), PATIENCE_S)
        with database.read() as session:
            again = session.execute(select(Case.id, Case.attempt).where(Case.id.in_(tried)))
            assert {row.id: row.attempt for row in again} == tried
            by = set(session.scalars(select(Case.worker).where(Case.id.not_in(tried))))
        assert any(name_of[apart.name] == name for name in by)
        assert not any(name_of[dead.name] == name for name in by)
        database.close()
