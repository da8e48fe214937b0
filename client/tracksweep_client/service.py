"""The service as scripts use it: studies in, progress and peaks out."""

import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self, TypeVar, cast
from uuid import uuid4

import httpx

from . import events
from .connection import connect
from .generated.api.cases import list_cases
from .generated.api.peaks import export_peaks_csv, export_peaks_parquet, list_peaks
from .generated.api.studies import (
    cancel_study,
    create_study,
    estimate_study,
    get_study,
    list_studies,
    retry_study,
    watch_study,
)
from .generated.errors import UnexpectedStatus
from .generated.models import (
    CaseSummary,
    PeakRow,
    ProblemDetails,
    StudyDetail,
    StudyEstimate,
    StudyRequest,
    StudySummary,
)
from .generated.types import UNSET, Response
from .progress import shown

if TYPE_CHECKING:
    import pandas as pd

RECONNECTIONS = 10  # in a row without any news
RECONNECT_AFTER_S = 1.0

T = TypeVar("T")
Study = StudyRequest | Mapping[str, Any]


class _AsItIs(dict[str, Any]):
    """A study that the service is to judge, not the client."""

    def to_dict(self) -> dict[str, Any]:
        return self


class Service:
    """A connection to a running service; close it or use it in a ``with`` statement.

    Parameters
    ----------
    url : str, optional
        Where the service is, without ``/v1``. From ``TRACKSWEEP_URL`` when not given.
    api_key : str, optional
        From ``TRACKSWEEP_API_KEY`` when not given.

    Attributes
    ----------
    client : AuthenticatedClient
        For the functions in ``tracksweep_client.generated.api``, which are all operations of the service.

    Notes
    -----
    Every method raises :class:`ProblemError` when the service refuses, and ``httpx.HTTPError`` when it does not answer.
    """

    def __init__(self, url: str | None = None, api_key: str | None = None) -> None:
        self.client = connect(url, api_key)

    def submit(self, study: Study, idempotency_key: str | None = None) -> StudyDetail:
        """Submit a study, once, however often this request has to be sent.

        Parameters
        ----------
        study : StudyRequest or mapping
            The latter as ``POST /v1/studies`` takes it.
        idempotency_key : str, optional
            Any unique text, by which a script that is run again gets the study it created before.
        """
        key = idempotency_key or uuid4().hex
        return _given(create_study.sync_detailed(client=self.client, body=_body(study), idempotency_key=key))

    def estimate(self, study: Study) -> StudyEstimate:
        """What a study would take, and what to beware of, without creating it."""
        return _given(estimate_study.sync_detailed(client=self.client, body=_body(study)))

    def study(self, study_id: str) -> StudyDetail:
        """A study as it is now."""
        return _given(get_study.sync_detailed(study_id, client=self.client))

    def studies(self, **filters: Any) -> Iterator[StudySummary]:
        """All studies, or those that pass the filters of ``list_studies``."""
        return self._items(list_studies.sync_detailed, **filters)

    def cancel(self, study_id: str) -> StudyDetail:
        """Cancel what is left of a study."""
        return _given(cancel_study.sync_detailed(study_id, client=self.client))

    def retry(self, study_id: str) -> StudyDetail:
        """Queue the failed and cancelled cases of a study once more."""
        return _given(retry_study.sync_detailed(study_id, client=self.client))

    def cases(self, study_id: str, **filters: Any) -> Iterator[CaseSummary]:
        """The cases of a study, or those that pass the filters of ``list_cases``."""
        return self._items(list_cases.sync_detailed, study_id=study_id, **filters)

    def peaks(self, **filters: Any) -> Iterator[PeakRow]:
        """Peaks of all studies, or those that pass the filters of ``list_peaks``: ``study_id``, ``quantity``, …"""
        return self._items(list_peaks.sync_detailed, **filters)

    def to_dataframe(self, **filters: Any) -> "pd.DataFrame":
        """The same as a table of Pandas."""
        import pandas as pd

        return pd.read_csv(_given(export_peaks_csv.sync_detailed(client=self.client, **filters)).payload)

    def save_peaks(self, path: Path | str, kind: Literal["csv", "parquet"] = "csv", **filters: Any) -> None:
        """The same as a file, however large."""
        operation = {"csv": export_peaks_csv, "parquet": export_peaks_parquet}[kind]
        request = operation._get_kwargs(**filters)
        with self.client.get_httpx_client().stream(**request) as answer, Path(path).open("wb") as file:
            for chunk in answer.iter_bytes():
                file.write(chunk)

    def watch(self, study_id: str, after: int = 0) -> Iterator[events.Event]:
        """What happens to a study, until it has ended. A stream that is cut is taken up where it was cut.

        Parameters
        ----------
        study_id : str
        after : int
            Only what came after the event with this id.
        """
        failures, last = 0, None
        while True:
            request = watch_study._get_kwargs(study_id, last_event_id_header=after)
            try:
                with self.client.get_httpx_client().stream(**request) as answer:
                    if answer.status_code == 204:  # there is no more
                        return
                    for last in events.read(answer.iter_lines()):
                        failures, after = 0, last.id or after
                        yield last
            except httpx.TransportError:
                failures += 1
                if failures > RECONNECTIONS:
                    raise
            if last is not None and last.kind == "done":
                return
            time.sleep(RECONNECT_AFTER_S)

    def wait(self, study_id: str, *, progress: bool = True) -> StudyDetail:
        """Wait until a study has ended; the study then.

        Parameters
        ----------
        study_id : str
        progress : bool
            Whether to show how far it is.
        """
        with shown() if progress else nullcontext() as show:
            for event in self.watch(study_id):
                if show is not None and event.kind == "progress":
                    show(event.data)
        return self.study(study_id)

    def close(self) -> None:
        """Close the connection."""
        self.client.get_httpx_client().close()

    def _items(self, operation: Callable[..., Response[Any]], **filters: Any) -> Iterator[Any]:
        cursor: Any = UNSET
        while cursor is not None:
            page = _given(operation(client=self.client, cursor=cursor, **filters))
            yield from page.items
            cursor = page.next_cursor

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _body(study: Study) -> StudyRequest:
    return study if isinstance(study, StudyRequest) else cast(StudyRequest, _AsItIs(study))


def _given(response: Response[T | ProblemDetails]) -> T:
    """What an operation gives when it succeeds. Problems were raised before; a proxy may still answer anything."""
    if response.parsed is None or isinstance(response.parsed, ProblemDetails):
        raise UnexpectedStatus(response.status_code, response.content)
    return response.parsed
