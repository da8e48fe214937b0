"""What is kept of a run: enough to write the report anew, and to put another run beside it."""

import json
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from solver.arrays import Array

# Name of a column, and which number of which quantity it is.
PEAKS = {
    "wheel_rail_force": ("wheel_rail_force", "wheelset_1", "peak"),
    "rail_displacement": ("rail_displacement", "wheelset_1", "peak"),
    "rail_acceleration": ("rail_acceleration", "wheelset_1", "peak"),
    "rail_acceleration_moving_frame": ("rail_acceleration_moving_frame", "wheelset_1", "peak"),
    "slab_acceleration": ("slab_acceleration", "wheelset_1", "peak"),
    "base_acceleration": ("base_acceleration", "wheelset_1", "peak"),
    "car_body_acceleration": ("car_body_acceleration", "car_body", "peak"),
    "pad_force": ("pad_force", "pads", "peak"),
    "mean_force": ("wheel_rail_force", "wheelset_1", "mean"),
    "mean_displacement": ("rail_displacement", "wheelset_1", "mean"),
    "contact_loss": ("contact_loss", "wheelset_1", "mean"),
}
CONDITIONS = ("speed_kmh", "slab", "percentile", "wavelength_min_m", "realisation", "wavelength_m")
DIGITS = 9  # significant ones that are kept


class Cases:
    """Conditions and peaks of cases, a column each, in SI units.

    Parameters
    ----------
    columns : mapping of str to sequence
        All of one length.
    """

    def __init__(self, columns: Mapping[str, Sequence[Any] | Array]) -> None:
        self.columns = {name: np.asarray(values) for name, values in columns.items()}

    @classmethod
    def from_rows(cls, rows: Iterable[Mapping[str, str]]) -> "Cases":
        """The cases of a table of peaks as the service exports it, a row per quantity and position."""
        cases: dict[int, dict[str, Any]] = defaultdict(dict)
        wanted: dict[tuple[str, str], list[tuple[str, str]]] = {
            (quantity, position): [] for quantity, position, _ in PEAKS.values()
        }
        for name, (quantity, position, statistic) in PEAKS.items():
            wanted[quantity, position].append((name, statistic))
        for row in rows:
            case = cases[int(row["case_id"])]
            case |= {name: _value(text) for name, text in row.items() if name in CONDITIONS or "." in name}
            for name, statistic in wanted.get((row["quantity"], row["position"]), []):
                case[name] = float(f"{float(row[statistic]):.{DIGITS}g}")
        ordered = [{"case_id": case_id} | case for case_id, case in sorted(cases.items())]
        return cls({name: [case[name] for case in ordered] for name in ordered[0]} if ordered else {"case_id": []})

    def __len__(self) -> int:
        return len(self.columns["case_id"])

    def __getitem__(self, name: str) -> Array:
        return self.columns[name] if len(self) else np.empty(0)  # where all cases diverged, nothing tells of columns

    def where(self, **conditions: Any) -> "Cases":
        """Those that meet all conditions."""
        chosen = np.ones(len(self), bool)
        for name, value in conditions.items():
            chosen &= self[name] == value
        return Cases({name: values[chosen] for name, values in self.columns.items()})

    def to_json(self) -> dict[str, list[Any]]:
        """Columns that say anything."""
        return {name: values.tolist() for name, values in self.columns.items() if values.dtype != object}


def _value(text: str) -> Any:
    try:
        return float(text)
    except ValueError:
        return text or None


Curve = tuple[Sequence[float], Sequence[float]]


@dataclass(frozen=True, kw_only=True)
class Results:
    """A run.

    Attributes
    ----------
    made : dict
        By which command, on what, in how many seconds.
    cases : dict of Cases
        By the name of the study.
    profiles, histories : dict of pairs of sequences
        Samples of irregularities (m, mm) and of histories (s, SI), by what they are of.
    strip : list of dict
        What became of the experiment with strips, see :mod:`worker.article.strip`.
    """

    made: dict[str, Any]
    cases: dict[str, Cases]
    profiles: dict[str, Curve]
    histories: dict[str, Curve]
    strip: list[dict[str, Any]] = field(default_factory=list)

    def write(self, path: Path) -> None:
        """Keep it in a file, a line per study or curve."""
        content = vars(self) | {"cases": {name: cases.to_json() for name, cases in self.cases.items()}}
        lines = []
        for part, values in content.items():
            items = values.items() if isinstance(values, dict) else None
            if items is None:
                lines.append(f"{json.dumps(part)}: {json.dumps(values)}")
            else:
                inner = ",\n".join(f"{json.dumps(key)}: {json.dumps(value)}" for key, value in items)
                lines.append(f"{json.dumps(part)}: {{\n{inner}\n}}")
        path.write_text("{\n" + ",\n".join(lines) + "\n}\n")

    @classmethod
    def read(cls, path: Path) -> "Results":
        """What a file keeps."""
        content = json.loads(path.read_text())
        return cls(**content | {"cases": {name: Cases(columns) for name, columns in content["cases"].items()}})
