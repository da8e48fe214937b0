"""Time histories over HTTP."""

import tempfile
from collections.abc import Iterator
from typing import Annotated, Any, BinaryIO, Literal

from fastapi import APIRouter, Depends, Query, Request, Response
from fastapi.responses import RedirectResponse

from app.access.visibility import CaseId
from app.conditional import NOT_CHANGED, not_changed
from app.context import ContextDep
from app.download import PARQUET, RANGES, binary, download
from app.histories import service
from app.histories.schemas import HistoryQuery, HistoryView, SpectrumQuery, SpectrumView
from app.storage import filename

NPZ = "application/octet-stream"
ELSEWHERE: dict[int | str, dict[str, Any]] = {307: {"description": "To be had from the bucket, for some time"}}
Through = Annotated[
    Literal["any", "service"],
    Query(description="Whether a service that is set up for it may answer with a link into its bucket (307)."),
]


def _scratch() -> Iterator[BinaryIO]:
    with tempfile.TemporaryFile() as file:
        yield file


ScratchDep = Annotated[BinaryIO, Depends(_scratch)]  # a file until the answer is sent

router = APIRouter(prefix="/v1/cases/{case_id}", tags=["histories"])


@router.get("/history", response_model=HistoryView, responses=NOT_CHANGED)
def get_history(
    case_id: CaseId, query: Annotated[HistoryQuery, Query()], context: ContextDep, request: Request
) -> Response:
    """Get the time history of a case, or a part of it, as fine as a screen can show. No peak is lost."""
    with context.database.read() as session:
        stored = service.find(session, case_id)
    etag = stored.etag(query.model_dump_json())
    if (answer := not_changed(request, etag)) is not None:
        return answer
    content = service.view(context, stored, query).model_dump_json()
    return Response(content, media_type="application/json", headers={"ETag": etag, "Cache-Control": "no-cache"})


@router.get("/spectrum", response_model=SpectrumView, responses=NOT_CHANGED)
def get_spectrum(
    case_id: CaseId, query: Annotated[SpectrumQuery, Query()], context: ContextDep, request: Request
) -> Response:
    """Get the spectrum of one channel of a stored history, with the frequencies of passing pads and of the wheel on
    the track.
    """
    with context.database.read() as session:
        stored = service.find(session, case_id)
    etag = stored.etag("spectrum", query.model_dump_json())
    if (answer := not_changed(request, etag)) is not None:
        return answer
    content = service.spectrum(context, stored, query).model_dump_json()
    return Response(content, media_type="application/json", headers={"ETag": etag, "Cache-Control": "no-cache"})


@router.get("/history.npz", response_class=Response, responses=binary(NPZ) | RANGES | ELSEWHERE)
def download_history(case_id: CaseId, context: ContextDep, request: Request, through: Through = "any") -> Response:
    """Download the time history of a case at full resolution, as a NumPy archive."""
    with context.database.read() as session:
        stored = service.find(session, case_id)
    etag, size = f'"{stored.history.digest}"', stored.history.size_bytes
    if (answer := not_changed(request, etag)) is not None:
        return answer
    may_leave = through == "any" and "head" not in request.scope  # a link is good for GET only
    if may_leave and (link := service.link(context, stored)) is not None:
        return RedirectResponse(link, 307, {"Cache-Control": "no-store"})
    return download(request, etag, size, lambda part: service.read(context, stored, part), NPZ, filename(case_id))


@router.get("/history.parquet", response_class=Response, responses=binary(PARQUET) | RANGES)
def download_history_parquet(case_id: CaseId, context: ContextDep, request: Request, scratch: ScratchDep) -> Response:
    """Download the time history of a case at full resolution, as Parquet: a column per channel, with its unit, and
    the inputs of the case in the metadata.
    """
    with context.database.read() as session:
        stored = service.find(session, case_id)
    etag = service.parquet_etag(stored)
    if (answer := not_changed(request, etag)) is not None:
        return answer
    service.write_parquet(context, stored, scratch)
    return download(
        request, etag, scratch.tell(), lambda part: _chunks(scratch, part), PARQUET, f"case-{case_id}.parquet"
    )


def _chunks(file: BinaryIO, part: range, size: int = 2**16) -> Iterator[bytes]:
    file.seek(part.start)
    for position in range(part.start, part.stop, size):
        yield file.read(min(size, part.stop - position))
