"""One case as people write it: units in the names, km/h and mm, named tracks and vehicles."""

from collections.abc import Collection
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import Field

from app.boundary import Overrides, Strict, apply, at_boundary, bounded, overrides
from app.cases import irregularities
from app.cases.irregularities import (
    HarmonicWave,
    MeasuredProfile,
    SingleDip,
    SmoothRail,
    SpectrumSample,
    SumWithMeasured,
    no_profiles,
)
from solver.case import Case, Irregularity, Numerics, Slab, Track, Vehicle
from solver.catalogue import TRACKS, VEHICLES

# The conversion is part of a case's digest: another expression for the same number can round differently.
KMH_PER_M_PER_S = 3.6

Speed = Annotated[float, bounded(Case, "speed", KMH_PER_M_PER_S, "km/h")]

if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know

    class TrackOverrides(Overrides):
        base: str = ""

    class VehicleOverrides(Overrides):
        base: str = ""

    NumericsOverrides: TypeAlias = Overrides
else:
    TrackOverrides = overrides("TrackOverrides", Track, base=(Literal[tuple(TRACKS)], next(iter(TRACKS))))
    VehicleOverrides = overrides("VehicleOverrides", Vehicle, base=(Literal[tuple(VEHICLES)], next(iter(VEHICLES))))
    NumericsOverrides = overrides("NumericsOverrides", Numerics)


class Model(Strict):
    """What train runs on what track, and how finely that is computed."""

    track: TrackOverrides = Field(default_factory=TrackOverrides)
    vehicle: VehicleOverrides = Field(default_factory=VehicleOverrides)
    numerics: NumericsOverrides = Field(default_factory=NumericsOverrides)

    def parts(self) -> dict[str, Any]:
        """Track, vehicle and numerics as the solver takes them.

        Raises
        ------
        InvalidParameterError
            If they contradict each other or themselves.
        """
        return {
            "track": _replaced(TRACKS[self.track.base].values, self.track),
            "vehicle": _replaced(VEHICLES[self.vehicle.base].values, self.vehicle),
            "numerics": _replaced(Numerics(), self.numerics),
        }


def _replaced(values: Any, changes: Overrides) -> Any:
    return apply(values, changes.inside())


class CaseFile(Model):
    """One case with single values."""

    speed_kmh: Speed
    slab: Slab = "continuous"
    irregularity: Annotated[
        SmoothRail | HarmonicWave | SpectrumSample | SingleDip | MeasuredProfile | SumWithMeasured,
        Field(discriminator="kind"),
    ]

    def to_case(self) -> Case:
        """The case as the solver takes it.

        Raises
        ------
        InvalidParameterError
            If fields that are valid by themselves are not together.
        """
        return make_case(self.speed_kmh, self.slab, self.irregularity.irregularity(no_profiles), self.parts())


def make_case(speed_kmh: float, slab: Slab, irregularity: Irregularity, parts: dict[str, Any]) -> Case:
    """A case of values at the boundary and parts that many cases may share."""
    return Case(speed=speed_kmh / KMH_PER_M_PER_S, slab=slab, irregularity=irregularity, **parts)


def conditions(inputs: dict[str, Any]) -> dict[str, Any]:
    """What distinguishes a case, of its ``Case.to_dict()``, flat and in units at the boundary: the columns by which
    cases and peaks are filtered. Of a spectrum that is not in the catalogue, its kind.
    """
    irregularity = irregularities.at_boundary(inputs["irregularity"])
    spectrum, band = irregularity.get("spectrum"), irregularity.get("wavelength_band_m", {})
    return {
        # Rounding takes back what the conversion did to the last digit.
        "speed_kmh": round(inputs["speed"] * KMH_PER_M_PER_S, 9),
        "slab": inputs["slab"],
        "irregularity": irregularity["kind"],
        "spectrum": spectrum["kind"] if isinstance(spectrum, dict) else spectrum,
        "percentile": irregularity.get("percentile"),
        "wavelength_min_m": band.get("min"),
        "wavelength_max_m": band.get("max"),
        "seed": irregularity.get("seed"),
        "realisation": irregularity.get("realisation"),
        "wavelength_m": irregularity.get("wavelength_m"),
        "amplitude_mm": irregularity.get("amplitude_mm"),
    }


PARTS = {"track": Track, "vehicle": Vehicle, "numerics": Numerics}


def case_file(inputs: dict[str, Any], parts: Collection[str] = tuple(PARTS)) -> dict[str, Any]:
    """The :class:`CaseFile` of a ``Case.to_dict()``, with every value of these parts of the model spelled out."""
    return {
        "speed_kmh": conditions(inputs)["speed_kmh"],
        "slab": inputs["slab"],
        "irregularity": irregularities.at_boundary(inputs["irregularity"]),
        **{name: at_boundary(PARTS[name], inputs[name]) for name in parts},
    }
