"""Health and metrics over HTTP, outside the API's document."""

from fastapi import APIRouter, Request, Response
from prometheus_client.exposition import choose_encoder

from app.access.caller import CallerDep
from app.context import ContextDep
from app.metrics import health
from app.metrics.service import ServiceCollector
from app.problems import RETRY_AFTER_S, Problem

router = APIRouter(include_in_schema=False)


@router.get("/healthz")
def healthz() -> dict[str, str]:
    """Whether the process answers: if not, it is to be restarted."""
    return {"status": "ok"}


@router.get("/readyz")
def readyz(context: ContextDep) -> dict[str, str]:
    """Whether requests can be served, that is whether the database has the tables of this release; if not, they are to
    be sent elsewhere. Without broker and histories all else works, and as well here as elsewhere: metrics tell of them.
    """
    if (why := health.NOT_READY.get(health.database(context))) is not None:
        raise Problem(503, why, headers={"Retry-After": str(RETRY_AFTER_S)})
    return {"status": "ok"}


@router.get("/metrics")
def metrics(context: ContextDep, request: Request, caller: CallerDep) -> Response:
    """What Prometheus asks for. They are totals, so any key will do: one that may only read sees nothing else."""
    encode, media_type = choose_encoder(request.headers.get("accept", ""))
    of_requests = encode(request.app.state.requests.registry)
    of_service = encode(ServiceCollector.registry(context))
    return Response(of_requests.removesuffix(b"# EOF\n") + of_service, media_type=media_type)
