"""What the article prints, and where: the only place that holds its numbers."""

from dataclasses import dataclass

SPEEDS_KMH = (160.0, 200.0, 250.0, 300.0, 350.0)
PERCENTILES = (25.0, 63.2, 90.0)
BANDS_M = (2.0, 2.5, 3.0, 3.5, 4.0)  # shortest wavelengths; the longest is 30 m
LONGEST_M = 30.0
TABLE_1_BAND_M = 2.0  # not stated for Table 1: read as the widest of Table 2

# Rail displacement, mm, and wheel-rail force, kN: one realisation each.
TABLE_1 = {25.0: (1.378, 95.264), 63.2: (1.427, 108.647), 90.0: (1.550, 129.546)}
TABLE_2 = {
    2.0: (1.581, 121.050),
    2.5: (1.432, 110.601),
    3.0: (1.377, 104.347),
    3.5: (1.350, 97.472),
    4.0: (1.338, 92.955),
}
SECTION_4 = {"rail_acceleration": 132.0, "slab_acceleration": 43.0, "base_acceleration": 3.0, "wheel_rail_force": 12.0}

# Section 5 in words: by how many percent rail displacement and force grow or fall.
GROWTH_25_TO_90 = {"rail_displacement": (12.5,), "wheel_rail_force": (36.0,)}
FALL_ALONG_BANDS = {"rail_displacement": (9.4, 3.9, 1.9, 0.8), "wheel_rail_force": (8.6, 5.7, 6.5, 4.6)}
MEAN_DISPLACEMENT_MM, MEAN_FORCE_KN = 1.2, 70.0


@dataclass(frozen=True, kw_only=True)
class Target:
    """A number of the article that ours is put beside.

    Attributes
    ----------
    where : str
        Place in the article.
    quantity : str
        As the service names it.
    value : float
        In the unit in which it is shown: mm, m/s² or kN.
    percentile, shortest_m : float, optional
        Of the random irregularity; none where it is the difference that joints make, averaged over the speeds.
    """

    where: str
    quantity: str
    value: float
    percentile: float | None = None
    shortest_m: float | None = None

    @property
    def short(self) -> str:
        """What distinguishes it from others of its table."""
        if self.percentile is None:
            return "joints"
        return f"{self.percentile:g} %" if self.where == "Table 1" else f"{self.shortest_m:g}–{LONGEST_M:g} m"

    @property
    def condition(self) -> str:
        """Of what it is, in short."""
        if self.percentile is None:
            return "joints less none"
        return f"{self.percentile:g} %, {self.shortest_m:g}–{LONGEST_M:g} m"


_PAIR = ("rail_displacement", "wheel_rail_force")
JOINT_TARGETS = tuple(Target(where="Section 4", quantity=name, value=value) for name, value in SECTION_4.items())
TABLE_1_TARGETS = tuple(
    Target(where="Table 1", quantity=_PAIR[n], value=values[n], percentile=percentile, shortest_m=TABLE_1_BAND_M)
    for n in (0, 1)
    for percentile, values in TABLE_1.items()
)
TABLE_2_TARGETS = tuple(
    Target(where="Table 2", quantity=_PAIR[n], value=values[n], percentile=63.2, shortest_m=shortest)
    for n in (0, 1)
    for shortest, values in TABLE_2.items()
)
TARGETS = JOINT_TARGETS + TABLE_1_TARGETS + TABLE_2_TARGETS
