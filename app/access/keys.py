"""API keys in the database. A key is ``ts_ID_SECRET``; of the secret only a hash is stored."""

import hashlib
import hmac
import re
import secrets
from collections.abc import Sequence
from contextlib import suppress

from sqlalchemy import or_, select, update
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from app.db.models import ApiKey, Scope
from app.db.session import Database
from app.db.types import Clock

NAME, MAX_NAME = r"[A-Za-z0-9][A-Za-z0-9._@-]*", 64
USED_AGAIN_AFTER_S = 3600.0  # a write per request would be dear, and nobody needs it

_FORM = re.compile(r"ts_(\d{1,18})_(\S+)", re.ASCII)


class KeyNameError(ValueError):
    """It cannot be a name, there is no such key, or there is one already."""


def create(
    session: Session, name: str, scope: Scope, max_queued_cases: int | None, cpu_s_per_day: float | None
) -> tuple[ApiKey, str]:
    """A new key, and what its owner has to send, which nobody can tell again.

    Raises
    ------
    KeyNameError
        If it cannot be a name, or is taken, be it by a revoked key.
    """
    if len(name) > MAX_NAME or re.fullmatch(NAME, name) is None:
        raise KeyNameError(f"A name has at most {MAX_NAME} letters, digits and . _ @ -, a letter or digit first.")
    if _by_name(session, name) is not None:
        raise KeyNameError(f"There is a key {name} already. To give it another secret, renew it.")
    key = ApiKey(name=name, scope=scope, max_queued_cases=max_queued_cases, cpu_s_per_day=cpu_s_per_day, hash="")
    session.add(key)
    return key, _give_secret(session, key)


def renew(session: Session, name: str) -> tuple[ApiKey, str]:
    """Give a key another secret; the one before is void. A revoked key is valid again and has its studies.

    Raises
    ------
    KeyNameError
    """
    key = find(session, name)
    key.revoked_at = None
    return key, _give_secret(session, key)


def revoke(session: Session, name: str) -> ApiKey:
    """Void a key. Its studies stay.

    Raises
    ------
    KeyNameError
    """
    key = find(session, name)
    if key.revoked_at is None:
        key.revoked_at = Clock()
        session.flush()
        session.refresh(key)
    return key


def find(session: Session, name: str) -> ApiKey:
    """The key of a name.

    Raises
    ------
    KeyNameError
    """
    if (key := _by_name(session, name)) is None:
        raise KeyNameError(f"There is no key {name}.")
    return key


def find_all(session: Session) -> Sequence[ApiKey]:
    """All keys, revoked ones too, by name."""
    return session.scalars(select(ApiKey).order_by(ApiKey.name)).all()


def any_valid(session: Session) -> bool:
    """Whether anybody has a key."""
    return session.scalar(select(ApiKey.id).where(ApiKey.revoked_at.is_(None)).limit(1)) is not None


def authenticate(database: Database, sent: str) -> ApiKey | None:
    """The key that was sent, if it is valid."""
    if (parts := _FORM.fullmatch(sent)) is None:
        return None
    lately = Clock() - USED_AGAIN_AFTER_S
    stale = or_(ApiKey.last_used_at.is_(None), ApiKey.last_used_at < lately)
    wanted = select(ApiKey, stale.label("stale")).where(ApiKey.id == int(parts[1]), ApiKey.revoked_at.is_(None))
    with database.read() as session:
        row = session.execute(wanted).one_or_none()
    if row is None or not hmac.compare_digest(row.ApiKey.hash, _hash(parts[2])):
        return None
    if row.stale:
        with suppress(SQLAlchemyError), database.write() as session:  # on a full disk one can still read
            session.execute(update(ApiKey).where(ApiKey.id == row.ApiKey.id).values(last_used_at=Clock()))
    return row.ApiKey


def _by_name(session: Session, name: str) -> ApiKey | None:
    return session.scalars(select(ApiKey).where(ApiKey.name == name)).one_or_none()


def _give_secret(session: Session, key: ApiKey) -> str:
    secret = secrets.token_urlsafe(32)
    key.hash = _hash(secret)
    session.flush()
    session.refresh(key)
    return f"ts_{key.id}_{secret}"


def _hash(secret: str) -> str:
    return hashlib.sha256(secret.encode()).hexdigest()
