"""Cases queued under an older release: computed as this release computes them, and stored under its version.

Otherwise numbers of one solver would stand under the version of another, and the next study that contains the case
would be told that it is computed.
"""

from functools import partial

from sqlalchemy import Integer, cast, exists, select, update
from sqlalchemy.orm import Session, aliased

from app.cases.repository import row_of
from app.db.models import Case
from app.profiles.repository import samples
from solver.case import Case as SolverCase
from solver.quantity import InvalidParameterError
from solver.version import SOLVER_VERSION
from worker import lease

AT_ONCE = 100


def adopt(session: Session) -> None:
    """Bring queued cases to this solver's version. Those of a newer one wait for a worker that knows it."""
    older = (
        select(Case)
        .where(Case.state == "queued", cast(Case.solver_version, Integer) < int(SOLVER_VERSION))
        .order_by(Case.digest)
        .limit(AT_ONCE)
        .with_for_update(skip_locked=True)
    )
    for case in session.scalars(older).all():
        try:
            row = row_of(SolverCase.from_dict(case.inputs, partial(samples, session)), case.priority)
        except (InvalidParameterError, KeyError, TypeError) as error:
            _fail(
                session,
                case,
                f"Solver version {SOLVER_VERSION} does not take what version {case.solver_version} did: {error}.",
            )
            continue
        twin = aliased(Case)
        same = exists().where(twin.digest == row["digest"], twin.solver_version == SOLVER_VERSION)
        if session.scalar(select(same)):
            _fail(session, case, "A newer study has this case, too, computed by the present solver: create yours anew.")
        else:
            session.execute(update(Case).where(Case.id == case.id).values(row))


def _fail(session: Session, case: Case, detail: str) -> None:
    lease.refuse(session, case.id, "solver-changed", detail)
