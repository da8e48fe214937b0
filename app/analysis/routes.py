"""Comparisons and statistics over HTTP."""

from typing import Annotated

from fastapi import APIRouter, Query, Request, Response

from app.access.visibility import StudyId
from app.analysis.comparison import compare
from app.analysis.schemas import AnalysisQuery, Comparison, ComparisonQuery, Statistics
from app.analysis.summary import summarise
from app.conditional import NOT_CHANGED, respond
from app.context import ContextDep

router = APIRouter(prefix="/v1/studies/{study_id}", tags=["analysis"])


@router.get("/comparison", response_model=Comparison, responses=NOT_CHANGED)
def compare_study(
    study_id: StudyId, query: Annotated[ComparisonQuery, Query()], context: ContextDep, request: Request
) -> Response:
    """Compare cases that differ along one axis only, such as the slab or the percentile: each pair, and their mean."""
    with context.database.read() as session:
        comparison = compare(session, study_id, query)
    return respond(request, comparison.model_dump_json().encode(), "application/json")


@router.get("/statistics", response_model=Statistics, responses=NOT_CHANGED)
def summarise_study(
    study_id: StudyId, query: Annotated[AnalysisQuery, Query()], context: ContextDep, request: Request
) -> Response:
    """Summarise each quantity over the realisations of each condition."""
    with context.database.read() as session:
        summary = summarise(session, study_id, query)
    return respond(request, summary.model_dump_json().encode(), "application/json")
