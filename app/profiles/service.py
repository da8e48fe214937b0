"""What can be done with profiles."""

import re

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.access import visibility
from app.access.caller import Caller
from app.cases.irregularities import whole_band
from app.cases.queue import one_at_a_time
from app.context import Context
from app.db.models import Profile
from app.pagination import Order, fetch_page
from app.problems import Problem, invalid, not_found
from app.profiles import repository
from app.profiles.schemas import ProfileInfo, ProfilePage, ProfileQuery
from solver.profile import read_profile
from solver.quantity import InvalidParameterError
from solver.railhead import MAX_POINTS, MIN_POINTS, Samples, profile_digest

HEADER = "x_m,eta_m"
MAX_LINE, MAX_LINES = 1000, 5 * MAX_POINTS
LINE_ENDS = "\n\r\v\f\x1c\x1d\x1e\x85\u2028\u2029"  # for str.splitlines
_LONG_LINE = re.compile(f"[^{LINE_ENDS}]{{{MAX_LINE + 1}}}")
MAX_NAMED = 10  # studies that a refusal names


def create(context: Context, text: str, caller: Caller) -> ProfileInfo:
    """Store a profile, or find the one with the same samples.

    Raises
    ------
    Problem
        422 if it cannot be read, with the line.
    """
    samples = _read(text)
    profile = _row(samples)
    with context.database.write() as session:
        one_at_a_time(session)
        known = session.get(Profile, profile.id)
        if known is None:
            session.add(profile)
            session.flush()
        repository.claim(session, profile.id, caller.key_id)
        return ProfileInfo.model_validate(known or profile)


def _read(text: str) -> Samples:
    _measure(text)
    try:
        samples = read_profile(text)
    except InvalidParameterError as error:
        pointer = "/" + error.parameter.replace(" ", "/")
        raise invalid(pointer, "unreadable-line", f"{error.parameter.capitalize()} {error.problem}.") from None
    if (count := len(samples[0])) < MIN_POINTS:
        raise invalid("", "too-few-points", f"A profile has at least {MIN_POINTS} points, this one has {count}.")
    return samples


def _measure(text: str) -> None:
    """Refuse what would take long to read, or much memory."""
    if (long := _LONG_LINE.search(text)) is not None:
        n = len(text[: long.start() + 1].splitlines())
        raise invalid(f"/line/{n}", "unreadable-line", f"Line {n} has more than {MAX_LINE} characters.")
    if sum(map(text.count, LINE_ENDS)) > MAX_LINES:
        raise invalid("", "too-many-lines", f"There are more than {MAX_LINES} lines, empty ones and remarks included.")


def _row(samples: Samples) -> Profile:
    positions, heights = samples
    band = whole_band(positions)
    if band.min >= band.max:
        detail = f"A gap between points is as wide as half the profile, {band.min / 2:g} m; no wavelength can be used."
        raise invalid("", "gap-too-wide", detail)
    return Profile(
        id=profile_digest(positions, heights),
        samples=repository.pack(samples),
        points=len(positions),
        start_m=positions[0],
        end_m=positions[-1],
        wavelength_min_m=band.min,
        wavelength_max_m=band.max,
        lowest_mm=min(heights) * 1e3,
        highest_mm=max(heights) * 1e3,
    )


def get(session: Session, profile_id: str) -> ProfileInfo:
    """One profile.

    Raises
    ------
    Problem
        404 if there is none.
    """
    return ProfileInfo.model_validate(_find(session, profile_id))


def csv(session: Session, profile_id: str) -> bytes:
    """The samples of a profile, to the last digit: uploaded again they are the same profile.

    Raises
    ------
    Problem
        404 if there is none.
    """
    _find(session, profile_id)
    rows = (f"{x!r},{height!r}" for x, height in zip(*repository.samples(session, profile_id), strict=True))
    return "\n".join([HEADER, *rows, ""]).encode()


def list_page(session: Session, query: ProfileQuery, max_page_size: int, caller: Caller) -> ProfilePage:
    """A page of the profiles that the caller sees."""
    order = Order((Profile.created_at, Profile.id), descending=query.sort.startswith("-"))
    rows, cursor = fetch_page(session, select(Profile).where(*visibility.profiles(caller)), query, order, max_page_size)
    return ProfilePage(items=[ProfileInfo.model_validate(row.Profile) for row in rows], next_cursor=cursor)


def remove(context: Context, profile_id: str, caller: Caller) -> None:
    """Delete a profile that no study uses. One that others have stored or use too is only forgotten for the caller.

    Raises
    ------
    Problem
        404 if there is none, 409 if a study uses it.
    """
    with context.database.write() as session:
        one_at_a_time(session)
        profile = _find(session, profile_id)
        if using := repository.held_by(session, profile_id, MAX_NAMED + 1, *visibility.studies(caller)):
            named = [*using[:MAX_NAMED], *["others"] * (len(using) > MAX_NAMED)]
            raise Problem(409, f"Used by studies, to be deleted first: {', '.join(named)}.", code="profile-in-use")
        nobodys = caller.is_admin or repository.disclaim(session, profile_id, caller.key_id)
        if nobodys and not repository.held_by(session, profile_id, 1):
            session.delete(profile)


def _find(session: Session, profile_id: str) -> Profile:
    profile = session.get(Profile, profile_id)
    if profile is None:
        raise not_found("profile")
    return profile
