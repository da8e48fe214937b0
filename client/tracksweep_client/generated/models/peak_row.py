from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.peak_row_parameters import PeakRowParameters


T = TypeVar("T", bound="PeakRow")


@_attrs_define
class PeakRow:
    """Peak and statistics of one quantity at one position over the steady window of one case, in ``unit``.

    Attributes:
        speed_kmh (float):
        slab (str):
        irregularity (str): Kind of irregularity.
        spectrum (None | str):
        percentile (float | None):
        wavelength_min_m (float | None):
        wavelength_max_m (float | None):
        seed (int | None):
        realisation (int | None):
        wavelength_m (float | None):
        amplitude_mm (float | None):
        case_id (int):
        solver_version (str):
        quantity (str):
        position (str):
        unit (str):
        peak (float): Largest magnitude; for wheel-rail and pad forces the maximum.
        maximum (float):
        minimum (float):
        mean (float):
        std (float):
        rms (float):
        time_s (float): When the peak occurs, s since the window began.
        track_position_m (float): Where the first wheelset is at that time, m.
        parameters (PeakRowParameters | Unset): Parameters of the case by their paths, which end in their units: those
            asked for or, if none is and a study is named, those that it varies. Null where a case is older than the
            parameter.
    """

    speed_kmh: float
    slab: str
    irregularity: str
    spectrum: None | str
    percentile: float | None
    wavelength_min_m: float | None
    wavelength_max_m: float | None
    seed: int | None
    realisation: int | None
    wavelength_m: float | None
    amplitude_mm: float | None
    case_id: int
    solver_version: str
    quantity: str
    position: str
    unit: str
    peak: float
    maximum: float
    minimum: float
    mean: float
    std: float
    rms: float
    time_s: float
    track_position_m: float
    parameters: PeakRowParameters | Unset = UNSET
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        speed_kmh = self.speed_kmh

        slab = self.slab

        irregularity = self.irregularity

        spectrum: None | str
        spectrum = self.spectrum

        percentile: float | None
        percentile = self.percentile

        wavelength_min_m: float | None
        wavelength_min_m = self.wavelength_min_m

        wavelength_max_m: float | None
        wavelength_max_m = self.wavelength_max_m

        seed: int | None
        seed = self.seed

        realisation: int | None
        realisation = self.realisation

        wavelength_m: float | None
        wavelength_m = self.wavelength_m

        amplitude_mm: float | None
        amplitude_mm = self.amplitude_mm

        case_id = self.case_id

        solver_version = self.solver_version

        quantity = self.quantity

        position = self.position

        unit = self.unit

        peak = self.peak

        maximum = self.maximum

        minimum = self.minimum

        mean = self.mean

        std = self.std

        rms = self.rms

        time_s = self.time_s

        track_position_m = self.track_position_m

        parameters: dict[str, Any] | Unset = UNSET
        if not isinstance(self.parameters, Unset):
            parameters = self.parameters.to_dict()

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "speed_kmh": speed_kmh,
                "slab": slab,
                "irregularity": irregularity,
                "spectrum": spectrum,
                "percentile": percentile,
                "wavelength_min_m": wavelength_min_m,
                "wavelength_max_m": wavelength_max_m,
                "seed": seed,
                "realisation": realisation,
                "wavelength_m": wavelength_m,
                "amplitude_mm": amplitude_mm,
                "case_id": case_id,
                "solver_version": solver_version,
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "peak": peak,
                "maximum": maximum,
                "minimum": minimum,
                "mean": mean,
                "std": std,
                "rms": rms,
                "time_s": time_s,
                "track_position_m": track_position_m,
            }
        )
        if parameters is not UNSET:
            field_dict["parameters"] = parameters

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.peak_row_parameters import PeakRowParameters  # noqa: PLC0415

        d = dict(src_dict)
        speed_kmh = d.pop("speed_kmh")

        slab = d.pop("slab")

        irregularity = d.pop("irregularity")

        def _parse_spectrum(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        spectrum = _parse_spectrum(d.pop("spectrum"))

        def _parse_percentile(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        percentile = _parse_percentile(d.pop("percentile"))

        def _parse_wavelength_min_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_min_m = _parse_wavelength_min_m(d.pop("wavelength_min_m"))

        def _parse_wavelength_max_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_max_m = _parse_wavelength_max_m(d.pop("wavelength_max_m"))

        def _parse_seed(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        seed = _parse_seed(d.pop("seed"))

        def _parse_realisation(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        realisation = _parse_realisation(d.pop("realisation"))

        def _parse_wavelength_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_m = _parse_wavelength_m(d.pop("wavelength_m"))

        def _parse_amplitude_mm(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        amplitude_mm = _parse_amplitude_mm(d.pop("amplitude_mm"))

        case_id = d.pop("case_id")

        solver_version = d.pop("solver_version")

        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        peak = d.pop("peak")

        maximum = d.pop("maximum")

        minimum = d.pop("minimum")

        mean = d.pop("mean")

        std = d.pop("std")

        rms = d.pop("rms")

        time_s = d.pop("time_s")

        track_position_m = d.pop("track_position_m")

        _parameters = d.pop("parameters", UNSET)
        parameters: PeakRowParameters | Unset
        if isinstance(_parameters, Unset):
            parameters = UNSET
        else:
            parameters = PeakRowParameters.from_dict(_parameters)

        peak_row = cls(
            speed_kmh=speed_kmh,
            slab=slab,
            irregularity=irregularity,
            spectrum=spectrum,
            percentile=percentile,
            wavelength_min_m=wavelength_min_m,
            wavelength_max_m=wavelength_max_m,
            seed=seed,
            realisation=realisation,
            wavelength_m=wavelength_m,
            amplitude_mm=amplitude_mm,
            case_id=case_id,
            solver_version=solver_version,
            quantity=quantity,
            position=position,
            unit=unit,
            peak=peak,
            maximum=maximum,
            minimum=minimum,
            mean=mean,
            std=std,
            rms=rms,
            time_s=time_s,
            track_position_m=track_position_m,
            parameters=parameters,
        )

        peak_row.additional_properties = d
        return peak_row

    @property
    def additional_keys(self) -> list[str]:
        return list(self.additional_properties.keys())

    def __getitem__(self, key: str) -> Any:
        return self.additional_properties[key]

    def __setitem__(self, key: str, value: Any) -> None:
        self.additional_properties[key] = value

    def __delitem__(self, key: str) -> None:
        del self.additional_properties[key]

    def __contains__(self, key: str) -> bool:
        return key in self.additional_properties
