"""The doorbell: tells workers that there are queued cases. The queue itself is the table ``case``."""

from typing import Any, NamedTuple

from celery import Celery
from kombu.connection import Connection
from kombu.entity import Exchange, Queue

from app import log
from app.settings import Settings

WORK = "tracksweep.work"
QUEUE = "tracksweep"
PATIENCE_S = 5


class _Kind(NamedTuple):
    """What depends on the kind of broker: options of the queue and of connections."""

    queue: dict[str, Any]
    connection: dict[str, Any]


_REDIS = _Kind(
    # A worker that owes an acknowledgement when the broker goes away never listens again (Celery 5.7, one process).
    queue={"no_ack": True},
    connection={"socket_connect_timeout": 2, "socket_timeout": PATIENCE_S, "max_retries": 0},
)
_RABBITMQ = _Kind(
    # Acknowledged, unlike with Redis: RabbitMQ hands out what need not be, all of it, to workers that are busy.
    queue={"queue_arguments": {"x-queue-type": "quorum"}},
    connection={"confirm_publish": True, "read_timeout": PATIENCE_S, "write_timeout": PATIENCE_S, "max_retries": 0},
)


def broker_client(settings: Settings) -> Celery:
    """A Celery application that knows the broker. Nothing travels but the name of the task."""
    url = settings.resolved_broker_url
    client = Celery("tracksweep", broker=url, set_as_current=False)
    kind = _RABBITMQ if url.startswith(("amqp://", "amqps://")) else _REDIS
    queue = Queue(QUEUE, Exchange(QUEUE), routing_key=QUEUE, **kind.queue)  # type: ignore[no-untyped-call]
    client.conf.update(
        accept_content=["json"],
        task_serializer="json",
        task_ignore_result=True,
        task_default_queue=QUEUE,
        task_queues=[queue],
        broker_transport_options=kind.connection,
        broker_heartbeat=0,  # a worker that computes would not send any, and be cut off by RabbitMQ for it
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
                    self._client.send_task(WORK, connection=connection, retry=False, confirm_timeout=PATIENCE_S)
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
        queue = self._client.amqp.queues[QUEUE](connection.default_channel)
        return bool(queue.queue_declare().message_count)
