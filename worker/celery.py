"""The Celery application: listens for the bell. ``celery -A worker.celery worker``, or ``tracksweep worker``."""

from celery import Celery

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
    task_acks_late=True,  # or a busy worker would take the bell meant to wake an idle one
    broker_connection_retry_on_startup=True,
    broker_connection_max_retries=None,
    worker_cancel_long_running_tasks_on_connection_loss=False,  # the case is leased from the database
    worker_hijack_root_logger=False,
)
