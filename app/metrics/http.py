"""Requests: counted, timed and logged by route."""

import os
import time
from typing import Any

import structlog
from prometheus_client import CollectorRegistry, Counter, Histogram, disable_created_metrics
from prometheus_client.multiprocess import MultiProcessCollector
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.metrics.together import FOLDER

BUCKETS_S = (0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1.0, 2.5, 5.0, 10.0)
METHODS = {"DELETE", "GET", "OPTIONS", "PATCH", "POST", "PUT"}
PROBES = {"/healthz", "/readyz", "/metrics"}  # counted, but nobody wants to read of each

log = structlog.get_logger()


class Requests:
    """The metrics of requests. Timed is how long the answer takes to begin: a stream of events goes on for hours."""

    def __init__(self) -> None:
        disable_created_metrics()  # type: ignore[no-untyped-call]
        self.registry = CollectorRegistry()
        own = None if FOLDER in os.environ else self.registry
        by = ["method", "route"]
        self.answered = Counter("tracksweep_http_requests", "Requests answered.", [*by, "status"], registry=own)
        self.took = Histogram(
            "tracksweep_http_request_seconds", "Time until the answer begins.", by, buckets=BUCKETS_S, registry=own
        )
        if own is None:
            MultiProcessCollector(self.registry)  # type: ignore[no-untyped-call]

    def observe(self, scope: Scope, status: int, took_s: float) -> None:
        """Count an answer, and log it."""
        method = scope["method"] if scope["method"] in METHODS else "other"
        route = getattr(scope.get("route"), "path", "none")  # a path that is none could be any
        self.answered.labels(method, route, str(status)).inc()
        self.took.labels(method, route).observe(took_s)
        if route not in PROBES:
            what: dict[str, Any] = {"method": method, "path": scope["path"], "status": status}
            log.info("request", **what, took_ms=round(1000 * took_s, 1), **scope.get("path_params", {}))


class RequestsMiddleware:
    """Observe every request."""

    def __init__(self, app: ASGIApp, requests: Requests) -> None:
        self.app = app
        self.requests = requests

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Handle one connection."""
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        began = time.perf_counter()
        begun = False

        async def send_observed(message: Message) -> None:
            nonlocal begun
            if message["type"] == "http.response.start":
                begun = True
                self.requests.observe(scope, message["status"], time.perf_counter() - began)
            await send(message)

        try:
            await self.app(scope, receive, send_observed)
        except Exception:
            if not begun:  # a fault of ours, answered beyond all middleware
                self.requests.observe(scope, 500, time.perf_counter() - began)
            raise
