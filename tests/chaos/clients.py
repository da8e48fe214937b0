"""Clients of the service that do what its users do, all at once, and never give up on an answer."""

import hashlib
import json
import time
from collections.abc import Iterator
from contextlib import suppress
from random import Random
from threading import Event, Thread
from typing import Any

import httpx

from tests.chaos.record import Record

PATIENCE_S = 90.0  # for one answer, whatever breaks meanwhile
POLL_S = 0.5
ENDED = {"succeeded", "partially_failed", "failed", "cancelled"}
# The smallest numerics there are; a case takes some hundredths of a second, and a few times that in the longer windows.
NUMERICS = {
    "track_length_m": 90.0,
    "absorbing_length_m": 10.0,
    "elements_per_pad": 2,
    "time_step_s": 5e-4,
    "settle_s": 0.3,
}
WINDOWS_S = (0.05, 0.05, 0.05, 0.3, 1.0)
HOPELESS = {"track": {"pad_stiffness_n_per_m": 1e-6}, "vehicle": {"car_body_mass_kg": 1e6}}  # every case diverges


class UnansweredError(Exception):
    """The service gave no answer for so long that a client gave up."""


class Client(Thread):
    """Asks for one study after another until told to stop, and then sees the last one through, until it is over."""

    def __init__(self, url: str, record: Record, name: str, seed: int, stopping: Event, over: Event) -> None:
        super().__init__(name=name, daemon=True)
        self._http = httpx.Client(base_url=url, timeout=20, trust_env=False)
        self._record, self._stopping, self._over = record, stopping, over
        self._rng = Random(f"{seed} {name}")
        self._sweeps: list[dict[str, Any]] = []
        self._asked = 0

    def run(self) -> None:
        with self._http, suppress(UnansweredError):
            while not self._stopping.is_set():
                self._story()

    def _story(self) -> None:
        key = f"{self.name}-{self._asked}"
        self._asked += 1
        body = self._study(key)
        study_id = self._ask("POST", "/v1/studies", json=body, headers={"Idempotency-Key": key}, key=key)["id"]
        path, fate = f"/v1/studies/{study_id}", self._rng.random()
        if fate < 0.1:
            self._stopping.wait(self._rng.uniform(0, 1))
            self._ask("POST", f"{path}/cancel", study=study_id)
            if self._rng.random() < 0.5:
                self._ask("POST", f"{path}/retry", study=study_id)
        elif fate < 0.25:
            self._listen(study_id)
        while self._ask("GET", path, study=study_id)["state"] not in ENDED:
            if self._over.wait(POLL_S):
                return
        self._ask("GET", "/v1/peaks", study=study_id, params={"study_id": study_id, "page_size": 500})
        if body["keep_history"]:
            self._fetch_history(path)
        if self._rng.random() < 0.1:
            self._ask("DELETE", path, study=study_id)

    def _study(self, name: str) -> dict[str, Any]:
        """Cases that ride together and cases that do not; now and then the same as before."""
        if self._sweeps and self._rng.random() < 0.15:
            sweep = self._rng.choice(self._sweeps)
        else:
            amplitudes = [self._rng.randrange(1, 5000) / 10_000 for _ in range(self._rng.choice([1, 16, 64, 128]))]
            sweep = {
                "kind": "product",
                "speed_kmh": self._rng.sample(range(200, 351, 10), self._rng.choice([1, 1, 1, 2])),
                "irregularity": {"kind": "harmonic", "wavelength_m": [2.0], "amplitude_mm": sorted(set(amplitudes))},
            }
            self._sweeps.append(sweep)
        numerics = NUMERICS | {"window_s": self._rng.choice(WINDOWS_S)}
        body = {"name": name, "sweep": sweep, "numerics": numerics, "keep_history": self._rng.random() < 0.3}
        return body | (HOPELESS if self._rng.random() < 0.03 else {})

    def _fetch_history(self, path: str) -> None:
        items = self._ask("GET", f"{path}/cases")["items"]
        if case := next((each for each in items if each["state"] == "succeeded"), None):
            self._ask("GET", f"/v1/cases/{case['id']}/history.npz")

    def _ask(self, method: str, path: str, key: str = "", study: str = "", **request: Any) -> Any:
        """The answer to a request that is repeated until there is one, as the Python client does."""
        deadline = time.monotonic() + PATIENCE_S
        about = {"method": method, "path": path, "key": key, "study": study}
        while time.monotonic() < deadline and not self._over.is_set():
            try:
                answer = self._http.request(method, path, **request)
            except httpx.HTTPError as error:
                self._record.write("no answer", **about, error=type(error).__name__)
            else:
                told = _told(answer)
                self._record.write("answer", **about, **told)
                if not told["again"]:
                    return _content(answer)
            time.sleep(POLL_S)
        self._record.write("gave up", **about)
        raise UnansweredError

    def _listen(self, study_id: str) -> None:
        """Follow the events of a study to its end, going on where the stream was cut."""
        heard: list[int] = []
        ended = False
        while not ended and not self._over.is_set():
            with suppress(httpx.HTTPError):
                for number, kind in self._events(study_id, heard[-1] if heard else 0):
                    heard.append(number)
                    ended = kind == "done"
            time.sleep(POLL_S)
        self._record.write("heard", study=study_id, events=heard, ended=ended)

    def _events(self, study_id: str, after: int) -> Iterator[tuple[int, str]]:
        headers = {"Last-Event-ID": str(after)}
        with self._http.stream("GET", f"/v1/studies/{study_id}/events", headers=headers) as answer:
            number = 0
            for line in answer.iter_lines():
                field, _, value = line.partition(": ")
                if field == "id":
                    number = int(value)
                elif field == "event":
                    kind = value
                elif not line and number:  # the event is whole
                    yield number, kind
                    number = 0


def _told(answer: httpx.Response) -> dict[str, Any]:
    """What is recorded of an answer."""
    told: dict[str, Any] = {"status": answer.status_code, "again": "retry-after" in answer.headers}
    if answer.headers.get("content-type", "").endswith("json"):
        body = answer.json()
        told |= {name: body[name] for name in ("id", "state", "code") if name in body}
    elif "etag" in answer.headers:
        told["whole"] = answer.headers["etag"] == f'"{hashlib.sha256(answer.content).hexdigest()}"'
    return told


def _content(answer: httpx.Response) -> Any:
    with suppress(json.JSONDecodeError, UnicodeDecodeError):
        return answer.json()
    return None
