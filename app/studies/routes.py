"""Studies over HTTP."""

from typing import Annotated

from fastapi import APIRouter, Path, Query, Request, Response

from app.conditional import respond
from app.context import ContextDep
from app.idempotency import IdempotencyKeyHeader
from app.requests import JsonRoute
from app.studies import service
from app.studies.schemas import StudyDetail, StudyPage, StudyQuery, StudyRequest

router = APIRouter(prefix="/v1/studies", tags=["studies"], route_class=JsonRoute)

StudyId = Annotated[str, Path(pattern="^[0-9a-f]{32}$")]


@router.post("", status_code=201)
def create_study(
    study: StudyRequest, context: ContextDep, response: Response, key: IdempotencyKeyHeader = None
) -> StudyDetail:
    """Accept a study and queue its cases. Cases that any study had before are not computed again."""
    created = service.create(context, study, key)
    response.headers["Location"] = f"/v1/studies/{created.id}"
    return created


@router.get("")
def list_studies(query: Annotated[StudyQuery, Query()], context: ContextDep) -> StudyPage:
    """List studies, the newest first unless sorted otherwise."""
    with context.database.read() as session:
        return service.list_page(session, query, context.settings.max_page_size)


@router.get("/{study_id}", response_model=StudyDetail, responses={304: {"description": "Not changed"}})
def get_study(study_id: StudyId, context: ContextDep, request: Request) -> Response:
    """Get one study: its state, how many cases are in which state, and when it will be finished."""
    with context.database.read() as session:
        study = service.get(session, study_id)
    return respond(request, study.model_dump_json().encode(), "application/json")
