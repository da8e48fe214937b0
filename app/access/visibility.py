"""What a caller sees: own studies and those shared with it, and what they contain. The rest is not there (404).

Whoever sees a study may read it; changing it takes its owner or an administrator.
"""

from collections.abc import Callable
from typing import Annotated, Any

from anyio import to_thread
from fastapi import Depends, Path, Request
from sqlalchemy import ColumnElement, Select, exists, or_, select
from sqlalchemy.orm import Session

from app.access.caller import Caller, CallerDep, forbidden, sender
from app.context import Context, ContextDep
from app.db.models import Profile, ProfileKey, Study, StudyCase, StudyProfile, StudyShare
from app.problems import not_found

Conditions = list[ColumnElement[bool]]


def studies(caller: Caller) -> Conditions:
    """Of studies, those the caller sees."""
    if caller.is_admin:
        return []
    shared = exists().where(StudyShare.study_id == Study.id, StudyShare.key_id == caller.key_id)
    return [or_(Study.owner_id == caller.key_id, shared)]


def cases(caller: Caller, case_id: Any) -> Conditions:
    """Of rows with the identifier of a case, those the caller sees: some visible study contains the case."""
    if caller.is_admin:
        return []
    # Row by row, as rows are mostly read in some order and only until a page is full.
    return [exists(_containing(StudyCase).where(StudyCase.case_id == case_id, *studies(caller)))]


def case_ids(caller: Caller) -> Select[Any]:
    """The cases that a caller who is no administrator sees, maybe some twice: as a set, where most are asked for."""
    shared = select(StudyShare.study_id).where(StudyShare.key_id == caller.key_id)
    visible = select(Study.id).where(or_(Study.owner_id == caller.key_id, Study.id.in_(shared)))
    return select(StudyCase.case_id).where(StudyCase.study_id.in_(visible))


def profiles(caller: Caller) -> Conditions:
    """Of profiles, those the caller stored, and those of visible studies."""
    if caller.is_admin:
        return []
    stored = exists().where(ProfileKey.profile_id == Profile.id, ProfileKey.key_id == caller.key_id)
    return [
        or_(stored, exists(_containing(StudyProfile).where(StudyProfile.profile_id == Profile.id, *studies(caller))))
    ]


def _containing(table: type[StudyCase] | type[StudyProfile]) -> Any:
    return select(table).join(Study, Study.id == table.study_id)


def still_sees(context: Context, request: Request, study_id: str) -> bool:
    """Whether a request to read a study would be let in now: a key can be revoked, and a study shared no more."""
    if (caller := sender(context, request)) is None or caller.is_admin:
        return caller is not None
    with context.database.read() as session:
        return bool(session.scalar(select(exists().where(Study.id == study_id, *studies(caller)))))


async def _visible_study(
    study_id: Annotated[str, Path(pattern="^[0-9a-f]{32}$")], caller: CallerDep, context: ContextDep, request: Request
) -> str:
    def check(session: Session) -> None:
        owner = select(Study.owner_id).where(Study.id == study_id, *studies(caller))
        if (row := session.execute(owner).one_or_none()) is None:
            raise not_found("study")
        if request.method != "GET" and row.owner_id != caller.key_id:
            raise forbidden("The study is another's, shared to be read.", "not-owner")

    await _check(context, caller, check)
    return study_id


async def _visible_case(case_id: Annotated[int, Path(ge=1, lt=2**63)], caller: CallerDep, context: ContextDep) -> int:
    def check(session: Session) -> None:
        if not session.scalar(select(*cases(caller, case_id))):
            raise not_found("case")

    await _check(context, caller, check)
    return case_id


async def _visible_profile(
    profile_id: Annotated[str, Path(pattern="^[0-9a-f]{64}$")], caller: CallerDep, context: ContextDep
) -> str:
    def check(session: Session) -> None:
        if session.scalar(select(Profile.id).where(Profile.id == profile_id, *profiles(caller))) is None:
            raise not_found("profile")

    await _check(context, caller, check)
    return profile_id


async def _check(context: Context, caller: Caller, check: Callable[[Session], None]) -> None:
    def run() -> None:
        with context.database.read() as session:
            check(session)

    if not caller.is_admin:
        await to_thread.run_sync(run)


StudyId = Annotated[str, Depends(_visible_study)]
CaseId = Annotated[int, Depends(_visible_case)]
ProfileId = Annotated[str, Depends(_visible_profile)]
