"""An example of every operation, for the OpenAPI document. Identifiers in paths are examples of their form only."""

from typing import Any

STUDY: dict[str, Any] = {
    "name": "Speed sweep",
    "labels": {"line": "test"},
    "sweep": {
        "kind": "product",
        "speed_kmh": {"kind": "range", "start": 200, "stop": 300, "step": 50},
        "slab": ["continuous", "discontinuous"],
        "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]},
        "vary": {"track.pad_stiffness_n_per_m": [4e7]},
    },
    "track": {"base": "crts2"},
    "vehicle": {"base": "crh3", "wheel_tread": "worn"},
    "numerics": {"track_length_m": 100, "elements_per_pad": 6, "settle_s": 0.5, "window_s": 0.5},
    "keep_history": True,
}
PROFILE = "x_m,eta_mm\n" + "".join(f"{0.25 * n:g},{0.1 * (n % 8 - 4):g}\n" for n in range(32))

PATHS: dict[str, Any] = {
    "study_id": "3f2a9c0d5b7e4816a1c2d3e4f5061728",
    "case_id": 1,
    "key_name": "laboratory",
    "profile_id": "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
}
BODIES: dict[str, Any] = {
    "create_study": STUDY,
    "estimate_study": {"name": "The article's speeds", "sweep": "speed-sweep"},
    "update_study": {"name": "Speed sweep, stiffer pads", "labels": {"line": None}, "priority": 1},
    "create_profile": PROFILE,
    "preview_irregularity": {
        "irregularity": {
            "kind": "spectrum",
            "spectrum": "tb3352-ballastless",
            "percentile": 63.2,
            "wavelength_band_m": {"min": 2, "max": 30},
        },
        "length_m": 600,
    },
}
_PEAKS = {
    "study_id": PATHS["study_id"],
    "quantity": "wheel_rail_force",
    "position": "wheelset_1",
    "slab": "continuous",
    "speed_kmh_min": 200,
    "speed_kmh_max": 300,
    "sort": "-peak",
}
PARAMETERS: dict[str, dict[str, Any]] = {
    "create_study": {"Idempotency-Key": "speed sweep of 5 May"},
    "list_studies": {
        "state": "succeeded",
        "created_after": "2026-01-01T00:00:00Z",
        "name": "sweep",
        "sort": "-priority",
    },
    "update_study": {"If-Match": "*"},
    "watch_study": {"Last-Event-ID": 0},
    "list_cases": {"state": "succeeded", "sort": "-speed_kmh", "page_size": 50},
    "download_history": {"through": "service"},
    "get_history": {"quantity": ["wheel_rail_force"], "time_min_s": 0.1, "time_max_s": 0.2, "max_points": 500},
    "get_spectrum": {
        "quantity": "wheel_rail_force",
        "position": "wheelset_1",
        "resolution_hz": 2,
        "frequency_max_hz": 500,
    },
    "list_peaks": _PEAKS | {"page_size": 50, "parameter": ["track.pad_stiffness_n_per_m"]},
    "export_peaks_csv": _PEAKS,
    "export_peaks_parquet": _PEAKS,
    "compare_study": {"axis": "slab", "quantity": "wheel_rail_force", "baseline": "continuous"},
    "summarise_study": {"quantity": "wheel_rail_force", "position": "wheelset_1", "statistic": "maximum"},
    "list_profiles": {"sort": "-created_at", "page_size": 10},
}
