"""Measured profiles as text: two columns, position and height."""

import math
import re

from solver.quantity import InvalidParameterError
from solver.railhead import FARTHEST, HIGHEST, MAX_POINTS, Samples

_UNITS = {"m": 1.0, "mm": 1e-3}
_UNIT = re.compile(r"(?<![^\W_])(m|mm|cm|µm|μm|um|km|in|ft)(?![^\W_])", re.IGNORECASE)
_SEPARATOR = re.compile(r"\s*[,;\t]\s*|\s+")


def read_profile(text: str) -> Samples:
    """Positions and heights, m, as :class:`solver.case.Measured` takes them.

    Parameters
    ----------
    text : str
        A line per point: position along the track and height, separated by comma, semicolon, tab or blanks. A first
        line of words may name the units m or mm, column by column (``x_m,eta_mm``); without, both are in m. Empty
        lines and lines that begin with ``#`` are skipped.

    Raises
    ------
    InvalidParameterError
        With the number of the first line that is wrong.
    """
    rows = [(n, line.strip()) for n, line in enumerate(text.removeprefix("\ufeff").splitlines(), 1)]
    rows = [(n, line) for n, line in rows if line and not line.startswith("#")]
    scale = (1.0, 1.0)
    if rows and not any(map(_is_number, _SEPARATOR.split(rows[0][1]))):
        scale = _units(*rows.pop(0))
    if len(rows) > MAX_POINTS:
        raise InvalidParameterError(f"line {rows[MAX_POINTS][0]}", f"is one too many: {MAX_POINTS} points at most")
    points: list[tuple[float, float]] = []
    for n, line in rows:
        x, height = (value * unit for value, unit in zip(_numbers(n, line), scale, strict=True))
        if points and x <= points[-1][0]:
            raise InvalidParameterError(f"line {n}", f"must lie beyond {points[-1][0]:g} m, is {x:g} m")
        if abs(x) > FARTHEST or abs(height) > HIGHEST:
            bounds = f"must lie within {FARTHEST:g} m along the track and {HIGHEST:g} m of height"
            raise InvalidParameterError(f"line {n}", f"{bounds}, is {x:g} m and {height:g} m; mind the units")
        points.append((x, height))
    return tuple(x for x, _ in points), tuple(height for _, height in points)


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return False
    return True


def _numbers(n: int, line: str) -> list[float]:
    cells = _SEPARATOR.split(line)
    if len(cells) != 2 or not all(map(_is_number, cells)):
        raise InvalidParameterError(f"line {n}", f"must be two numbers, is {line[:40]!r}")
    values = [float(cell) for cell in cells]
    if not all(map(math.isfinite, values)):
        raise InvalidParameterError(f"line {n}", f"must be two finite numbers, is {line[:40]!r}")
    return values


def _units(n: int, line: str) -> tuple[float, float]:
    """Metres per unit of both columns, from their names."""
    names = re.split(r"[,;\t]", line) if re.search(r"[,;\t]", line) else line.split()
    if len(names) != 2:
        raise InvalidParameterError(f"line {n}", f"must name two columns, is {line[:40]!r}")
    found = [(_UNIT.findall(name) or ["m"])[-1].lower() for name in names]
    for unit in found:
        if unit not in _UNITS:
            raise InvalidParameterError(f"line {n}", f"must name m or mm, not {unit}")
    return _UNITS[found[0]], _UNITS[found[1]]
