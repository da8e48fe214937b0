"""What a study varies by its path."""

from typing import Any

from app.studies.presets import PRESETS
from app.studies.sweep.vary import PARAMETERS


def varied_paths(request: dict[str, Any]) -> list[str]:
    """Paths that a study varies, as it was asked for, in the order of the model."""
    sweep = request["sweep"]
    if isinstance(sweep, str):
        sweep = PRESETS[sweep].study["sweep"] if sweep in PRESETS else {}
    given = [each.get("vary", {}) for each in sweep.get("cases", [sweep])]
    return [path for path in PARAMETERS if any(path in each for each in given)]
