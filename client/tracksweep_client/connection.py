"""HTTP as the service speaks it: its problems are raised, and when it says to come back later, that is done."""

import asyncio
import logging
import os
import time
from typing import Any
from urllib.parse import urlsplit

import httpx

from .generated import AuthenticatedClient
from .generated.models import FieldProblem, ProblemDetails

DEFAULT_URL = "http://127.0.0.1:8000"
TIMEOUT_S = 30
ATTEMPTS = 5
LONGEST_PAUSE_S = 60
SILENT_PAUSE_S = 5  # a longer one is told of

log = logging.getLogger("tracksweep_client")


class ProblemError(Exception):
    """The service's answer when it cannot do what was asked (RFC 9457).

    Attributes
    ----------
    status : int
        Of the HTTP answer.
    code : str
        Stable name of the reason, listed in the service's documentation; empty if a proxy answered.
    errors : list of FieldProblem
        The fields of the request it concerns, each with ``pointer``, ``code`` and ``detail``.
    """

    def __init__(self, response: httpx.Response) -> None:
        self.status = response.status_code
        self.code = ""
        self.errors: list[FieldProblem] = []
        message = f"The service answered {response.status_code} {response.reason_phrase}."
        if (problem := _problem(response)) is not None:
            self.code, self.errors, message = problem.code, problem.errors, problem.detail
        super().__init__("\n".join([message, *(f"  {error.pointer}: {error.detail}" for error in self.errors)]))


class PatientClient(httpx.Client):
    """Comes back when it is told to, a few times, and raises what is no success."""

    def send(self, request: httpx.Request, **options: Any) -> httpx.Response:
        """Send one request; every kind of call ends here."""
        attempt = 1
        while (response := super().send(request, **options)).is_error:
            response.read()
            if (pause_s := _pause_s(response, attempt)) is None:
                raise ProblemError(response)
            time.sleep(pause_s)
            attempt += 1
        return response


class PatientAsyncClient(httpx.AsyncClient):
    """The same, to be awaited."""

    async def send(self, request: httpx.Request, **options: Any) -> httpx.Response:
        """Send one request."""
        attempt = 1
        while (response := await super().send(request, **options)).is_error:
            await response.aread()
            if (pause_s := _pause_s(response, attempt)) is None:
                raise ProblemError(response)
            await asyncio.sleep(pause_s)
            attempt += 1
        return response


def _problem(response: httpx.Response) -> ProblemDetails | None:
    """What the service says is wrong; None if somebody else says so."""
    if response.headers.get("Content-Type", "").startswith("application/problem+json"):
        return ProblemDetails.from_dict(response.json())
    return None


def _pause_s(response: httpx.Response, attempt: int) -> float | None:
    """Seconds until the next attempt; None if this answer is to be taken.

    Nothing is done twice by that: a request that was told to come back later has had no effect. A quota is not waited
    for: it is free again when cases are computed, or tomorrow, and whoever asked may rather ask for less.
    """
    later = response.headers.get("Retry-After", "")
    if response.status_code not in (409, 429, 503) or not later.isdecimal() or attempt >= ATTEMPTS:
        return None
    problem = _problem(response)
    if float(later) > LONGEST_PAUSE_S or (problem is not None and problem.code == "quota-exceeded"):
        return None
    if float(later) > SILENT_PAUSE_S:
        why = problem.detail if problem is not None else response.reason_phrase
        log.warning("The service asks to come back in %s s: %s", later, why)
    return float(later)


def connect(url: str | None = None, api_key: str | None = None) -> AuthenticatedClient:
    """A client for the generated functions, both for their ``sync`` and their ``asyncio`` forms.

    Parameters
    ----------
    url : str, optional
        Where the service is, without ``/v1``. From ``TRACKSWEEP_URL`` when not given.
    api_key : str, optional
        From ``TRACKSWEEP_API_KEY`` when not given; a service that needs none ignores it.
    """
    url = (url or os.environ.get("TRACKSWEEP_URL") or DEFAULT_URL).rstrip("/")
    key = api_key or os.environ.get("TRACKSWEEP_API_KEY", "")
    options: dict[str, Any] = {
        "base_url": url,
        "headers": {"Authorization": f"Bearer {key}"} if key else {},
        "timeout": TIMEOUT_S,
        "follow_redirects": True,  # into the bucket of histories, where the key is not sent
        "trust_env": urlsplit(url).hostname not in ("127.0.0.1", "localhost", "::1"),  # no proxy to oneself
    }
    client = AuthenticatedClient(base_url=url, token=key)
    return client.set_httpx_client(PatientClient(**options)).set_async_httpx_client(PatientAsyncClient(**options))
