"""Which cases are claimed together, on both databases."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from sqlalchemy import event, select, text, update

from app.db.models import Case, Event, Worker
from app.db.session import Database
from app.studies.schemas import StudyDetail
from worker import lease, presence
from worker.claim import Claim, claim
from worker.sweeper import sweep

Submit = Callable[..., StudyDetail]
TWELVE = [n / 100 for n in range(1, 13)]


def take(database: Database, worker: str = "test", lanes: int = 8) -> list[Claim]:
    with database.write() as session:
        return claim(session, worker, 15.0, lanes)


def announce(database: Database, *names: str) -> None:
    for name in names:
        with database.write() as session:
            presence.announce(session, name, 60.0)


def conditions(database: Database, batch: list[Claim]) -> list[tuple[float, float | None]]:
    """Speed and amplitude of each, in the order of the queue."""
    chosen = Case.id.in_([held.case_id for held in batch])
    with database.read() as session:
        rows = session.execute(select(Case.speed_kmh, Case.amplitude_mm).where(chosen).order_by(Case.id))
        return [(row.speed_kmh, row.amplitude_mm) for row in rows]


def test_cases_of_one_operator_ride_together(database: Database, submit: Submit) -> None:
    submit(250, 300, amplitudes=TWELVE)
    first = take(database)
    assert conditions(database, first) == [(250, amplitude) for amplitude in TWELVE[:8]]
    assert len({held.token for held in first}) == 8
    assert {held.attempt for held in first} == {1}
    assert conditions(database, take(database, lanes=3)) == [(250, amplitude) for amplitude in TWELVE[8:11]]
    assert conditions(database, take(database)) == [(250, TWELVE[11])]
    assert {speed for speed, _ in conditions(database, take(database))} == {300}


def test_axles_elsewhere_do_not_ride_but_another_mass_does(database: Database, submit: Submit) -> None:
    submit(300)
    submit(300, vehicle={"half_wheelbase_m": 1.3})
    submit(300, vehicle={"car_body_mass_kg": 5e4})
    submit(300, vehicle={"car_body_mass_kg": 6e4})
    assert [len(take(database)) for _ in range(3)] == [3, 1, 0]


def test_a_study_is_said_to_run_once(database: Database, submit: Submit) -> None:
    studies = [submit(300, amplitudes=amplitudes) for amplitudes in ([0.1, 0.2], [0.2, 0.3], [0.4])]
    assert len(take(database)) == 4
    with database.read() as session:
        running = select(Event.study_id).where(Event.payload["state"].as_string() == "running")
        assert sorted(session.scalars(running)) == sorted(study.id for study in studies)


def test_priority_decides_who_is_next_and_who_rides(database: Database, submit: Submit) -> None:
    submit(250, amplitudes=[0.1, 0.2])
    submit(300, priority=1)
    submit(250, amplitudes=[0.3, 0.4])
    submit(250, amplitudes=[0.5, 0.6, 0.7], priority=2)
    claimed = [conditions(database, take(database)) for _ in range(3)]
    assert claimed[:2] == [[(250, 0.5), (250, 0.6), (250, 0.7)], [(300, 0.1)]]
    assert claimed[2] == [(250, amplitude) for amplitude in (0.1, 0.2, 0.3, 0.4)]


def test_who_was_tried_before_is_alone(database: Database, submit: Submit) -> None:
    submit(300, amplitudes=TWELVE[:3])
    assert len(take(database)) == 3
    with database.write() as session:  # the worker dies
        session.execute(update(Case).values(lease_expires=0.0))
    with database.write() as session:
        sweep(session, max_attempts=3)
    submit(300, amplitudes=TWELVE[3:5])
    batches = [take(database) for _ in range(4)]
    assert sorted([held.attempt for held in batch] for batch in batches) == [[1, 1], [2], [2], [2]]


def test_who_was_put_back_rides_again(database: Database, submit: Submit) -> None:
    submit(300, amplitudes=TWELVE[:3])
    for _ in range(2):
        batch = take(database)
        assert [held.attempt for held in batch] == [1, 1, 1]
        with database.write() as session:
            assert all(lease.release(session, held) for held in batch)


@pytest.mark.parametrize(("cases", "shares"), [(2, [1, 1]), (4, [1, 1]), (5, [5, 0]), (12, [8, 4])])
def test_two_workers_share(database: Database, submit: Submit, cases: int, shares: list[int]) -> None:
    announce(database, "one", "two")
    submit(300, amplitudes=TWELVE[:cases])
    assert [len(take(database, worker)) for worker in ("one", "two")] == shares


def test_a_worker_that_is_gone_has_no_share(database: Database, submit: Submit) -> None:
    announce(database, "one", "two")
    with database.write() as session:
        session.execute(update(Worker).where(Worker.name == "two").values(expires=0.0))
    submit(300, amplitudes=TWELVE[:8])
    assert len(take(database, "one")) == 8
    with database.write() as session:
        sweep(session, max_attempts=3)
        assert session.scalars(select(Worker.name)).all() == ["one"]


@pytest.mark.parametrize("database_url", ["postgresql"], indirect=True)
def test_what_waits_is_read_in_its_order_and_never_sorted(database: Database, submit: Submit) -> None:
    """By a PostgreSQL that knows nothing of the rows yet, nor of the versions and operators they have."""
    submit(250, 300, amplitudes=[n / 1000 for n in range(1, 201)])
    asked = []

    @event.listens_for(database.engine, "before_cursor_execute")
    def listen(_: Any, cursor: Any, statement: str, parameters: Any, *more: Any) -> None:
        if "SKIP LOCKED" in statement:
            asked.append((statement, parameters))

    assert len(take(database)) == 8
    first, riding = asked
    with database.read() as session:
        for statement, parameters in (first, riding):
            plan = session.connection().exec_driver_sql(f"EXPLAIN {statement}", parameters).scalars().all()
            assert any("Index Scan using ix_case" in line for line in plan)
            assert not any("Sort" in line for line in plan), plan


def test_two_who_claim_at_once_take_different_cases(database: Database, submit: Submit) -> None:
    names = [f"worker {n}" for n in range(4)]
    announce(database, *names)
    for n in range(5):
        submit(200 + n, amplitudes=TWELVE[:8])
        with ThreadPoolExecutor(4) as pool:
            batches = list(pool.map(lambda name: take(database, name), names))
        assert [len(batch) for batch in batches] == [1, 1, 1, 1]
        assert len({held.case_id for batch in batches for held in batch}) == 4


def test_studies_take_turns(database: Database, submit: Submit) -> None:
    submit(*range(200, 240))
    for _ in range(5):
        take(database)
    submit(*range(300, 303))
    submit(*range(400, 402))
    speeds = [speed for _ in range(9) for speed, _ in conditions(database, take(database))]
    assert speeds == [205, 300, 400, 206, 301, 401, 207, 302, 208]


def test_a_share_in_what_waits_is_not_lost_behind_it(database: Database, submit: Submit) -> None:
    submit(*range(200, 240))
    submit(239, 300)  # all but one of its own
    speeds = [speed for _ in range(4) for speed, _ in conditions(database, take(database))]
    assert speeds == [200, 239, 201, 300]


def test_turns_go_on_where_nothing_waits_any_more(database: Database, submit: Submit) -> None:
    submit(*range(200, 203))
    held = [take(database)[0] for _ in range(3)]
    submit(300, 301)
    with database.write() as session:
        assert lease.release(session, held[2])
    assert [conditions(database, take(database))[0][0] for _ in range(3)] == [202, 300, 301]


def test_the_next_case_is_found_in_the_index(database: Database, submit: Submit) -> None:
    """Whatever the length of the queue."""
    submit(*range(200, 210))
    next_case = "SELECT id FROM \"case\" WHERE state = 'queued' ORDER BY priority DESC, turn, id LIMIT 1"
    with database.write() as session:
        if session.get_bind().dialect.name == "postgresql":
            session.execute(text("SET LOCAL enable_seqscan = off"))  # the table is small
            plan = "EXPLAIN"
        else:
            plan = "EXPLAIN QUERY PLAN"
        lines = [str(row) for row in session.execute(text(f"{plan} {next_case}"))]
    assert any("ix_case_queue" in line for line in lines)
    assert not any("TEMP B-TREE" in line or "Sort" in line for line in lines)
