"""The Celery application: listens for the bell. ``celery -A worker.celery worker``, or ``tracksweep worker``."""

from typing import Any

import kombu.transport.redis
from celery import Celery
from kombu.exceptions import ConnectionError as BrokerConnectionError

from app.queue import broker_client
from app.settings import Settings

SETTINGS = Settings()

app: Celery = broker_client(SETTINGS)
app.conf.update(
    imports=["worker.tasks"],
    worker_pool="solo",  # one process, one case at a time: nothing is forked, and a crash takes nothing else along
    worker_concurrency=1,
    worker_prefetch_multiplier=1,
    task_acks_late=True,  # or a busy worker would take the bell meant to wake an idle one
    broker_connection_retry_on_startup=True,
    broker_connection_max_retries=None,
    worker_cancel_long_running_tasks_on_connection_loss=False,  # the case is leased from the database
    worker_hijack_root_logger=False,
)


def _survive_lost_connections(channel: type[Any]) -> None:
    """Make a connection that is gone an error that Celery recovers from.

    In kombu 5.7 a worker that holds an unacknowledged message when Redis drops the connection asks it for its
    parameters, and ends with "'NoneType' object has no attribute 'hostname'".
    """
    connection_parameters = channel._connparams

    def checked(self: Any, asynchronous: bool = False) -> Any:
        if self.connection.client is None:
            raise BrokerConnectionError("the connection to the broker is closed")
        return connection_parameters(self, asynchronous)

    channel._connparams = checked


_survive_lost_connections(kombu.transport.redis.Channel)
