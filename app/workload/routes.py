"""The queue over HTTP."""

from fastapi import APIRouter

from app.access.caller import CallerDep
from app.context import ContextDep
from app.workload.repository import look
from app.workload.schemas import QueueInfo

router = APIRouter(prefix="/v1", tags=["queue"])


@router.get("/queue")
def get_queue(context: ContextDep, caller: CallerDep) -> QueueInfo:
    """Get how much waits, how fast cases are done, and which workers are there and what they compute."""
    with context.database.read() as session:
        return look(session, caller)
