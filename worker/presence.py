"""Who is there to compute: each worker says so from time to time, in the table ``worker``."""

import os
import socket

from sqlalchemy import delete, func, select, update
from sqlalchemy.orm import Session

from app.db.models import Worker
from app.db.types import Clock


def own_name() -> str:
    """The name of the worker that this process is."""
    return f"{socket.gethostname()}:{os.getpid()}"


def announce(session: Session, name: str, lasting_s: float, draining: bool = False) -> None:
    """Say that a worker is there for some time."""
    values = {"expires": Clock() + lasting_s, "draining": draining}
    known = update(Worker).where(Worker.name == name).values(values).returning(Worker.name)
    if session.scalar(known) is None:
        session.add(Worker(name=name, **values))


def forget(session: Session) -> None:
    """Forget those that have not said in their time that they are there."""
    session.execute(delete(Worker).where(Worker.expires < Clock()))


def is_among_the_first(session: Session, name: str, number: int) -> bool:
    """Whether a worker, there or not, is one of so many whose names come first: for what not all need to do."""
    before = select(Worker.name).where(Worker.name < name, Worker.expires > Clock()).limit(number)
    return len(session.scalars(before).all()) < number


def count_with(session: Session, name: str) -> int:
    """How many workers take cases, this one among them whether it has said so or not."""
    others = select(func.count()).where(Worker.expires > Clock(), ~Worker.draining, Worker.name != name)
    return 1 + (session.scalar(others) or 0)
