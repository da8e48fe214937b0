"""An irregularity over some length, sampled by the solver itself, which the service loads with the first preview."""

import math
import threading
from functools import partial

from app.access.caller import Caller
from app.context import Context
from app.previews.schemas import (
    MAX_SAMPLES,
    SAMPLES_PER_WAVE,
    HeightDensity,
    Heights,
    IrregularityPreview,
    PreviewRequest,
)
from app.problems import invalid
from app.profiles import repository as profiles
from app.studies.sweep import ContradictionError, located
from solver.case import Irregularity, Spectral
from solver.catalogue import SPECTRA

HIGHEST_M = 1e3  # what is higher, or no number, cannot be drawn
APART = "The values are too many orders of magnitude apart to reckon with."
SEGMENTS = 8  # as long as the profile; with those between them, the density is the mean of 15
DRAWN = 200  # frequencies of the spectrum, in equal ratios

_ALONE = threading.Lock()  # the widest bands take some 100 MB, and seconds where ten of them are added


def preview(context: Context, request: PreviewRequest, caller: Caller) -> IrregularityPreview:
    """Heights and density of an irregularity.

    Raises
    ------
    Problem
        422 if its values contradict each other, it is too long for its shortest waves, or higher than any rail.
    """
    try:
        with context.database.read() as session, located(""):
            irregularity = request.irregularity.irregularity(partial(profiles.samples, session, caller=caller))
    except ContradictionError as error:
        raise invalid(error.pointer, "contradiction", error.detail) from None
    return _sampled(irregularity, request)


def _sampled(irregularity: Irregularity, request: PreviewRequest) -> IrregularityPreview:
    import numpy as np  # noqa: PLC0415

    from app.histories.sampling import peaks_of_bins  # noqa: PLC0415
    from app.welch import welch  # noqa: PLC0415
    from solver.irregularity import sample  # noqa: PLC0415

    count = _count(irregularity.shortest_wavelength, request.length_m)
    spacing = request.length_m / (count - 1)
    try:
        with _ALONE, np.errstate(all="ignore"):
            heights = sample(irregularity, request.start_m, spacing, count)
            drawn_from = _drawn_from(irregularity) if isinstance(irregularity, Spectral) else None
    except ArithmeticError:
        raise invalid("/irregularity", "contradiction", APART) from None
    if not (np.abs(heights) < HIGHEST_M).all():
        detail = f"The irregularity has heights of {HIGHEST_M:g} m or more; mind the units of its spectrum."
        raise invalid("/irregularity", "too-high", detail)
    if drawn_from is not None and not np.isfinite(drawn_from.densities_m3).all():
        raise invalid("/irregularity", "contradiction", APART)
    shown = peaks_of_bins(heights, request.max_points)
    frequencies, density = welch(heights, 1 / spacing, count // SEGMENTS)
    return IrregularityPreview(
        spacing_m=spacing,
        samples=count,
        lowest_mm=heights.min() * 1e3,
        highest_mm=heights.max() * 1e3,
        rms_mm=float(np.sqrt(np.mean(heights**2))) * 1e3,
        profile=Heights(
            positions_m=(request.start_m + spacing * shown).tolist(), heights_mm=(heights[shown] * 1e3).tolist()
        ),
        density=HeightDensity(frequencies_per_m=frequencies[1:].tolist(), densities_m3=density[1:].tolist()),
        drawn_from=drawn_from,
    )


def _count(shortest_m: float, length_m: float) -> int:
    """How many samples to take of a length, ends included."""
    most, least = SAMPLES_PER_WAVE
    if length_m * least > (MAX_SAMPLES - 1) * shortest_m:
        longest = (MAX_SAMPLES - 1) * shortest_m / least
        detail = f"Waves of {shortest_m:g} m can be shown over {longest:.6g} m at most, not over {length_m:g} m."
        raise invalid("/length_m", "too-long-for-waves", detail)
    return min(MAX_SAMPLES, max(1024, math.ceil(length_m * most / shortest_m) + 1))


def _drawn_from(irregularity: Spectral) -> HeightDensity:
    import numpy as np  # noqa: PLC0415

    from solver.density import density  # noqa: PLC0415
    from solver.irregularity import percentile_factor  # noqa: PLC0415

    spectrum = irregularity.spectrum
    known = SPECTRA[spectrum].values if isinstance(spectrum, str) else spectrum
    frequencies = np.geomspace(1 / irregularity.wavelength_max, 1 / irregularity.wavelength_min, DRAWN)
    densities = percentile_factor(irregularity.percentile) * density(known, frequencies)
    return HeightDensity(frequencies_per_m=frequencies.tolist(), densities_m3=densities.tolist())
