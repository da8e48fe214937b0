"""How peaks and indices of a response were derived, to be stored with them."""

from typing import Any

from solver import indices
from solver.observables import OBSERVABLES
from solver.simulate import Response

# What the signs and the quantities of the channels mean.
CONVENTIONS = {
    "direction": "displacements and accelerations are positive downwards",
    "track_accelerations": "of the material under the first wheelset; rail_acceleration_moving_frame of the point that "
    "moves with it",
    **{
        name: OBSERVABLES[name].convention
        for name in ("wheel_rail_force", "slab_moment", "pad_force", "roadbed_pressure")
    },
}


def processing(response: Response) -> dict[str, Any]:
    """Sampling, window, filters, indices and conventions of a response, as JSON has them, with units in the names."""
    samples, step = len(response.time), response.time_step
    length, windows = indices.sperling_windows(samples, step)
    force_edge, comfort_edges = indices.FORCE_CUTOFF_HZ, indices.COMFORT_BAND_HZ
    return {
        "sampling_step_s": step,
        "samples": samples,
        "window_s": samples * step,
        "settle_s": response.case.numerics.settle,  # rounded up to whole steps
        "ease_in_s": response.case.numerics.ease_in,
        "filters": {
            "wheel_rail_force_20hz": {"band": "low-pass", "cutoff_hz": force_edge}
            | _filtering(samples, step, force_edge),
            "car_body_acceleration_comfort": {"band": "band-pass", "cutoff_hz": list(comfort_edges)}
            | _filtering(samples, step, comfort_edges[0]),
        },
        "quantile": indices.QUANTILE,
        "sperling_index": {
            "window_s": length * step,
            "windows": windows,
            "band_hz": list(indices.SPERLING_BAND_HZ),
        },
        "contact_lost_at_or_below_n": indices.CONTACT_LOST_N,
        "conventions": dict(CONVENTIONS),
    }


def _filtering(samples: int, step: float, slowest: float) -> dict[str, Any]:
    return {
        "kind": "Butterworth",
        "order_of_one_pass_per_edge": indices.FILTER_ORDER,
        "passes": "forwards and backwards, zero phase",
        "edges": "mirrored",
        "mirrored_s": indices.mirrored(samples, step, slowest) * step,
    }
