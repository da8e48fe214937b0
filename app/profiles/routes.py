"""Measured profiles over HTTP."""

from typing import Annotated, Any

from fastapi import APIRouter, Depends, Query, Request, Response

from app.access.caller import CallerDep
from app.access.visibility import ProfileId
from app.conditional import NOT_CHANGED, not_changed
from app.context import ContextDep
from app.download import binary
from app.profiles import service
from app.profiles.schemas import ProfileInfo, ProfilePage, ProfileQuery
from app.requests import CSV, csv_text

router = APIRouter(prefix="/v1/profiles", tags=["profiles"])

# The generated client takes a body of bytes for a file.
CSV_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "content": {CSV: {"schema": {"type": "string", "format": "binary"}}},
    }
}


@router.post("", status_code=201, openapi_extra=CSV_BODY)
def create_profile(
    text: Annotated[str, Depends(csv_text)], context: ContextDep, caller: CallerDep, response: Response
) -> ProfileInfo:
    """Store a measured profile: CSV in UTF-8, a line per point, position along the track and height, positive
    downwards. A first line may name the units, m or mm, column by column (`x_m,eta_mm`); without, both are in m. Empty
    lines and those that begin with `#` are skipped. Positions increase. Wrong lines are named as `/line/N`. The same
    samples are stored once.
    """
    profile = service.create(context, text, caller)
    response.headers["Location"] = f"/v1/profiles/{profile.id}"
    return profile


@router.get("")
def list_profiles(query: Annotated[ProfileQuery, Query()], context: ContextDep, caller: CallerDep) -> ProfilePage:
    """List stored profiles, the newest first unless sorted otherwise."""
    with context.database.read() as session:
        return service.list_page(session, query, context.settings.max_page_size, caller)


@router.get("/{profile_id}")
def get_profile(profile_id: ProfileId, context: ContextDep) -> ProfileInfo:
    """Get what a stored profile is: its extent and which wavelengths it holds."""
    with context.database.read() as session:
        return service.get(session, profile_id)


@router.get("/{profile_id}/profile.csv", response_class=Response, responses=binary(CSV) | NOT_CHANGED)
def download_profile(profile_id: ProfileId, context: ContextDep, request: Request) -> Response:
    """Download the samples of a profile, in m: what `tracksweep solve` takes as a file."""
    with context.database.read() as session:
        content = service.csv(session, profile_id)
    headers = {
        "ETag": f'"{profile_id}"',
        "Cache-Control": "no-cache",
        "Content-Disposition": f'attachment; filename="profile-{profile_id[:16]}.csv"',
    }
    return not_changed(request, headers["ETag"]) or Response(content, media_type=CSV, headers=headers)


@router.delete(
    "/{profile_id}", status_code=204, response_class=Response, responses={409: {"description": "Studies use it"}}
)
def delete_profile(profile_id: ProfileId, context: ContextDep, caller: CallerDep) -> None:
    """Delete a profile that no study uses."""
    service.remove(context, profile_id, caller)
