"""The log: one JSON object per line, to standard error."""

import logging
import sys
import time
from contextlib import suppress

import structlog

SPARINGLY_S = 1.0

_FORM = (
    structlog.processors.add_log_level,
    structlog.processors.TimeStamper(fmt="iso", utc=True),
    structlog.processors.format_exc_info,
)
_said_at: dict[str, float] = {}


class _StandardError:
    """Standard error, which is a file on a disk that can be full: nobody fails for want of a line in the log."""

    def write(self, text: str) -> None:
        with suppress(OSError):
            sys.stderr.write(text)

    def flush(self) -> None:
        with suppress(OSError):
            sys.stderr.flush()


def configure() -> None:
    """Set up the log of this process."""
    structlog.configure(
        processors=[structlog.contextvars.merge_contextvars, *_FORM, structlog.processors.JSONRenderer()],
        logger_factory=structlog.WriteLoggerFactory(_StandardError()),  # type: ignore[arg-type]  # all it needs of a file
    )


def configure_libraries() -> None:
    """Have what libraries say, from INFO on, in the same form."""
    form = structlog.stdlib.ProcessorFormatter(
        processors=[structlog.stdlib.ProcessorFormatter.remove_processors_meta, structlog.processors.JSONRenderer()],
        foreign_pre_chain=_FORM,
    )
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(form)
    logging.basicConfig(level=logging.INFO, handlers=[handler])


def unavailable(what: str, error: BaseException) -> None:
    """Say that something is away, once a second at most, however many find out and however often."""
    now = time.monotonic()
    if now - _said_at.get(what, -SPARINGLY_S) >= SPARINGLY_S:
        _said_at[what] = now
        reason = getattr(error, "orig", None) or error  # without the statement and all that it was to write
        words, *_ = str(reason).split("\n\n")  # without the store's internals
        structlog.get_logger().warning(f"{what} unavailable", error=f"{type(reason).__name__}: {words}")
