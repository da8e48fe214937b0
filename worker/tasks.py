"""What the bell sets off."""

import faulthandler
import os
import signal
import threading
from functools import cache
from typing import TYPE_CHECKING, Any

from celery.signals import worker_init, worker_ready, worker_shutting_down
from celery.worker import state

from app.queue import WORK
from worker import memory
from worker.celery import SETTINGS, app
from worker.sweeper import Sweeper
from worker.unable import UnableWorker

if TYPE_CHECKING:
    from worker.compute import Worker

stopping, draining = threading.Event(), threading.Event()


@cache
def why_unable() -> Exception | None:
    """Why the solver cannot be loaded, if it cannot."""
    try:
        import worker.compute  # noqa: F401, PLC0415
    except Exception as error:
        return error
    return None


@cache
def this_worker() -> "Worker | UnableWorker":
    """The worker that this process is."""
    if (reason := why_unable()) is not None:
        return UnableWorker(SETTINGS, reason)
    from worker.compute import Worker  # noqa: PLC0415

    return Worker(SETTINGS, stopping, draining)


@app.task(name=WORK)  # type: ignore[untyped-decorator]  # Celery has no types
def work() -> None:
    """Compute whatever is queued."""
    this_worker().work()


@worker_init.connect  # type: ignore[untyped-decorator]  # as above
def _heed_draining(**_: Any) -> None:
    signal.signal(signal.SIGUSR2, _drain)


def _drain(*_: object) -> None:
    """Finish the cases at hand, take no others, and end; a SIGTERM that comes meanwhile still puts them back."""
    draining.set()
    state.should_stop = os.EX_OK  # what Celery does at a SIGTERM, without telling `_stop`


@worker_init.connect  # type: ignore[untyped-decorator]  # as above
def _compile(**_: Any) -> None:
    faulthandler.enable()
    if why_unable() is None:
        from solver.warm import warm  # noqa: PLC0415

        warm()  # before this worker says that it is there: no case waits for a compiler


@worker_init.connect  # type: ignore[untyped-decorator]  # as above
def _be_modest(**_: Any) -> None:
    memory.limit_to(SETTINGS.case_memory_mb)
    os.nice(SETTINGS.worker_nice)


@worker_ready.connect  # type: ignore[untyped-decorator]  # as above
def _start(**_: Any) -> None:
    Sweeper(SETTINGS, able=why_unable() is None, draining=draining).start()


@worker_shutting_down.connect  # type: ignore[untyped-decorator]  # as above
def _stop(**_: Any) -> None:
    stopping.set()
