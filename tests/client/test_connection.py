"""How the client behaves when the service is busy, refuses, or breaks off. The transport stands for the network."""

import asyncio
import json
import time
from collections.abc import Callable, Iterator
from typing import Any

import httpx
import pytest

from tracksweep_client import Event, ProblemError, Service, connect, service
from tracksweep_client.connection import ATTEMPTS, PatientAsyncClient, PatientClient
from tracksweep_client.generated.api.studies import get_study

Answer = Callable[[httpx.Request], httpx.Response]
BUSY = {"status_code": 503, "headers": {"Retry-After": "0"}}
LOST = {
    "type": "about:blank",
    "title": "Not Found",
    "status": 404,
    "detail": "There is no such study.",
    "instance": "/v1/studies/1",
    "code": "not-found",
    "request_id": "1",
    "errors": [{"pointer": "/name", "code": "missing", "detail": "Field required"}],
}


def answering(answers: Iterator[httpx.Response], seen: list[httpx.Request]) -> httpx.MockTransport:
    def answer(request: httpx.Request) -> httpx.Response:
        seen.append(request)
        return next(answers)

    return httpx.MockTransport(answer)


def to(transport: httpx.BaseTransport) -> Service:
    service = Service("http://service")
    service.client.set_httpx_client(PatientClient(base_url="http://service", transport=transport))
    return service


def test_it_comes_back_when_told_to_with_the_same_key() -> None:
    seen: list[httpx.Request] = []
    problem = httpx.Response(422, json=LOST | {"status": 422}, headers={"Content-Type": "application/problem+json"})
    soon = [httpx.Response(**BUSY | {"status_code": status}) for status in (503, 429, 409)]
    busy = to(answering(iter([*soon, problem]), seen))
    with pytest.raises(ProblemError) as caught:
        busy.submit({"name": "A study"})
    assert (caught.value.status, caught.value.code) == (422, "not-found")
    assert [error.pointer for error in caught.value.errors] == ["/name"]
    assert str(caught.value) == "There is no such study.\n  /name: Field required"
    assert [json.loads(request.content) for request in seen] == [{"name": "A study"}] * 4
    assert len({request.headers["Idempotency-Key"] for request in seen}) == 1


def test_it_gives_up_at_last() -> None:
    seen: list[httpx.Request] = []
    with pytest.raises(ProblemError):
        to(answering(iter([httpx.Response(**BUSY)] * 10), seen)).study("1")
    assert len(seen) == ATTEMPTS


@pytest.mark.parametrize("later", [None, "Wed, 21 Oct 2015 07:28:00 GMT", "86400"])
def test_it_does_not_guess_nor_wait_for_long(later: str | None) -> None:
    seen: list[httpx.Request] = []
    away = httpx.Response(503, headers={"Retry-After": later} if later else {})
    with pytest.raises(ProblemError, match="503"):
        to(answering(iter([away]), seen)).study("1")
    assert len(seen) == 1


QUOTA = LOST | {"status": 429, "code": "quota-exceeded", "detail": "Too many cases."}


def test_a_quota_is_not_waited_for() -> None:
    seen: list[httpx.Request] = []
    headers = {"Content-Type": "application/problem+json", "Retry-After": "1"}
    with pytest.raises(ProblemError, match="Too many cases") as caught:
        to(answering(iter([httpx.Response(429, json=QUOTA, headers=headers)]), seen)).submit({"name": "A study"})
    assert (caught.value.code, len(seen)) == ("quota-exceeded", 1)


def test_a_long_wait_is_told_of(monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture) -> None:
    pauses: list[float] = []
    monkeypatch.setattr(time, "sleep", pauses.append)
    headers = {"Content-Type": "application/problem+json", "Retry-After": "59"}
    limited = httpx.Response(429, json=QUOTA | {"code": "rate-limited", "detail": "Too often."}, headers=headers)
    with pytest.raises(ProblemError):
        to(answering(iter([httpx.Response(**BUSY), limited, httpx.Response(404)]), [])).study("1")
    assert pauses == [0, 59]
    assert caplog.messages == ["The service asks to come back in 59 s: Too often."]


def test_the_same_without_blocking() -> None:
    seen: list[httpx.Request] = []
    gone = httpx.Response(404, json=LOST, headers={"Content-Type": "application/problem+json"})
    client = connect("http://service")
    transport = answering(iter([httpx.Response(**BUSY), gone]), seen)
    client.set_async_httpx_client(PatientAsyncClient(base_url="http://service", transport=transport))
    with pytest.raises(ProblemError, match="no such study"):
        asyncio.run(get_study.asyncio("1", client=client))
    assert len(seen) == 2


def test_the_key_is_sent(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TRACKSWEEP_API_KEY", "secret")
    monkeypatch.setenv("TRACKSWEEP_URL", "http://elsewhere/")
    http = connect().get_httpx_client()
    assert (http.headers["Authorization"], str(http.base_url)) == ("Bearer secret", "http://elsewhere")


class Cut(httpx.SyncByteStream):
    """A stream that is cut."""

    def __iter__(self) -> Iterator[bytes]:
        yield b'event: progress\ndata: {"progress": 0}\n\n: keep-alive\n\n'
        yield b'id: 3\nevent: case\ndata: {"case_id": 1}\n\nid: 4\n'
        raise httpx.ReadError("cut")


def test_a_stream_that_is_cut_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(service, "RECONNECT_AFTER_S", 0)
    seen: list[httpx.Request] = []
    rest = 'id: 4\nevent: done\ndata: {"state":\ndata:  "failed"}\n\n'
    answers = iter([httpx.Response(200, stream=Cut()), httpx.Response(200, text=rest)])
    found = list(to(answering(answers, seen)).watch("1"))
    assert [request.headers["Last-Event-ID"] for request in seen] == ["0", "3"]
    assert [(event.kind, event.id) for event in found] == [("progress", None), ("case", 3), ("done", 4)]
    assert found[-1] == Event(kind="done", data={"state": "failed"}, id=4)


def test_a_service_that_is_gone_is_not_waited_for_for_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(service, "RECONNECT_AFTER_S", 0)

    def refuse(request: httpx.Request) -> Any:
        raise httpx.ConnectError("refused")

    with pytest.raises(httpx.ConnectError):
        list(to(httpx.MockTransport(refuse)).watch("1"))
