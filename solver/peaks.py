"""Peaks and statistics of a response."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from solver.arrays import Array
from solver.channels import Channel
from solver.simulate import Response
from solver.vehicle import static_wheel_load

# Quantities whose peak is their maximum; of the others it is the largest magnitude.
_ONE_SIDED = frozenset({"wheel_rail_force", "wheel_unloading", "contact_loss"})


@dataclass(frozen=True, kw_only=True)
class Peak:
    """One quantity at one position over the steady window.

    Attributes
    ----------
    quantity, position, unit : str
    peak : float
        Largest magnitude; for wheel-rail force, unloading and contact loss the maximum.
    maximum, minimum, mean, std, rms : float
        Over the window. The mean of ``contact_loss`` is the share of time without contact.
    time : float
        When the peak occurs, s since the window began.
    track_position : float
        Where the first wheelset is then, m.
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
    return [_peak(response, channel, values) for channel, values in _histories(response)]


def _histories(response: Response) -> Iterator[tuple[Channel, Array]]:
    """The recorded channels and those derived from them."""
    recorded = list(zip(response.channels, response.values, strict=True))
    yield from recorded
    load = static_wheel_load(response.case.vehicle)
    for channel, force in recorded:
        if channel.quantity == "wheel_rail_force":
            yield Channel(quantity="wheel_unloading", position=channel.position, unit="1"), (load - force) / load
            yield Channel(quantity="contact_loss", position=channel.position, unit="1"), (force <= 0).astype(float)


def _peak(response: Response, channel: Channel, values: Array) -> Peak:
    size = values if channel.quantity in _ONE_SIDED else np.abs(values)
    at = int(np.argmax(size))
    return Peak(
        quantity=channel.quantity,
        position=channel.position,
        unit=channel.unit,
        peak=float(size[at]),
        maximum=float(values.max()),
        minimum=float(values.min()),
        mean=float(values.mean()),
        std=float(values.std()),
        rms=float(np.sqrt(np.mean(values**2))),
        time=float(response.time[at]),
        track_position=float(response.track_position[at]),
    )
