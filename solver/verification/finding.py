"""What a check finds: numbers beside what they should be, and curves to look at."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from solver.arrays import Array


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """A number beside the one it should be.

    Attributes
    ----------
    what : str
    ours, expected : float
    tolerance : float
        Largest difference allowed, as part of ``scale``.
    unit : str
    scale : float, optional
        What the difference is a part of; the expected magnitude unless given.
    """

    what: str
    ours: float
    expected: float
    tolerance: float
    unit: str = ""
    scale: float | None = None

    @property
    def difference(self) -> float:
        """Ours minus expected, as part of the scale."""
        return (self.ours - self.expected) / (self.scale or abs(self.expected))

    @property
    def passed(self) -> bool:
        """Whether the tolerance is kept; not if anything is no number."""
        return abs(self.difference) <= self.tolerance

    def cells(self) -> tuple[str, str, str, str]:
        """Ours, expected, difference and tolerance in print."""
        return (
            f"{self.ours:.6g} {self.unit}".strip(),
            f"{self.expected:.6g} {self.unit}".strip(),
            f"{100 * self.difference:+.2g} %",
            f"{100 * self.tolerance:.3g} %",
        )


@dataclass(frozen=True, kw_only=True)
class Bound:
    """A number that must lie within bounds."""

    what: str
    ours: float
    low: float = -math.inf
    high: float = math.inf
    unit: str = ""

    @property
    def passed(self) -> bool:
        """Whether the bounds are kept."""
        return self.low <= self.ours <= self.high

    def cells(self) -> tuple[str, str, str, str]:
        """Ours, bounds, nothing, nothing, in print."""
        low = f"at least {self.low:.4g} " if self.low > -math.inf else ""
        high = f"at most {self.high:.4g}" if self.high < math.inf else ""
        return f"{self.ours:.4g} {self.unit}".strip(), f"{low}{high}".strip(), "", ""


Row: TypeAlias = Comparison | Bound


@dataclass(frozen=True, kw_only=True)
class Curve:
    """One line, or points, of a plot."""

    label: str
    x: Array | Sequence[float]
    y: Array | Sequence[float]
    style: str = "-"


@dataclass(frozen=True, kw_only=True)
class Plot:
    """A picture for the report."""

    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    logarithmic: bool = False


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What came of a check."""

    rows: list[Row]
    plots: list[Plot] = field(default_factory=list)
    remark: str = ""

    @property
    def passed(self) -> bool:
        """Whether every row passed, and there are any."""
        return bool(self.rows) and all(row.passed for row in self.rows)


@dataclass(frozen=True, kw_only=True)
class Check:
    """A check: what it is called, how it is done, and the function that does it."""

    title: str
    how: str
    run: Callable[[], Finding]
    quick: bool = False
