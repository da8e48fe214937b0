"""The Celery application: listens for the bell. ``celery -A worker.celery worker``, or ``tracksweep worker``."""

from typing import Any

from celery import Celery
from celery.signals import setup_logging

from app import log
from app.queue import broker_client
from app.settings import Settings

SETTINGS = Settings()

app: Celery = broker_client(SETTINGS)
app.conf.update(
    imports=["worker.tasks"],
    worker_pool="solo",  # one process, one batch at a time: nothing is forked, and a crash takes nothing else along
    worker_concurrency=1,
    worker_prefetch_multiplier=1,
    worker_enable_remote_control=False,  # whoever reaches the broker may ring, and that is all
    broker_connection_retry_on_startup=True,
    broker_connection_max_retries=None,
    broker_channel_error_retry=True,  # as of a broker whose disk is full
    worker_cancel_long_running_tasks_on_connection_loss=False,  # the case is leased from the database
    worker_hijack_root_logger=False,
)


@setup_logging.connect  # type: ignore[untyped-decorator]  # Celery has no types
def _set_up_logging(**_: Any) -> None:
    log.configure()
    log.configure_libraries()
