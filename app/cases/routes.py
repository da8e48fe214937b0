"""Cases over HTTP."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from app.access.visibility import CaseId, StudyId
from app.cases import service
from app.cases.views import CaseDetail, CasePage, CaseQuery
from app.conditional import NOT_CHANGED, respond
from app.context import ContextDep

router = APIRouter(prefix="/v1", tags=["cases"])


@router.get("/studies/{study_id}/cases", response_model=CasePage, responses=NOT_CHANGED)
def list_cases(
    study_id: StudyId, query: Annotated[CaseQuery, Query()], context: ContextDep, request: Request
) -> Response:
    """List the cases of a study, in the order of its sweep unless sorted otherwise."""
    with context.database.read() as session:
        page = service.list_page(session, study_id, query, context.settings.max_page_size)
    return respond(request, page.model_dump_json().encode(), "application/json")


@router.get("/cases/{case_id}", response_model=CaseDetail, responses=NOT_CHANGED)
def get_case(case_id: CaseId, context: ContextDep, request: Request) -> Response:
    """Get one case: its inputs, its state and, if it failed, why."""
    with context.database.read() as session:
        case = service.get(session, case_id)
    return respond(request, case.model_dump_json().encode(), "application/json")
