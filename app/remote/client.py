"""The service over HTTP: studies in, progress and peaks out."""

import json
import time
from collections.abc import Iterator, Mapping
from types import TracebackType
from typing import Any, Self
from urllib.parse import urlsplit

import httpx

from app.settings import Settings

ENDED = frozenset({"succeeded", "partially_failed", "failed", "cancelled"})
POLL_S = 0.5

Json = dict[str, Any]


class ProblemError(Exception):
    """The service's answer when it cannot do what was asked (RFC 9457)."""

    def __init__(self, status: int, problem: Mapping[str, Any]) -> None:
        self.status = status
        self.fields = [(each["pointer"], each["detail"]) for each in problem.get("errors", [])]
        super().__init__(problem.get("detail") or problem.get("title") or f"The service answered {status}.")


def service_url(settings: Settings) -> str:
    """The service that is named by the settings or else serves the data folder."""
    if settings.url:
        return settings.url
    try:
        return str(json.loads((settings.data_dir / "serve.json").read_text())["url"])
    except (OSError, ValueError, KeyError):
        return f"http://{settings.host}:{settings.port}"


class Service:
    """A connection to the service; close it or use it in a ``with`` statement.

    Parameters
    ----------
    url : str
        Where the service is, without ``/v1``.
    """

    def __init__(self, url: str) -> None:
        local = urlsplit(url).hostname in ("127.0.0.1", "localhost", "::1")
        self._http = httpx.Client(base_url=f"{url.rstrip('/')}/v1", timeout=30, trust_env=not local)

    def submit(self, study: Json) -> Json:
        """Post a study; the study as stored."""
        return self._ask("POST", "/studies", json=study)

    def study(self, study_id: str) -> Json:
        """A study as it is now."""
        return self._ask("GET", f"/studies/{study_id}")

    def watch(self, study_id: str) -> Iterator[Json]:
        """A study again and again, until it has ended."""
        while True:
            study = self.study(study_id)
            yield study
            if study["state"] in ENDED:
                return
            time.sleep(POLL_S)

    def peaks(self, **filters: Any) -> Iterator[Json]:
        """Peaks of all studies, narrowed by filters (``study_id``, ``quantity``, ``speed_kmh_min``, …)."""
        query = {name: value for name, value in filters.items() if value is not None}
        while True:
            page = self._ask("GET", "/peaks", params=query)
            yield from page["items"]
            if page["next_cursor"] is None:
                return
            query["cursor"] = page["next_cursor"]

    def _ask(self, method: str, path: str, **request: Any) -> Json:
        answer = self._http.request(method, path, **request)
        if answer.is_error:
            is_problem = answer.headers.get("content-type", "").startswith("application/problem+json")
            raise ProblemError(answer.status_code, answer.json() if is_problem else {})
        body: Json = answer.json()
        return body

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._http.close()
