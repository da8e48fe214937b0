"""What can be done with stored histories. NumPy and Arrow are loaded when the first of them is read."""

import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from typing import TYPE_CHECKING, BinaryIO

from sqlalchemy.orm import Session

from app.cases.schemas import case_file
from app.context import Context
from app.db.models import Case, History
from app.histories.schemas import HistoryQuery, HistoryView, SpectrumQuery, SpectrumView
from app.problems import Problem, not_found, unavailable
from app.storage import STORE_ERRORS

if TYPE_CHECKING:
    from app.histories.archive import Archive


@dataclass(frozen=True)
class Stored:
    """A case and where its history lies."""

    case: Case
    history: History

    def etag(self, *asked: str) -> str:
        """Of what is made from the history."""
        return f'"{hashlib.sha256(":".join((self.history.digest, *asked)).encode()).hexdigest()}"'


def find(session: Session, case_id: int) -> Stored:
    """The history of a case.

    Raises
    ------
    Problem
        404 if there is no such case or no history of it.
    """
    case = session.get(Case, case_id)
    if case is None:
        raise not_found("case")
    history = session.get(History, case_id)
    if history is None:
        detail = "No history of this case is stored: it is not computed yet, or no study asked to keep it."
        raise Problem(404, detail, code="history-not-kept")
    return Stored(case, history)


def read(context: Context, stored: Stored, part: range) -> Iterator[bytes]:
    """Some bytes of the archive.

    Raises
    ------
    Problem
        503 if the store does not answer.
    """
    with _store_errors():
        return context.histories.read(stored.history.key, part)


def link(context: Context, stored: Stored) -> str | None:
    """Where to read the archive without this service; None if the settings or the store do not provide for that.

    Raises
    ------
    Problem
        503 if there are no credentials to sign it with.
    """
    if not context.settings.presigned_s:
        return None
    with _store_errors():
        return context.histories.link(stored.history.key, context.settings.presigned_s)


def view(context: Context, stored: Stored, query: HistoryQuery) -> HistoryView:
    """What is to be drawn.

    Raises
    ------
    Problem
        503 if the store does not answer.
    """
    from app.histories.archive import sample  # noqa: PLC0415

    with _opened(context, stored) as archive:
        samples, channels = sample(archive, query)
        start_m = float(archive.track_position_m[0])
    return HistoryView(
        case_id=stored.case.id,
        digest=stored.history.digest,
        samples=samples,
        speed_kmh=stored.case.speed_kmh,
        track_position_start_m=start_m,
        channels=channels,
    )


def spectrum(context: Context, stored: Stored, query: SpectrumQuery) -> SpectrumView:
    """The spectrum of one channel.

    Raises
    ------
    Problem
        404 if the history has no such channel; 503 if the store does not answer.
    """
    from app.histories.spectrum import spectrum  # noqa: PLC0415

    with _opened(context, stored) as archive:
        return spectrum(archive, stored.case.inputs, query)


def write_parquet(context: Context, stored: Stored, file: BinaryIO) -> None:
    """Write all of the history to a file, as Parquet.

    Raises
    ------
    Problem
        503 if the store does not answer or the disk is full.
    """
    from app.histories.parquet import write  # noqa: PLC0415

    case = stored.case
    origin = {"case_digest": case.digest, "solver_version": case.solver_version, "inputs": case_file(case.inputs)}
    with _opened(context, stored) as archive:
        write(archive, origin | {"history_digest": stored.history.digest}, file)


def parquet_etag(stored: Stored) -> str:
    """The same bytes come only from the same writer."""
    return stored.etag("parquet", version("tracksweep"), version("pyarrow"))


@contextmanager
def _opened(context: Context, stored: Stored) -> Iterator["Archive"]:
    from app.histories.archive import DamagedError, opened  # noqa: PLC0415

    with _store_errors():
        try:
            with opened(context.histories.read(stored.history.key), stored.history.digest) as archive:
                yield archive
        except DamagedError:
            raise Problem(503, "The stored history of this case is damaged.", code="history-damaged") from None


@contextmanager
def _store_errors() -> Iterator[None]:
    try:
        yield
    except STORE_ERRORS as error:
        raise unavailable(f"The history store does not answer: {type(error).__name__}.", error) from error
