"""TrackSweep from Python.

:class:`Service` does what most scripts need. Every operation of the service, typed, for use with and without ``async``,
is in ``tracksweep_client.generated.api``; :func:`connect` makes the client that its functions take.
"""

from .connection import ProblemError, connect
from .events import Event
from .service import Service

__all__ = ["Event", "ProblemError", "Service", "connect"]
