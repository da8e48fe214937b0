"""Verifications over HTTP."""

from fastapi import APIRouter

from app.access.caller import CallerDep
from app.access.visibility import CaseId
from app.context import ContextDep
from app.verifications import service
from app.verifications.schemas import VerificationDetail

router = APIRouter(prefix="/v1/cases/{case_id}/verification", tags=["cases"])


@router.post("", status_code=202, responses={409: {"description": "Not computed, or over a deleted profile"}})
def verify_case(case_id: CaseId, context: ContextDep, caller: CallerDep) -> VerificationDetail:
    """Let a stored case be computed once more, when no queued case waits, to see whether it gives the same numbers."""
    return service.request(context, case_id, caller)


@router.get("")
def get_verification(case_id: CaseId, context: ContextDep) -> VerificationDetail:
    """Get what came of the latest verification of a case."""
    with context.database.read() as session:
        return service.get(session, case_id)
