"""Profiles in the database: positions and then heights, as doubles, little end first, of which the id is the digest."""

import struct
from collections.abc import Iterable, Sequence
from typing import Any

from sqlalchemy import ColumnElement, delete, exists, insert, select
from sqlalchemy.orm import Session

from app.access import visibility
from app.access.caller import ANYBODY, Caller
from app.db.models import Profile, ProfileKey, Study, StudyProfile
from app.problems import invalid
from solver.case import Case, Irregularity, Measured, Sum
from solver.railhead import Samples


class UnknownProfileError(KeyError):
    """There is no such profile, or none that the caller sees.

    Parameters
    ----------
    profile_id : str
    """

    def __str__(self) -> str:
        return f"The measured profile {self.args[0]} is not stored."


def pack(samples: Samples) -> bytes:
    """Samples as stored."""
    positions, heights = samples
    return struct.pack(f"<{2 * len(positions)}d", *positions, *heights)


def samples(session: Session, profile_id: str, caller: Caller = ANYBODY) -> Samples:
    """Positions and heights, m.

    Raises
    ------
    UnknownProfileError
    """
    visible = Profile.id == profile_id, *visibility.profiles(caller)
    packed = session.scalar(select(Profile.samples).where(*visible))
    if packed is None:
        raise UnknownProfileError(profile_id)
    values = struct.unpack(f"<{len(packed) // 8}d", packed)
    return values[: len(values) // 2], values[len(values) // 2 :]


def used_by(cases: Iterable[Case]) -> list[str]:
    """Identifiers of the profiles that cases run over."""
    return sorted({each.profile for case in cases for each in _terms(case.irregularity) if isinstance(each, Measured)})


def lacking(session: Session, inputs: dict[str, Any]) -> str | None:
    """A profile that a case, as its ``Case.to_dict()``, runs over and that is not stored any more."""
    irregularity = inputs["irregularity"]
    named = [each["profile"] for each in irregularity.get("terms", [irregularity]) if "profile" in each]
    stored = set(session.scalars(select(Profile.id).where(Profile.id.in_(named))))
    return next((profile_id for profile_id in named if profile_id not in stored), None)


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


def held_by(session: Session, profile_id: str, count: int, *visible: ColumnElement[bool]) -> Sequence[str]:
    """Identifiers of so many studies, or of the visible ones, that use a profile."""
    using = select(Study.id).join(StudyProfile).where(StudyProfile.profile_id == profile_id, *visible)
    return session.scalars(using.order_by(Study.created_at, Study.id).limit(count)).all()


def claim(session: Session, profile_id: str, key_id: int | None) -> None:
    """Let a profile be a key's, too."""
    if key_id is not None and session.get(ProfileKey, (profile_id, key_id)) is None:
        session.add(ProfileKey(profile_id=profile_id, key_id=key_id))


def disclaim(session: Session, profile_id: str, key_id: int | None) -> bool:
    """Let a profile be a key's no longer. Returns whether it is nobody's any more."""
    session.execute(delete(ProfileKey).where(ProfileKey.profile_id == profile_id, ProfileKey.key_id == key_id))
    return not session.scalar(select(exists().where(ProfileKey.profile_id == profile_id)))
