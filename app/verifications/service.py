"""What can be done with verifications."""

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.access import quotas
from app.access.caller import ANYBODY, Caller
from app.cases import queue
from app.context import Context
from app.db.models import Case, Verification
from app.problems import Problem, not_found
from app.profiles import repository as profiles
from app.verifications.schemas import VerificationDetail


def request(context: Context, case_id: int, caller: Caller = ANYBODY) -> VerificationDetail:
    """Queue a verification of a case, unless one is on its way.

    Raises
    ------
    Problem
        404 if there is no such case, 409 if it has no result to be verified or its profile was deleted, 429 if the
        caller's quota is used up.
    """
    with context.database.write() as session:
        queue.one_at_a_time(session)
        case = session.get(Case, case_id)
        if case is None:
            raise not_found("case")
        if case.state != "succeeded":
            raise Problem(409, f"The case is {case.state}: there is nothing to verify.", code="case-not-succeeded")
        if (profile_id := profiles.lacking(session, case.inputs)) is not None:
            detail = f"The case runs over the measured profile {profile_id}, which was deleted. Store it again first."
            raise Problem(409, detail, code="profile-deleted")
        latest = _latest(session, case_id)
        if latest is None or latest.state not in queue.UNFINISHED:
            quotas.check(session, caller)
            latest = Verification(case_id=case_id)
            session.add(latest)
            session.flush()
        answer = VerificationDetail.model_validate(latest)
    context.doorbell.ring()
    return answer


def get(session: Session, case_id: int) -> VerificationDetail:
    """The latest verification of a case.

    Raises
    ------
    Problem
        404 if there is none.
    """
    latest = _latest(session, case_id)
    if latest is None:
        raise not_found("verification")
    return VerificationDetail.model_validate(latest)


def _latest(session: Session, case_id: int) -> Verification | None:
    of_case = select(Verification).where(Verification.case_id == case_id)
    return session.scalars(of_case.order_by(Verification.id.desc()).limit(1)).first()
