"""What the harness plants in the processes of the service: named points to die at, a slow disk, another clock.

Python imports a module of this name at its start, and the harness puts this folder first on PYTHONPATH. So the service
itself holds nothing that only tests need.
"""

import os
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

CONTROL = Path(os.environ["CHAOS_CONTROL"])
SLOW_S = 0.5
PART = next((word for word in sys.orig_argv if word in ("serve", "api", "worker")), "")


def die_if_asked(point: str) -> None:
    """Whoever takes the request to die at a point away, dies."""
    try:
        os.rename(CONTROL / point, CONTROL / f"{point}.{os.getpid()}")
    except FileNotFoundError:
        return
    os.kill(os.getpid(), signal.SIGKILL)


def pause_if_asked(*_: object) -> None:
    """Take as long as a slow disk would."""
    if (CONTROL / "slow").exists():
        time.sleep(SLOW_S)


def replace(owner: Any, name: str, new: Any) -> None:
    """Put something in the place of what must be there."""
    getattr(owner, name)
    setattr(owner, name, new)


def wrap(
    owner: Any, name: str, before: Callable[[], None] = lambda: None, then: Callable[[], None] = lambda: None
) -> None:
    """Do something before a function, and after it if it did anything."""
    original = getattr(owner, name)

    def wrapped(*args: Any, **kwargs: Any) -> Any:
        before()
        result = original(*args, **kwargs)
        if result is None or result:
            then()
        return result

    setattr(owner, name, wrapped)


def prepare_clock() -> None:
    """Begin anew with a clock that the harness can set: the real time plus what stands in a file."""
    library, file = os.environ.get("CHAOS_FAKETIME"), CONTROL / os.environ["CHAOS_CLOCK"].format(pid=os.getpid())
    if library is None or "LD_PRELOAD" in os.environ:
        return
    if not file.exists():
        file.write_text("+0")
    options = {"FAKETIME_CACHE_DURATION": "1", "FAKETIME_DONT_FAKE_MONOTONIC": "1", "NO_FAKE_STAT": "1"}
    options["FAKETIME_FORCE_MONOTONIC_FIX"] = "0"  # or threads that wait for Python's lock spin, and all takes thrice
    clock = {"LD_PRELOAD": library, "FAKETIME_TIMESTAMP_FILE": str(file)} | options
    os.execve(sys.executable, sys.orig_argv, os.environ | clock)


def prepare_disk() -> None:
    from sqlalchemy import Engine, event  # noqa: PLC0415

    from app.storage import HistoryStore  # noqa: PLC0415

    event.listen(Engine, "commit", pause_if_asked)
    wrap(HistoryStore, "put", before=pause_if_asked)


def prepare_api() -> None:
    from app.queue import Doorbell  # noqa: PLC0415

    wrap(Doorbell, "ring", before=lambda: die_if_asked("api-between-commit-and-bell"))


def prepare_worker() -> None:
    from app.storage import HistoryStore  # noqa: PLC0415
    from worker.compute import Worker  # noqa: PLC0415

    wrap(Worker, "_claim", then=lambda: die_if_asked("worker-after-claim"))
    wrap(HistoryStore, "put", then=lambda: die_if_asked("worker-between-object-and-commit"))
    wrap(Worker, "_write_together", then=lambda: die_if_asked("worker-after-commit"))
    if "CHAOS_WITHOUT_TOKENS" in os.environ:
        forget_tokens()


def forget_tokens() -> None:
    """The control: whoever ever claimed a case may write to it."""
    from sqlalchemy import select, update  # noqa: PLC0415

    from app.db.models import Case  # noqa: PLC0415
    from worker import lease, success  # noqa: PLC0415

    def change(session: Any, held: Any, values: dict[str, Any]) -> bool:
        row = update(Case).where(Case.id == held.case_id)
        return session.scalar(row.values(values).returning(Case.id)) is not None

    def lock(session: Any, leases: Any) -> dict[int, Any]:
        columns = select(Case.id, Case.speed_kmh, Case.percentile)
        return {row.id: row for row in session.execute(columns.where(Case.id.in_([held.case_id for held in leases])))}

    replace(lease, "_change", change)
    for module in (lease, success):
        replace(module, "lock", lock)


def prepare_supervisor() -> None:
    from app.serve import supervisor  # noqa: PLC0415

    supervisor.LONGEST_PAUSE_S = supervisor.FIRST_PAUSE_S  # a part that is killed often is not to blame here


def prepare() -> None:
    if PART == "serve":
        prepare_supervisor()
    elif PART:
        if PART == "worker" or os.environ["CHAOS_CLOCK"] == "clock":
            prepare_clock()
        prepare_disk()
        prepare_api() if PART == "api" else prepare_worker()


try:
    prepare()
except Exception as error:  # after which Python would begin all the same, with nothing planted
    raise SystemExit(f"nothing planted: {error!r}") from error
