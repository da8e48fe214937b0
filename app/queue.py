"""The doorbell: tells workers that there are queued cases. The queue itself is the table ``case``."""

import structlog
from celery import Celery
from kombu.exceptions import KombuError

from app.settings import Settings

WORK = "tracksweep.work"
BELL_EXPIRES_S = 60.0  # an older bell says nothing new: the sweeper has rung since

log = structlog.get_logger()


def broker_client(settings: Settings) -> Celery:
    """A Celery application that knows the broker. Nothing travels but the name of the task."""
    client = Celery("tracksweep", broker=settings.resolved_broker_url, set_as_current=False)
    client.conf.update(
        accept_content=["json"],
        task_serializer="json",
        task_ignore_result=True,
        task_default_queue="tracksweep",
        broker_transport_options={"socket_connect_timeout": 2, "socket_timeout": 5, "max_retries": 0},
    )
    return client


class Doorbell:
    """Rings for workers."""

    def __init__(self, settings: Settings) -> None:
        self._client = broker_client(settings)

    def ring(self) -> bool:
        """Wake a worker. A broker that is away costs latency and nothing else: the sweeper rings again.

        Call it after the commit, or the worker may look before there is anything to see.
        """
        try:
            self._client.send_task(WORK, expires=BELL_EXPIRES_S, retry=False)
        except (KombuError, OSError) as error:
            log.warning("broker unavailable", error=str(error))
            return False
        return True
