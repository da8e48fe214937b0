"""Peaks over HTTP."""

from typing import Annotated

from fastapi import APIRouter, Query

from app.context import ContextDep
from app.peaks import repository
from app.peaks.schemas import PeakFilters, PeakPage, PeakRow

router = APIRouter(prefix="/v1/peaks", tags=["peaks"])


@router.get("")
def list_peaks(query: Annotated[PeakFilters, Query()], context: ContextDep) -> PeakPage:
    """List peaks across studies, with the conditions under which they occur."""
    with context.database.read() as session:
        rows, cursor = repository.find_page(session, query, context.settings.max_page_size)
    return PeakPage(items=[PeakRow.model_validate(row._asdict()) for row in rows], next_cursor=cursor)
