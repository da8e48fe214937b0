"""The spectrum of a channel of a stored history."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.histories.archive import Archive
from app.histories.schemas import SpectrumQuery, SpectrumView
from app.problems import Problem
from app.studies.resonance import p2_hz
from app.welch import welch
from solver.case import Joint, Track, Vehicle

FEWEST = 16  # samples of a segment


def spectrum(archive: Archive, inputs: dict[str, Any], query: SpectrumQuery) -> SpectrumView:
    """The density of one channel, and the frequencies that a case has of itself.

    Parameters
    ----------
    archive : Archive
    inputs : dict
        ``Case.to_dict()``.
    query : SpectrumQuery

    Raises
    ------
    Problem
        404 if the history has no such channel.
    """
    unit, values = _channel(archive, query)
    step_s = archive.processing["sampling_step_s"]
    segment = min(len(values), max(FEWEST, round(1 / (query.resolution_hz * step_s))))
    frequency, density = welch(values, 1 / step_s, segment)
    shown = slice(1, int(np.searchsorted(frequency, query.frequency_max_hz, "right")))
    joint = Joint(**inputs["track"]["joint"])
    track = Track(**inputs["track"] | {"joint": joint})
    return SpectrumView(
        quantity=query.quantity,
        position=query.position,
        unit=unit,
        density_unit=f"{unit}^2/Hz" if unit.isalnum() else f"({unit})^2/Hz",
        resolution_hz=1 / (segment * step_s),
        segments=1 + (len(values) - segment) // max(1, segment // 2),
        frequency_hz=frequency[shown].tolist(),
        density=density[shown].tolist(),
        pad_passing_hz=inputs["speed"] / track.pad_spacing,
        p2_hz=p2_hz(track, Vehicle(**inputs["vehicle"])),
    )


def _channel(archive: Archive, query: SpectrumQuery) -> tuple[str, NDArray[Any]]:
    for channel, row in zip(archive.channels, archive.rows(), strict=False):
        if (channel["quantity"], channel["position"]) == (query.quantity, query.position):
            return channel["unit"], row
    detail = f"The history has no {query.quantity} at {query.position}."
    raise Problem(404, detail, code="no-such-channel")
