"""The doorbell: tells workers that there are queued cases. The queue itself is the table ``case``."""

from typing import Any

from celery import Celery
from kombu.connection import Connection
from kombu.entity import Exchange, Queue
from kombu.exceptions import ChannelError

from app import log
from app.settings import Settings

WORK = "tracksweep.work"
QUEUE = "tracksweep"


def broker_client(settings: Settings) -> Celery:
    """A Celery application that knows the broker. Nothing travels but the name of the task."""
    client = Celery("tracksweep", broker=settings.resolved_broker_url, set_as_current=False)
    # A worker that owes an acknowledgement when the broker goes away never listens again (Celery 5.7, one process).
    queue = Queue(QUEUE, Exchange(QUEUE), routing_key=QUEUE, no_ack=True)  # type: ignore[no-untyped-call]
    client.conf.update(
        accept_content=["json"],
        task_serializer="json",
        task_ignore_result=True,
        task_default_queue=QUEUE,
        task_queues=[queue],
        broker_transport_options={"socket_connect_timeout": 2, "socket_timeout": 5, "max_retries": 0},
    )
    return client


class Doorbell:
    """Rings for workers."""

    def __init__(self, settings: Settings) -> None:
        self._client = broker_client(settings)

    def ring(self) -> bool:
        """Wake a worker, unless a bell is waiting for one already: a worker that finds work rings for the next.

        A broker that is away costs latency and nothing else, as the sweeper rings again. Call it after the commit,
        or the worker may look before there is anything to see.
        """
        try:
            with self._client.connection_for_write() as connection:
                if not self._waiting(connection):
                    self._client.send_task(WORK, connection=connection, retry=False)
        except Exception as error:  # every broker has errors of its own, and what is committed must be answered
            log.unavailable("broker", error)
            return False
        return True

    def answers(self) -> bool:
        """Whether the broker does."""
        try:
            with self._client.connection_for_write() as connection:
                self._waiting(connection)
        except Exception as error:  # as above
            log.unavailable("broker", error)
            return False
        return True

    def _waiting(self, connection: Connection) -> bool:
        channel: Any = connection.default_channel
        try:
            return bool(channel.queue_declare(QUEUE, passive=True).message_count)
        except ChannelError:  # nobody has rung or listened yet
            return False
