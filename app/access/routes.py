"""Sharing over HTTP. Only a study's owner and administrators get here with another method than GET."""

from typing import Annotated

from fastapi import APIRouter, Path, Response
from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.access.caller import CallerDep, forbidden
from app.access.keys import MAX_NAME, NAME
from app.access.schemas import Share, ShareList
from app.access.visibility import StudyId
from app.context import ContextDep
from app.db.models import ApiKey, Study, StudyShare
from app.problems import not_found

router = APIRouter(prefix="/v1/studies/{study_id}/shares", tags=["studies"])

KeyName = Annotated[str, Path(pattern=f"^{NAME}$", max_length=MAX_NAME, description="Name of an API key.")]


@router.get("")
def list_shares(study_id: StudyId, context: ContextDep, caller: CallerDep) -> ShareList:
    """List the keys with which a study is shared. It takes the study's owner or an administrator."""
    names = select(ApiKey.name).join(StudyShare).where(StudyShare.study_id == study_id).order_by(ApiKey.name)
    with context.database.read() as session:
        study = _find(session, study_id)
        if not caller.is_admin and study.owner_id != caller.key_id:
            raise forbidden("The study is another's, shared to be read.", "not-owner")
        return ShareList(items=[Share(key=name) for name in session.scalars(names)])


@router.put("/{key_name}", status_code=204, response_class=Response)
def share_study(study_id: StudyId, key_name: KeyName, context: ContextDep) -> None:
    """Let another key read a study and all that is in it."""
    with context.database.write() as session:
        _find(session, study_id)
        key_id = session.scalar(select(ApiKey.id).where(ApiKey.name == key_name))
        if key_id is None:
            raise not_found("key")
        session.merge(StudyShare(study_id=study_id, key_id=key_id))


@router.delete("/{key_name}", status_code=204, response_class=Response)
def unshare_study(study_id: StudyId, key_name: KeyName, context: ContextDep) -> None:
    """Share a study with a key no longer. Where it is not shared, nothing changes."""
    of_key = select(ApiKey.id).where(ApiKey.name == key_name).scalar_subquery()
    with context.database.write() as session:
        _find(session, study_id)
        session.execute(delete(StudyShare).where(StudyShare.study_id == study_id, StudyShare.key_id == of_key))


def _find(session: Session, study_id: str) -> Study:
    """The study, which whoever sees all was not yet asked for."""
    if (study := session.get(Study, study_id)) is None:
        raise not_found("study")
    return study
