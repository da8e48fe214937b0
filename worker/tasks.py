"""What the bell sets off."""

import os
import threading
from functools import cache
from typing import Any

from celery.signals import worker_init, worker_ready, worker_shutting_down

from app import log
from app.queue import WORK
from solver.warm import warm
from worker.celery import SETTINGS, app
from worker.compute import Worker
from worker.sweeper import Sweeper

POLITENESS = 10  # where a machine is shared, requests are answered first

stopping = threading.Event()


@cache
def this_worker() -> Worker:
    """The worker that this process is."""
    return Worker(SETTINGS, stopping)


@app.task(name=WORK)  # type: ignore[untyped-decorator]  # Celery has no types
def work() -> None:
    """Compute whatever is queued."""
    this_worker().drain()


@worker_init.connect  # type: ignore[untyped-decorator]  # as above
def _prepare(**_: Any) -> None:
    warm()  # before this worker says that it is there: no case waits for a compiler
    os.nice(POLITENESS)


@worker_ready.connect  # type: ignore[untyped-decorator]  # as above
def _start(**_: Any) -> None:
    log.configure()
    Sweeper(SETTINGS).start()


@worker_shutting_down.connect  # type: ignore[untyped-decorator]  # as above
def _stop(**_: Any) -> None:
    stopping.set()
