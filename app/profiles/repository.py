"""Profiles in the database: positions and then heights, as doubles, little end first, of which the id is the digest."""

import struct
from collections.abc import Iterable

from sqlalchemy import exists, insert, select
from sqlalchemy.orm import Session

from app.db.models import Profile, StudyProfile
from app.problems import invalid
from solver.case import Case, Irregularity, Measured, Sum
from solver.railhead import Samples


def pack(samples: Samples) -> bytes:
    """Samples as stored."""
    positions, heights = samples
    return struct.pack(f"<{2 * len(positions)}d", *positions, *heights)


def samples(session: Session, profile_id: str) -> Samples:
    """Positions and heights, m.

    Raises
    ------
    KeyError
        If there is no such profile.
    """
    packed = session.scalar(select(Profile.samples).where(Profile.id == profile_id))
    if packed is None:
        raise KeyError(profile_id)
    values = struct.unpack(f"<{len(packed) // 8}d", packed)
    return values[: len(values) // 2], values[len(values) // 2 :]


def used_by(cases: Iterable[Case]) -> list[str]:
    """Identifiers of the profiles that cases run over."""
    return sorted({each.profile for case in cases for each in _terms(case.irregularity) if isinstance(each, Measured)})


def _terms(irregularity: Irregularity) -> Iterable[Irregularity]:
    return irregularity.terms if isinstance(irregularity, Sum) else (irregularity,)


def hold(session: Session, study_id: str, profile_ids: list[str]) -> None:
    """Keep profiles from being deleted as long as there is a study. No other is accepted at the same time.

    Raises
    ------
    Problem
        422 if one was deleted since it was read.
    """
    if profile_ids:
        found = session.scalars(select(Profile.id).where(Profile.id.in_(profile_ids))).all()
        if len(found) < len(profile_ids):
            raise invalid("/sweep", "profile-deleted", "A profile of this study was just deleted.")
        places = [{"study_id": study_id, "profile_id": profile_id} for profile_id in found]
        session.execute(insert(StudyProfile), places)


def is_held(session: Session, profile_id: str) -> bool:
    """Whether a study uses a profile."""
    return bool(session.scalar(select(exists().where(StudyProfile.profile_id == profile_id))))
