"""One case as people write it: units in the names, km/h and mm, named tracks and vehicles."""

from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeAlias

from pydantic import Field

from app.boundary import Overrides, Strict, apply, at_boundary, bounded, overrides
from solver.case import Case, Harmonic, Irregularity, Numerics, Slab, Smooth, Spectral, Track, Vehicle
from solver.catalogue import SPECTRA, TRACKS, VEHICLES

# The conversions below are part of a case's digest: another expression for the same number can round differently.
KMH_PER_M_PER_S = 3.6
M_PER_MM = 1e-3

Speed = Annotated[float, bounded(Case, "speed", KMH_PER_M_PER_S, "km/h")]
Percentile = Annotated[float, bounded(Spectral, "percentile")]
Wavelength = Annotated[float, bounded(Harmonic, "wavelength")]
AmplitudeMm = Annotated[float, bounded(Harmonic, "amplitude", 1 / M_PER_MM, "mm")]
Seed = Annotated[int, bounded(Spectral, "seed")]

if TYPE_CHECKING:  # what is made at run time, as far as a type checker needs to know
    SpectrumName: TypeAlias = str

    class TrackOverrides(Overrides):
        base: str = ""

    class VehicleOverrides(Overrides):
        base: str = ""

    NumericsOverrides: TypeAlias = Overrides
else:
    SpectrumName = Literal[tuple(SPECTRA)]
    TrackOverrides = overrides("TrackOverrides", Track, base=(Literal[tuple(TRACKS)], next(iter(TRACKS))))
    VehicleOverrides = overrides("VehicleOverrides", Vehicle, base=(Literal[tuple(VEHICLES)], next(iter(VEHICLES))))
    NumericsOverrides = overrides("NumericsOverrides", Numerics)


class Band(Strict):
    """A band of wavelengths, m."""

    min: Annotated[float, bounded(Spectral, "wavelength_min")]
    max: Annotated[float, bounded(Spectral, "wavelength_max")]


class SmoothRail(Strict):
    """A perfectly even rail head."""

    kind: Literal["none"]

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Smooth()


class HarmonicWave(Strict):
    """A sine wave."""

    kind: Literal["harmonic"]
    wavelength_m: Wavelength
    amplitude_mm: AmplitudeMm

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Harmonic(wavelength=self.wavelength_m, amplitude=self.amplitude_mm * M_PER_MM)


class SpectrumSample(Strict):
    """One realisation of a spectrum."""

    kind: Literal["spectrum"]
    spectrum: SpectrumName = next(iter(SPECTRA))
    percentile: Percentile = 63.2
    wavelength_band_m: Band
    seed: Seed = 1
    realisation: Annotated[int, bounded(Spectral, "realisation")] = 0

    def irregularity(self) -> Irregularity:
        """As the solver takes it."""
        return Spectral(
            spectrum=self.spectrum,
            percentile=self.percentile,
            wavelength_min=self.wavelength_band_m.min,
            wavelength_max=self.wavelength_band_m.max,
            seed=self.seed,
            realisation=self.realisation,
        )


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
    irregularity: Annotated[SmoothRail | HarmonicWave | SpectrumSample, Field(discriminator="kind")]

    def to_case(self) -> Case:
        """The case as the solver takes it.

        Raises
        ------
        InvalidParameterError
            If fields that are valid by themselves are not together.
        """
        return make_case(self.speed_kmh, self.slab, self.irregularity.irregularity(), self.parts())


def make_case(speed_kmh: float, slab: Slab, irregularity: Irregularity, parts: dict[str, Any]) -> Case:
    """A case of values at the boundary and parts that many cases may share."""
    return Case(speed=speed_kmh / KMH_PER_M_PER_S, slab=slab, irregularity=irregularity, **parts)


def conditions(inputs: dict[str, Any]) -> dict[str, Any]:
    """What distinguishes a case, of its ``Case.to_dict()``, flat and in units at the boundary: the columns by which
    cases and peaks are filtered. Rounding takes back what the conversions above did to the last digit.
    """
    irregularity = dict(inputs["irregularity"])
    amplitude, wavelength = irregularity.pop("amplitude", None), irregularity.pop("wavelength", None)
    return {
        "speed_kmh": round(inputs["speed"] * KMH_PER_M_PER_S, 9),
        "slab": inputs["slab"],
        "irregularity": irregularity["kind"],
        "spectrum": irregularity.get("spectrum"),
        "percentile": irregularity.get("percentile"),
        "wavelength_min_m": irregularity.get("wavelength_min"),
        "wavelength_max_m": irregularity.get("wavelength_max"),
        "seed": irregularity.get("seed"),
        "realisation": irregularity.get("realisation"),
        "wavelength_m": wavelength,
        "amplitude_mm": None if amplitude is None else round(amplitude / M_PER_MM, 9),
    }


def case_file(inputs: dict[str, Any]) -> dict[str, Any]:
    """The :class:`CaseFile` of a ``Case.to_dict()``, with every value of track, vehicle and numerics spelled out."""
    flat = {name: value for name, value in conditions(inputs).items() if value is not None}
    speed, slab, kind = (flat.pop(name) for name in ("speed_kmh", "slab", "irregularity"))
    if kind == "spectrum":
        flat["wavelength_band_m"] = {"min": flat.pop("wavelength_min_m"), "max": flat.pop("wavelength_max_m")}
    parts = {"track": Track, "vehicle": Vehicle, "numerics": Numerics}
    return {"speed_kmh": speed, "slab": slab, "irregularity": {"kind": kind, **flat}} | {
        name: at_boundary(cls, inputs[name]) for name, cls in parts.items()
    }
