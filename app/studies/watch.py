"""Following a study: its events as a stream of Server-Sent Events, which goes on where it was cut."""

import asyncio
import json
import time
from collections.abc import AsyncIterator, Callable, Sequence
from typing import Annotated, Any

from anyio import to_thread
from fastapi import Depends, Request, Response
from fastapi.sse import KEEPALIVE_COMMENT, EventSourceResponse, format_sse_event
from sqlalchemy import select
from sqlalchemy.exc import SQLAlchemyError

from app.context import Context
from app.db.models import Event
from app.problems import RETRY_AFTER_S, Problem, not_found
from app.studies import service

POLL_S = 0.5
AT_ONCE = 500  # events read by one query
SPARINGLY = 20  # of a watcher's time, this part may go into looking for progress: it counts all cases of the study
HEADERS = {"Cache-Control": "no-cache", "X-Accel-Buffering": "no"}  # the latter is for nginx


async def _seat(request: Request) -> AsyncIterator[None]:
    seats = request.app.state.watchers
    if not seats.acquire(blocking=False):
        detail = "As many studies are being watched as this service allows (max_watchers). Try again later."
        raise Problem(503, detail, code="too-many-watchers", headers={"Retry-After": str(RETRY_AFTER_S)})
    try:
        yield
    finally:
        seats.release()


SeatDep = Annotated[None, Depends(_seat)]


async def watch(context: Context, study_id: str, after: int, still_allowed: Callable[[], bool]) -> Response:
    """The events of a study that come after one, to the end of the study; 204 if the last one was that.

    Parameters
    ----------
    context : Context
    study_id : str
    after : int
        The number of that one; 0 for all.
    still_allowed : callable
        Whether the caller may still see the study; asked twice in the longest silence. The stream ends when not.

    Raises
    ------
    Problem
        404 if there is no such study.
    """
    last = await to_thread.run_sync(_last_event, context, study_id)
    if last is None:
        raise not_found("study")
    if last.kind == "done" and after >= last.id:
        return Response(status_code=204)
    return EventSourceResponse(_stream(context, study_id, min(after, last.id), still_allowed), headers=HEADERS)


async def _stream(
    context: Context, study_id: str, after: int, still_allowed: Callable[[], bool]
) -> AsyncIterator[bytes]:
    """Between two looks no connection to the database is held."""
    progress: Any = None
    due = 0.0
    spoken = allowed = time.monotonic()
    try:
        while True:
            news = await to_thread.run_sync(_events_after, context, study_id, after)
            ended = 0 < len(news) < AT_ONCE and news[-1].kind == "done"
            looked = time.monotonic()
            if looked - allowed >= context.settings.watch_keep_alive_s / 2:
                if not await to_thread.run_sync(still_allowed):
                    return
                allowed = looked
            if looked >= due or ended:
                before, progress = progress, await to_thread.run_sync(_progress, context, study_id)
                due = time.monotonic() + max(POLL_S, SPARINGLY * (time.monotonic() - looked))
                if before is None or _counted(progress) != _counted(before):
                    spoken = looked
                    yield format_sse_event(event="progress", data_str=json.dumps(progress))
            for event in news:
                spoken, after = looked, event.id
                yield format_sse_event(id=str(event.id), event=event.kind, data_str=json.dumps(event.payload))
            if ended:
                return
            if looked - spoken >= context.settings.watch_keep_alive_s:
                spoken = looked
                yield KEEPALIVE_COMMENT
            if len(news) < AT_ONCE:
                await asyncio.sleep(POLL_S)
    except (SQLAlchemyError, Problem):
        return  # the database is away or the study deleted: the client comes back, and is told


def _counted(progress: dict[str, Any]) -> dict[str, Any]:
    return progress | {"finish": None}  # which is another one at every look


def _last_event(context: Context, study_id: str) -> Event | None:
    with context.database.read() as session:
        return session.scalars(
            select(Event).where(Event.study_id == study_id).order_by(Event.id.desc()).limit(1)
        ).first()


def _events_after(context: Context, study_id: str, after: int) -> Sequence[Event]:
    later = select(Event).where(Event.study_id == study_id, Event.id > after).order_by(Event.id).limit(AT_ONCE)
    with context.database.read() as session:
        return session.scalars(later).all()


def _progress(context: Context, study_id: str) -> dict[str, Any]:
    with context.database.read() as session:
        study = service.get(session, study_id)
    return study.model_dump(mode="json", include={"state", "progress", "cases", "finish"})
