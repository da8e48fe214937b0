"""Peaks over HTTP."""

from collections.abc import Iterator
from itertools import chain
from typing import Annotated

from fastapi import APIRouter, Query, Response
from fastapi.responses import StreamingResponse

from app.access.caller import CallerDep
from app.access.visibility import CaseId
from app.context import ContextDep
from app.download import PARQUET, binary
from app.peaks import repository
from app.peaks.export import as_csv, export
from app.peaks.schemas import CasePeak, CasePeakList, PeakFilters, PeakPage, PeakQuery, PeakRow

CSV = "text/csv"

router = APIRouter(prefix="/v1/peaks", tags=["peaks"])
of_cases = APIRouter(prefix="/v1/cases/{case_id}/peaks", tags=["peaks"])


@router.get("")
def list_peaks(query: Annotated[PeakQuery, Query()], context: ContextDep, caller: CallerDep) -> PeakPage:
    """List peaks across studies, with the conditions under which they occur."""
    with context.database.read() as session:
        rows, cursor = repository.find_page(session, query, context.settings.max_page_size, caller)
    return PeakPage(items=[PeakRow.model_validate(row) for row in rows], next_cursor=cursor)


@of_cases.get("")
def list_case_peaks(case_id: CaseId, context: ContextDep) -> CasePeakList:
    """List the peaks of one case. There are none before it has succeeded."""
    with context.database.read() as session:
        peaks = repository.of_case(session, case_id)
    return CasePeakList(items=[CasePeak.model_validate(peak) for peak in peaks])


@router.get(".csv", response_class=Response, responses=binary(CSV))
def export_peaks_csv(filters: Annotated[PeakFilters, Query()], context: ContextDep, caller: CallerDep) -> Response:
    """Export peaks as CSV, with the unit of each, its case's digest and the version of the solver."""
    return _stream(as_csv(export(context.database, filters, caller)), CSV, "peaks.csv")


@router.get(".parquet", response_class=Response, responses=binary(PARQUET))
def export_peaks_parquet(filters: Annotated[PeakFilters, Query()], context: ContextDep, caller: CallerDep) -> Response:
    """Export peaks as Parquet, with the unit of each, its case's digest and the version of the solver."""
    from app.peaks.parquet import as_parquet  # noqa: PLC0415 - Arrow is slow to load

    return _stream(as_parquet(export(context.database, filters, caller), filters), PARQUET, "peaks.parquet")


def _stream(chunks: Iterator[bytes], media_type: str, filename: str) -> Response:
    begin = next(chunks)  # here an error still becomes a problem
    headers = {"Cache-Control": "no-store", "Content-Disposition": f'attachment; filename="{filename}"'}
    return StreamingResponse(chain([begin], chunks), headers=headers, media_type=media_type)
