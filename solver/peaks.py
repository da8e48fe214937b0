"""Peaks and statistics of a response."""

from dataclasses import dataclass

from solver.simulate import Response


@dataclass(frozen=True, kw_only=True)
class Peak:
    """One quantity at one position over the steady window.

    ``peak`` is the value of largest magnitude, as a magnitude (for wheel-rail forces the maximum); ``time`` (s since the window began) and
    ``track_position`` (m) say when and where it occurs.
    """

    quantity: str
    position: str
    unit: str
    peak: float
    maximum: float
    minimum: float
    mean: float
    std: float
    rms: float
    time: float
    track_position: float


def peaks(response: Response) -> list[Peak]:
    """All peaks of a response, in a fixed order."""
    raise NotImplementedError
