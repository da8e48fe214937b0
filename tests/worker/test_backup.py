"""Backups as docs/operations.md describes them: its commands are run while the service works, and what they restore is
compared with what was there.
"""

import os
import re
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sqlalchemy import delete

from app.context import Context
from app.db.models import Peak
from app.db.session import Database
from app.settings import Settings
from app.studies.schemas import StudyDetail
from tests.app.conftest import serving
from tests.conftest import BINARIES, Postgres
from worker.claim import claim
from worker.compute import Worker
from worker.sweeper import sweep

Submit = Callable[..., StudyDetail]
DOCUMENT = Path(__file__).parents[2] / "docs/operations.md"
COMMANDS = dict(re.findall(r"^```sh (\S+)\n(.*?)^```", DOCUMENT.read_text(), re.DOTALL | re.MULTILINE))


def run(name: str, folder: Path, **variables: str) -> None:
    """Run the commands of the document that have this name."""
    path = os.pathsep.join([str(Path(sys.executable).parent), str(BINARIES), os.environ["PATH"]])
    done = subprocess.run(
        ["sh", "-euc", COMMANDS[name]],
        env=os.environ | {"PATH": path} | variables,
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr


def answers(settings: Settings) -> dict[str, Any]:
    """What the service says of everything there is."""
    paths = ["/v1/studies", "/v1/peaks?page_size=50"]
    with serving(settings) as client:
        studies = client.get("/v1/studies").json()["items"]
        for study in studies:
            cases = client.get(f"/v1/studies/{study['id']}/cases").json()["items"]
            paths += [f"/v1/studies/{study['id']}", *(f"/v1/cases/{case['id']}" for case in cases)]
            paths += [f"/v1/cases/{case['id']}/history" for case in cases if case["state"] == "succeeded"]
        found = {path: client.get(path) for path in paths}
    assert all(answer.status_code == 200 for answer in found.values())
    return {path: answer.json() for path, answer in found.items()}


def test_a_restored_backup_is_the_service_as_it_was(
    context: Context, submit: Submit, postgres: Postgres, tmp_path: Path
) -> None:
    submit(200, 210, name="computed", keep_history=True)
    drain(context.settings)
    submit(220, name="at work", keep_history=True)
    with context.database.write() as session:
        claim(session, "a machine that is lost with all that it computes", 0.0)
    expected = answers(context.settings)

    kind, desk = context.database.engine.name, tmp_path / "desk"
    desk.mkdir()
    (desk / "data").symlink_to(context.settings.data_dir)
    with context.database.engine.connect() as connection:  # somebody is about to write, and then does not
        connection.execute(delete(Peak))
        run(f"backup-{kind}", desk, DATABASE=driverless(context.settings.database_url))
        connection.rollback()

    url = "" if kind == "sqlite" else postgres.create_database()
    run(f"restore-{kind}", desk, RESTORED=driverless(url))
    broker_url = f"redis+socket://{tmp_path}/nobody"
    restored = Settings(data_dir=desk / "restored", database_url=url, broker_url=broker_url, lease_s=2.0)
    assert answers(restored) == expected

    database = Database(restored.resolved_database_url)
    with database.write() as session:
        assert sweep(session, max_attempts=3)
    database.close()
    drain(restored)
    assert {study["state"] for study in answers(restored)["/v1/studies"]["items"]} == {"succeeded"}


def drain(settings: Settings) -> None:
    """Compute whatever is queued."""
    worker = Worker(settings, threading.Event())
    worker.work()
    worker.database.close()


def driverless(url: str) -> str:
    """A URL as the tools of PostgreSQL take it."""
    return url.replace("+psycopg", "")
