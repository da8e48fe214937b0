"""Studies over HTTP."""

from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Header, Query, Request, Response

from app.access.caller import CallerDep
from app.access.visibility import StudyId, still_sees
from app.conditional import CONDITIONAL_CHANGE, IfMatchHeader, check_match, edition, respond
from app.context import ContextDep
from app.idempotency import IdempotencyKeyHeader
from app.requests import JsonRoute
from app.studies import lifecycle, service
from app.studies.estimate import StudyEstimate, estimate
from app.studies.schemas import StudyDetail, StudyPage, StudyPatch, StudyQuery, StudyRequest
from app.studies.watch import SeatDep, watch

router = APIRouter(prefix="/v1/studies", tags=["studies"], route_class=JsonRoute)
estimates = APIRouter(prefix="/v1/study-estimates", tags=["studies"], route_class=JsonRoute)

WATCHED: dict[str, Any] = {
    "description": """Server-Sent Events with JSON as data. `state`: the study has come to another `state`. `case`: the
case `case_id` has ended in a `state`. `done`: the study has ended, and so does the stream. These have ids, by which a
stream that was cut goes on. `progress`: state, progress, cases and finish of the study as they are now; without id.""",
    "content": {"text/event-stream": {"schema": {"type": "string"}}},
}


@estimates.post("")
def estimate_study(study: StudyRequest, context: ContextDep, caller: CallerDep) -> StudyEstimate:
    """Estimate what a study would take, and what to beware of, without creating it. Whoever asked for a case before,
    it counts as computed or in flight.
    """
    return estimate(context, study, caller)


@router.post("", status_code=201, responses={409: {"description": "A request with the same key is in progress"}})
def create_study(
    study: StudyRequest,
    context: ContextDep,
    caller: CallerDep,
    response: Response,
    key: IdempotencyKeyHeader = None,
) -> StudyDetail:
    """Accept a study and queue its cases. Cases that any study had before are not computed again."""
    created = service.create(context, study, key, caller)
    response.headers["Location"] = f"/v1/studies/{created.id}"
    return created


@router.get("")
def list_studies(query: Annotated[StudyQuery, Query()], context: ContextDep, caller: CallerDep) -> StudyPage:
    """List studies, the newest first unless sorted otherwise."""
    with context.database.read() as session:
        return service.list_page(session, query, context.settings.max_page_size, caller)


@router.get("/{study_id}", response_model=StudyDetail, responses={304: {"description": "Not changed"}})
def get_study(study_id: StudyId, context: ContextDep, request: Request) -> Response:
    """Get one study: its state, how many cases are in which state, and when it will be finished."""
    with context.database.read() as session:
        study = service.get(session, study_id)
    return _respond(request, study)


@router.patch("/{study_id}", response_model=StudyDetail, responses=CONDITIONAL_CHANGE)
def update_study(
    study_id: StudyId,
    patch: StudyPatch,
    context: ContextDep,
    caller: CallerDep,
    request: Request,
    if_match: IfMatchHeader = None,
) -> Response:
    """Change a study's name, labels or priority. A case of several studies has the highest of their priorities."""
    service.check_priority(caller, patch.priority)
    study = lifecycle.update(context, study_id, patch, lambda current: check_match(if_match, _edition(current)))
    return _respond(request, study)


@router.post("/{study_id}/cancel")
def cancel_study(study_id: StudyId, context: ContextDep) -> StudyDetail:
    """Cancel what is left of a study. Cases that others want go on. A study that has ended stays as it is."""
    return lifecycle.cancel(context, study_id)


@router.post("/{study_id}/retry")
def retry_study(study_id: StudyId, context: ContextDep, caller: CallerDep) -> StudyDetail:
    """Queue the failed and cancelled cases of a study once more. Where there are none, nothing changes."""
    return lifecycle.retry(context, study_id, caller)


@router.delete(
    "/{study_id}", status_code=204, response_class=Response, responses={409: {"description": "Not ended yet"}}
)
def delete_study(study_id: StudyId, context: ContextDep) -> None:
    """Delete a study that has ended, with the histories that no other study keeps. Peaks stay, as do shared cases."""
    lifecycle.remove(context, study_id)


@router.get(
    "/{study_id}/events",
    response_class=Response,  # EventSourceResponse would be for generators, which cannot answer 204 or 404
    responses={200: WATCHED, 204: {"description": "The event given was the last"}},
)
async def watch_study(
    study_id: StudyId,
    context: ContextDep,
    request: Request,
    seat: SeatDep,
    last_event_id: Annotated[int, Query(ge=0, lt=2**63, description="The same, for whom cannot send headers.")] = 0,
    last_event: Annotated[
        int | None, Header(alias="Last-Event-ID", ge=0, lt=2**63, description="Only events after this one.")
    ] = None,
) -> Response:
    """Watch a study to its end, as Server-Sent Events."""
    allowed = partial(still_sees, context, request, study_id)
    return await watch(context, study_id, last_event_id if last_event is None else last_event, allowed)


def _edition(study: StudyDetail) -> str:
    return edition(study.name, sorted(study.labels.items()), study.priority)


def _respond(request: Request, study: StudyDetail) -> Response:
    return respond(request, study.model_dump_json().encode(), "application/json", _edition(study))
