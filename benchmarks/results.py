"""What a benchmark finds: figures, a table and curves, kept as JSON beside the machine they were measured on."""

import json
import os
import platform
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

RESULTS = Path(__file__).parent / "results"


@dataclass(frozen=True, kw_only=True)
class Result:
    """One benchmark.

    Attributes
    ----------
    title, how : str
        What is measured, and how.
    command : str
        What prints it.
    values : dict of float
        Printed as ``name = value``.
    table : list of rows of cells
        The first row is its head.
    plots : list of dict
        As :class:`solver.verification.finding.Plot` takes them.
    """

    title: str
    how: str
    command: str
    values: dict[str, float]
    table: list[list[str]] = field(default_factory=list)
    plots: list[dict[str, Any]] = field(default_factory=list)


def publish(name: str, result: Result) -> None:
    """Print a result's figures and keep them as ``results/NAME.json``."""
    for row in result.table:
        print("  ".join(f"{cell:42s}" if i == 0 else f"{cell:>14s}" for i, cell in enumerate(row)))
    for key, value in result.values.items():
        print(f"{key} = {value:.4g}", flush=True)
    RESULTS.mkdir(exist_ok=True)
    kept = asdict(result) | {"machine": machine()}
    (RESULTS / f"{name}.json").write_text(json.dumps(kept, indent=1) + "\n")


def read(path: Path) -> tuple[Result, dict[str, str]]:
    """A kept result and the machine it was measured on."""
    kept = json.loads(path.read_text())
    described = kept.pop("machine")
    return Result(**kept), described


def machine() -> dict[str, str]:
    """What matters of this machine, without its name."""
    packages = {name: version(name) for name in ("numpy", "scipy", "numba")}
    software = ", ".join(f"{name} {number}" for name, number in packages.items())
    return {
        "processor": f"{_model()}, {_cores()} cores",
        "caches": ", ".join(_caches()) or "unknown",
        "software": f"Python {platform.python_version()}, {software}, {platform.system()}",
    }


def _model() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "unknown")


def _cores() -> int:
    return os.cpu_count() or 1


def _caches() -> list[str]:
    folders = sorted(Path("/sys/devices/system/cpu/cpu0/cache").glob("index*"))
    parts = [[(folder / name).read_text().strip() for name in ("level", "type", "size")] for folder in folders]
    return [f"L{level} {size}" for level, kind, size in parts if kind != "Instruction"]


def exponent(x: Sequence[float], y: Sequence[float]) -> float:
    """Exponent of the power law that fits best: least squares of the logarithms."""
    return float(np.polyfit(np.log(x), np.log(y), 1)[0])


def scatter(values: Sequence[float]) -> float:
    """Half the distance between the quartiles, as part of the median."""
    low, middle, high = np.quantile(values, [0.25, 0.5, 0.75])
    return float((high - low) / 2 / middle)
