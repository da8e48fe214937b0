"""Cases over HTTP."""

from typing import Annotated

from fastapi import APIRouter, Path, Query, Request, Response
from fastapi.responses import StreamingResponse

from app.cases import service
from app.cases.views import CaseDetail, CasePage, CaseQuery
from app.conditional import is_known
from app.context import ContextDep
from app.problems import RETRY_AFTER_S, Problem
from app.storage import HISTORY_MEDIA_TYPE, STORE_ERRORS
from app.studies.routes import StudyId

router = APIRouter(prefix="/v1", tags=["cases"])

CaseId = Annotated[int, Path(ge=1, lt=2**63)]


@router.get("/studies/{study_id}/cases")
def list_cases(study_id: StudyId, query: Annotated[CaseQuery, Query()], context: ContextDep) -> CasePage:
    """List the cases of a study, in the order of its sweep unless sorted otherwise."""
    with context.database.read() as session:
        return service.list_page(session, study_id, query, context.settings.max_page_size)


@router.get("/cases/{case_id}")
def get_case(case_id: CaseId, context: ContextDep) -> CaseDetail:
    """Get one case: its inputs, its state and, if it failed, why."""
    with context.database.read() as session:
        return service.get(session, case_id)


@router.get(
    "/cases/{case_id}/history.npz",
    response_class=Response,
    responses={
        200: {"content": {HISTORY_MEDIA_TYPE: {"schema": {"type": "string", "format": "binary"}}}},
        304: {"description": "Not changed"},
    },
)
def download_history(case_id: CaseId, context: ContextDep, request: Request) -> Response:
    """Download the time history of a case at full resolution, as a NumPy archive."""
    with context.database.read() as session:
        history = service.find_history(session, case_id)
    headers = {
        "ETag": f'"{history.digest}"',
        "Cache-Control": "no-cache",
        "Content-Disposition": f'attachment; filename="case-{case_id}.npz"',
    }
    if is_known(request, headers["ETag"]):
        return Response(status_code=304, headers=headers)
    try:
        chunks = context.histories.read(history.key)
    except STORE_ERRORS as error:
        detail = f"The history store does not answer: {type(error).__name__}."
        raise Problem(503, detail, headers={"Retry-After": str(RETRY_AFTER_S)}) from error
    headers["Content-Length"] = str(history.size_bytes)
    return StreamingResponse(chunks, media_type=HISTORY_MEDIA_TYPE, headers=headers)
