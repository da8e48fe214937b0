"""Previews over HTTP."""

from fastapi import APIRouter

from app.access.caller import CallerDep
from app.context import ContextDep
from app.previews import service
from app.previews.schemas import IrregularityPreview, PreviewRequest
from app.requests import JsonRoute

router = APIRouter(prefix="/v1/irregularity-previews", tags=["irregularities"], route_class=JsonRoute)


@router.post("")
def preview_irregularity(request: PreviewRequest, context: ContextDep, caller: CallerDep) -> IrregularityPreview:
    """Preview an irregularity: its profile over some length and the density of that, beside the spectrum it was drawn
    from. Nothing is stored.
    """
    return service.preview(context, request, caller)
