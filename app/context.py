"""What the routes of one application share."""

from dataclasses import dataclass, field
from typing import Annotated

from fastapi import Depends, Request

from app.db.session import Database
from app.idempotency import InProgress
from app.queue import Doorbell
from app.settings import Settings
from app.storage import HistoryStore


@dataclass(frozen=True)
class Context:
    """Settings, database, doorbell and history store, and the keys of requests in progress."""

    settings: Settings
    database: Database
    doorbell: Doorbell
    histories: HistoryStore
    in_progress: InProgress = field(default_factory=InProgress)


def _of_request(request: Request) -> Context:
    context: Context = request.app.state.context
    return context


ContextDep = Annotated[Context, Depends(_of_request)]
