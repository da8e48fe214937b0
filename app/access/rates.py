"""How often one may ask: counted per key or address, and told in the headers of every answer.

The headers are those of draft-ietf-httpapi-ratelimit-headers-10. Processes that share a Redis as their broker count
together, others each for itself.
"""

import math
import time
from typing import Literal, NamedTuple

import structlog
from limits import RateLimitItemPerMinute
from limits.errors import StorageError
from limits.storage import MemoryStorage, storage_from_string
from limits.strategies import FixedWindowRateLimiter

from app.problems import Problem
from app.settings import Settings

Policy = Literal["reads", "writes"]
WINDOW_S = 60
RETRY_SHARED_AFTER_S = 10.0

log = structlog.get_logger()


class Rate(NamedTuple):
    """What is left to somebody."""

    policy: Policy
    limit: int
    left: int
    reset_s: int
    allowed: bool

    def headers(self) -> dict[str, str]:
        """The same as HTTP has it."""
        return {
            "RateLimit-Policy": f'"{self.policy}";q={self.limit};w={WINDOW_S}',
            "RateLimit": f'"{self.policy}";r={self.left};t={self.reset_s}',
        }

    def check(self) -> None:
        """Raise a 429 if it was too often."""
        if not self.allowed:
            detail = f"More than {self.limit} {self.policy} in a minute. Try again in {self.reset_s} s."
            raise Problem(429, detail, code="rate-limited", headers={"Retry-After": str(self.reset_s)})


class Rates:
    """Counts requests."""

    def __init__(self, settings: Settings) -> None:
        self.limits: dict[Policy, int] = {"reads": settings.reads_per_minute, "writes": settings.writes_per_minute}
        self._items = {policy: RateLimitItemPerMinute(limit) for policy, limit in self.limits.items() if limit}
        self._own = FixedWindowRateLimiter(MemoryStorage())
        self._shared: FixedWindowRateLimiter | None = None
        if settings.broker_url.startswith(("redis://", "rediss://")):
            patience = {"socket_connect_timeout": 0.5, "socket_timeout": 0.5}
            storage = storage_from_string(settings.broker_url, wrap_exceptions=True, **patience)
            self._shared = FixedWindowRateLimiter(storage)
        self._shared_from = 0.0  # when the shared counts may be asked again, by the monotonic clock

    @property
    def waits(self) -> bool:
        """Whether counting may take longer than a moment."""
        return self._shared is not None

    def hit(self, policy: Policy, who: str) -> Rate | None:
        """Count a request; None if any number is allowed."""
        if (item := self._items.get(policy)) is None:
            return None
        if self._shared is not None and time.monotonic() >= self._shared_from:
            try:
                return _hit(self._shared, item, policy, who)
            except StorageError as error:  # better a limit per process than no service
                self._shared_from = time.monotonic() + RETRY_SHARED_AFTER_S
                log.warning("requests are counted per process", error=str(error.storage_error))
        return _hit(self._own, item, policy, who)


def _hit(limiter: FixedWindowRateLimiter, item: RateLimitItemPerMinute, policy: Policy, who: str) -> Rate:
    allowed = limiter.hit(item, policy, who)
    reset, left = limiter.get_window_stats(item, policy, who)
    return Rate(policy, item.amount, left, max(1, math.ceil(reset - time.time())), allowed)
