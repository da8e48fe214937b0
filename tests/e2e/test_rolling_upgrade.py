"""This release and the next on one database: next to each other, across a step of the schema that expands it.

The next release is a copy of this one with one more migration, so no history of the repository is needed.
"""

import shutil
import signal
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import httpx
import pytest
from sqlalchemy import text

from app.db.models import SCHEMA
from app.db.session import Database
from app.serve.service import listen, url_of
from solver.warm import warm
from tests.e2e.conftest import PROGRAM, clean_environment, study, until

ROOT = Path(__file__).parents[2]
MIGRATION = f'''
import sqlalchemy as sa
from alembic import op

revision, down_revision = "9999", "{SCHEMA}"


def upgrade() -> None:
    op.add_column("study", sa.Column("release", sa.String(), nullable=True))
    op.create_index("ix_study_release", "study", ["release"])
'''
MODEL = "    cancel_requested_at: Mapped[float | None]\n"
NEW_MODEL = MODEL + '    release: Mapped[str | None] = mapped_column(default="next", index=True)\n'


class Release:
    """The program, of this release or of another one whose sources lie in a folder."""

    def __init__(self, processes: ExitStack, settings: dict[str, str], sources: Path | None = None) -> None:
        self._processes = processes
        self._environment = clean_environment() | settings
        if sources is not None:
            self._environment |= {"PYTHONPATH": str(sources), "PYTHONSAFEPATH": "1"}

    def _start(self, *arguments: str, pass_fds: tuple[int, ...] = ()) -> subprocess.Popen[bytes]:
        process = subprocess.Popen([*PROGRAM, *arguments], env=self._environment, cwd="/", pass_fds=pass_fds)
        self._processes.enter_context(process)
        self._processes.callback(process.kill)
        return process

    def migrate(self) -> None:
        assert self._start("migrate").wait(timeout=60) == 0

    def worker(self) -> subprocess.Popen[bytes]:
        return self._start("worker")

    def api(self) -> httpx.Client:
        listener = self._processes.enter_context(listen("127.0.0.1", 0))
        self._start("api", "--fd", str(listener.fileno()), pass_fds=(listener.fileno(),))
        return self._processes.enter_context(httpx.Client(base_url=url_of(listener), timeout=60, trust_env=False))


@pytest.fixture
def sources(tmp_path: Path) -> Path:
    """Those of the next release; but for the solver's, which would be compiled anew wherever they lie."""
    folder = tmp_path / "next"
    for package in ("app", "migrations", "worker"):
        shutil.copytree(ROOT / package, folder / package, ignore=shutil.ignore_patterns("__pycache__"))
    (folder / "migrations/versions/9999_next.py").write_text(MIGRATION)
    models = folder / "app/db/models.py"
    before = models.read_text()
    assert before.count(MODEL) == before.count(f'SCHEMA = "{SCHEMA}"') == 1
    models.write_text(before.replace(MODEL, NEW_MODEL).replace(f'SCHEMA = "{SCHEMA}"', 'SCHEMA = "9999"'))
    return folder


@pytest.fixture
def releases(tmp_path: Path, empty_url: str, broker_url: str, sources: Path) -> Iterator[tuple[Release, Release]]:
    warm()
    settings = {"DATA_DIR": str(tmp_path), "DATABASE_URL": empty_url, "BROKER_URL": broker_url, "LEASE_S": "2"}
    settings = {f"TRACKSWEEP_{name}": value for name, value in settings.items()} | {"TRACKSWEEP_WORKER_NICE": "0"}
    with ExitStack() as processes:
        yield Release(processes, settings), Release(processes, settings, sources)


def submit(api: httpx.Client, *speeds: float) -> str:
    return str(api.post("/v1/studies", json=study(*speeds)).raise_for_status().json()["id"])


def computed(api: httpx.Client, study_id: str) -> dict[str, Any]:
    """A study once it has ended, and its peaks."""

    def ended() -> Any:
        found = api.get(f"/v1/studies/{study_id}").raise_for_status().json()
        return found if found["finished_at"] else None

    found = until(ended, 240)
    assert found["state"] == "succeeded"
    peaks = api.get("/v1/peaks", params={"study_id": study_id}).raise_for_status().json()["items"]
    assert peaks
    return found | {"peaks": peaks}


def workers(api: httpx.Client) -> set[int]:
    return {int(each["name"].rpartition(":")[2]) for each in api.get("/v1/queue").json()["workers"]}


@pytest.mark.slow
def test_two_releases_work_side_by_side(releases: tuple[Release, Release], empty_url: str) -> None:
    this, following = releases
    this.migrate()
    old_api, old_worker = this.api(), this.worker()
    before = submit(old_api, 200)
    computed(old_api, before)

    new_api = following.api()
    refused = new_api.get("/readyz")
    assert refused.status_code == 503
    assert "tracksweep migrate" in refused.text

    following.migrate()
    assert [api.get("/readyz").status_code for api in (old_api, new_api)] == [200, 200]
    of_new = submit(new_api, 200, 210)  # the old worker computes what the new API queues
    computed(new_api, of_new)

    new_worker = following.worker()
    both_work = {old_worker.pid, new_worker.pid}
    until(lambda: workers(old_api) == workers(new_api) == both_work, 240)
    both = [submit(api, 220, 230, speed) for api, speed in ((old_api, 240), (new_api, 250))]
    old_worker.send_signal(signal.SIGUSR2)
    assert old_worker.wait(timeout=120) == 0
    of_old = submit(old_api, 260)  # and the new worker what the old one does
    for study_id in (before, of_new, *both, of_old):
        assert computed(old_api, study_id) == computed(new_api, study_id)

    database = Database(empty_url)
    with database.read() as session:
        told = {row.id: row.release for row in session.execute(text("SELECT id, release FROM study"))}
        attempts = session.scalars(text('SELECT attempt FROM "case"')).all()
    database.close()
    assert told == {before: None, of_new: "next", both[0]: None, both[1]: "next", of_old: None}
    assert set(attempts) == {1}
