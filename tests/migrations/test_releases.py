"""Databases of releases, as ``record.py`` keeps them: upgraded, read, gone on with, and taken back."""

import json
import sqlite3
import subprocess
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from alembic import command
from sqlalchemy import inspect, select, text
from typer.testing import CliRunner

import migrations
from app.cases.repository import row_of
from app.cases.schemas import CaseFile
from app.db.models import Case, StudyCase
from app.db.session import Database
from app.settings import Settings
from app.studies import service
from solver.case import Case as SolverCase
from solver.version import SOLVER_VERSION
from tests.app.conftest import serving
from tests.conftest import BINARIES
from tests.e2e.conftest import tracksweep
from tests.migrations.record import DATABASES
from worker.claim import claim
from worker.cli import program
from worker.sweeper import sweep

RELEASES = sorted(folder.name for folder in DATABASES.iterdir())
the_first = pytest.mark.parametrize("release", RELEASES[:1], indirect=True)


@pytest.fixture(params=RELEASES)
def release(request: pytest.FixtureRequest) -> Path:
    return DATABASES / str(request.param)


@pytest.fixture
def old_url(release: Path, empty_url: str) -> str:
    """URL of a release's database, of either kind."""
    kind = empty_url.partition(":")[0].partition("+")[0]
    dump = release / f"{kind}.sql"
    if kind == "sqlite":
        with closing(sqlite3.connect(empty_url.removeprefix("sqlite:///"))) as database:
            database.executescript(dump.read_text())
    else:
        psql = [BINARIES / "psql", "--quiet", "-v", "ON_ERROR_STOP=1", "-f", dump, empty_url.replace("+psycopg", "")]
        subprocess.run(psql, check=True, stdout=subprocess.DEVNULL)
    return empty_url


def contents(url: str) -> dict[str, list[dict[str, Any]]]:
    """All rows of all tables."""
    database = Database(url)
    with database.read() as session:
        tables = inspect(session.connection()).get_table_names()
        rows = {name: session.execute(text(f'SELECT * FROM "{name}"')).mappings().all() for name in tables}
    database.close()
    return {name: sorted((dict(row) for row in found), key=repr) for name, found in rows.items()}


def agrees(old: Any, new: Any) -> bool:
    """Whether an answer says at least what it said before."""
    if isinstance(old, dict):
        return isinstance(new, dict) and all(name in new and agrees(old[name], new[name]) for name in old)
    if isinstance(old, list):
        return isinstance(new, list) and len(old) == len(new) and all(map(agrees, old, new))
    return bool(old == new)


def test_old_studies_are_read_and_every_row_survives_the_way_there_and_back(
    release: Path, old_url: str, tmp_path: Path
) -> None:
    kind = old_url.partition(":")[0].partition("+")[0]
    before = contents(old_url)
    ((revision,),) = (row.values() for row in before["alembic_version"])
    migrations.upgrade(old_url)
    settings = Settings(data_dir=tmp_path, database_url=old_url, broker_url=f"redis+socket://{tmp_path}/nobody")
    with serving(settings) as client:
        for path, old in json.loads((release / f"{kind}.json").read_text()).items():
            answer = client.get(path)
            assert answer.status_code == 200, f"{path}: {answer.text}"
            assert agrees(old, answer.json()), f"{path}: {answer.text}"
    with migrations.transaction(old_url) as connection:
        command.downgrade(migrations.config_for(connection), revision)
    assert contents(old_url) == before


def test_what_was_queued_is_computed_under_the_present_version(old_url: str) -> None:
    """Or numbers of one solver would stand under the version of another."""
    migrations.upgrade(old_url)
    database = Database(old_url)
    with database.write() as session:
        queued = select(Case).where(Case.state == "queued")
        old = session.scalars(queued).one()
        if old.solver_version != SOLVER_VERSION:
            assert claim(session, "test", 15.0) == []
        sweep(session, max_attempts=3)
        session.refresh(old)
        expected = row_of(SolverCase.from_dict(old.inputs), priority=0)
        assert {name: getattr(old, name) for name in expected} == expected
        assert [held.case_id for held in claim(session, "test", 15.0)] == [old.id]
    database.close()


@the_first
def test_what_a_newer_study_has_too_is_not_computed_twice(old_url: str) -> None:
    migrations.upgrade(old_url)
    database = Database(old_url)
    with database.write() as session:
        old = session.scalars(select(Case).where(Case.state == "queued")).one()
        old.solver_version = "1"
        session.flush()
        twin = Case(**row_of(SolverCase.from_dict(old.inputs), priority=0))
        session.add(twin)
        session.flush()
        sweep(session, max_attempts=3)
        session.refresh(old)
        assert (old.state, old.error and old.error["code"]) == ("failed", "solver-changed")
        assert [held.case_id for held in claim(session, "test", 15.0)] == [twin.id]
        study = session.scalars(select(StudyCase.study_id).where(StudyCase.case_id == old.id)).one()
        assert service.get(session, study).state == "failed"
    database.close()


def test_a_case_of_a_newer_solver_waits_for_who_knows_it(database: Database) -> None:
    with database.write() as session:
        file = CaseFile.model_validate({"speed_kmh": 300, "irregularity": {"kind": "none"}})
        case = Case(**row_of(file.to_case(), priority=0) | {"solver_version": f"{int(SOLVER_VERSION) + 1}"})
        session.add(case)
        session.flush()
        sweep(session, max_attempts=3)
        session.refresh(case)
        assert case.state == "queued"
        assert claim(session, "test", 15.0) == []


def test_solvers_of_two_versions_compute_cases_of_their_own(
    database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    old_version = f"{int(SOLVER_VERSION) - 1}"

    def claim_by(version: str) -> list[int]:
        monkeypatch.setattr("worker.claim.SOLVER_VERSION", version)
        with database.write() as session:
            return [held.case_id for held in claim(session, f"of version {version}", 15.0, lanes=1)]

    with database.write() as session:
        for speed in (300, 310):
            file = CaseFile.model_validate({"speed_kmh": speed, "irregularity": {"kind": "none"}})
            session.add(Case(**row_of(file.to_case(), priority=0) | {"solver_version": old_version}))
    begun = claim_by(old_version)
    assert claim_by(SOLVER_VERSION) == []
    with database.write() as session:
        sweep(session, max_attempts=3)  # of a new worker: what is queued becomes its own
    assert claim_by(old_version) == []
    taken = claim_by(SOLVER_VERSION)
    with database.read() as session:
        versions = dict(session.execute(select(Case.id, Case.solver_version)).all())
    assert versions == dict.fromkeys(begun, old_version) | dict.fromkeys(taken, SOLVER_VERSION)
    assert len(versions) == 2


@the_first
def test_a_long_reader_ends_the_upgrade_and_not_the_other_way_round(
    old_url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On SQLite, where readers are in nobody's way, it is a writer."""
    before = contents(old_url)
    monkeypatch.setattr(migrations, "LOCK_TIMEOUT_MS", 300)
    monkeypatch.setattr("app.db.session.BUSY_TIMEOUT_MS", 300)
    database = Database(old_url)
    reader = database.write() if database.engine.name == "sqlite" else database.read()
    environment = {"TRACKSWEEP_DATA_DIR": str(tmp_path), "TRACKSWEEP_DATABASE_URL": old_url}
    with reader as session:
        session.execute(text('SELECT * FROM "case"'))
        blocked = CliRunner().invoke(program, ["migrate"], env=environment)
        assert contents(old_url) == before
    assert blocked.exit_code == 1
    assert "nothing was changed" in blocked.stderr
    assert "lock" in blocked.stderr
    assert "Traceback" not in blocked.output
    assert CliRunner().invoke(program, ["migrate"], env=environment).exit_code == 0
    database.close()


def test_a_statement_without_end_is_given_up(empty_url: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if not empty_url.startswith("postgresql"):
        return  # SQLite knows no time-out of statements
    monkeypatch.setattr(migrations, "STATEMENT_TIMEOUT_MS", 300)
    with pytest.raises(migrations.BlockedError), migrations.transaction(empty_url) as connection:
        connection.execute(text("SELECT pg_sleep(60)"))


@the_first
def test_two_programs_migrate_at_once(old_url: str, tmp_path: Path) -> None:
    variables = {"TRACKSWEEP_DATA_DIR": str(tmp_path), "TRACKSWEEP_DATABASE_URL": old_url}
    with ThreadPoolExecutor(2) as pool:
        both = list(pool.map(lambda _: tracksweep("migrate", **variables), range(2)))
    assert [done.returncode for done in both] == [0, 0], both
    with migrations.transaction(old_url) as connection:
        command.check(migrations.config_for(connection))
