"""Peaks, statistics and indices of a response."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from solver import indices
from solver.arrays import Array
from solver.channels import Channel
from solver.observables import OBSERVABLES
from solver.simulate import Response
from solver.wheel import static_wheel_load


@dataclass(frozen=True, kw_only=True)
class Peak:
    """One quantity at one position over the steady window.

    Attributes
    ----------
    quantity, position, unit : str
    peak : float
        Largest magnitude; for wheel-rail and pad forces, unloading and contact loss the maximum.
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
    histories = list(_histories(response))
    found = [_peak(response, channel, values) for channel, values in histories]
    return found + [
        _of_values(response, channel, values) for channel, values in _indices(histories, response.time_step)
    ]


def _histories(response: Response) -> Iterator[tuple[Channel, Array]]:
    """The recorded channels and the histories derived from them."""
    load, step = static_wheel_load(response.case.vehicle), response.time_step
    recorded = list(zip(response.channels, response.values, strict=True))
    yield from recorded
    for channel, values in recorded:
        if channel.quantity == "wheel_rail_force":
            yield _derived(channel, "wheel_rail_force_20hz"), indices.low_pass(values, step)
            yield _derived(channel, "wheel_unloading"), (load - values) / load
            yield _derived(channel, "contact_loss"), indices.contact_lost(values).astype(float)
        elif channel.quantity == "car_body_acceleration":
            yield _derived(channel, "car_body_acceleration_comfort"), indices.comfort_band(values, step)


def _indices(histories: list[tuple[Channel, Array]], step: float) -> Iterator[tuple[Channel, Array]]:
    """Values that sum up a history."""
    for channel, values in histories:
        if channel.quantity == "wheel_rail_force":
            yield _derived(channel, "wheel_rail_force_quantile"), _quantile(values)
            losses = indices.contact_losses(values, step)
            events = np.array([float(np.count_nonzero(losses))])
            yield _derived(channel, "contact_loss_events"), events
            yield _derived(channel, "contact_loss_duration"), losses
        elif channel.quantity == "wheel_rail_force_20hz":
            yield _derived(channel, "wheel_rail_force_20hz_quantile"), _quantile(values)
        elif channel.quantity == "car_body_acceleration":
            yield _derived(channel, "sperling_index"), indices.sperling(values, step)


def _derived(channel: Channel, quantity: str) -> Channel:
    """The channel of what is derived from another."""
    return replace(channel, quantity=quantity, unit=OBSERVABLES[quantity].unit)


def _quantile(values: Array) -> Array:
    return np.quantile(values, [indices.QUANTILE])


def _peak(response: Response, channel: Channel, values: Array) -> Peak:
    size = values if OBSERVABLES[channel.quantity].peak == "maximum" else np.abs(values)
    at = int(np.argmax(size))
    summary = _of_values(response, channel, values)
    time, position = float(response.time[at]), float(response.track_position[at])
    return replace(summary, peak=float(size[at]), time=time, track_position=position)


def _of_values(response: Response, channel: Channel, values: Array) -> Peak:
    """Statistics of values that belong to the window as a whole, which is where they are said to be."""
    return Peak(
        quantity=channel.quantity,
        position=channel.position,
        unit=channel.unit,
        peak=float(values.max()),
        maximum=float(values.max()),
        minimum=float(values.min()),
        mean=float(values.mean()),
        std=float(values.std()),
        rms=float(np.sqrt(np.mean(values**2))),
        time=float(response.time[0]),
        track_position=float(response.track_position[0]),
    )
