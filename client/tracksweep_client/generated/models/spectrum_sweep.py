from __future__ import annotations

from collections.abc import Mapping
from typing import (
    TYPE_CHECKING,
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

from ..models.spectrum_sweep_spectrum_type_0 import (
    SpectrumSweepSpectrumType0,
    check_spectrum_sweep_spectrum_type_0,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.band import Band
    from ..models.power_law_spectrum import PowerLawSpectrum
    from ..models.rational_spectrum import RationalSpectrum
    from ..models.table_spectrum import TableSpectrum


T = TypeVar("T", bound="SpectrumSweep")


@_attrs_define
class SpectrumSweep:
    """Realisations of a spectrum in several percentiles and bands, each with the same random phases.

    Attributes:
        kind (Literal['spectrum']):
        wavelength_band_m (list[Band]):
        spectrum (PowerLawSpectrum | RationalSpectrum | SpectrumSweepSpectrumType0 | TableSpectrum | Unset):  Default:
            'tb3352-ballastless'.
        percentile (list[float] | Unset):
        realisations (int | Unset): Number of realisations of each. Default: 1.
        seed (int | Unset): Seed of the random phases. Default: 1.
    """

    kind: Literal["spectrum"]
    wavelength_band_m: list[Band]
    spectrum: PowerLawSpectrum | RationalSpectrum | SpectrumSweepSpectrumType0 | TableSpectrum | Unset = (
        "tb3352-ballastless"
    )
    percentile: list[float] | Unset = UNSET
    realisations: int | Unset = 1
    seed: int | Unset = 1

    def to_dict(self) -> dict[str, Any]:
        from ..models.power_law_spectrum import PowerLawSpectrum  # noqa: PLC0415
        from ..models.rational_spectrum import RationalSpectrum  # noqa: PLC0415

        kind = self.kind

        wavelength_band_m = []
        for wavelength_band_m_item_data in self.wavelength_band_m:
            wavelength_band_m_item = wavelength_band_m_item_data.to_dict()
            wavelength_band_m.append(wavelength_band_m_item)

        spectrum: dict[str, Any] | str | Unset
        if isinstance(self.spectrum, Unset):
            spectrum = UNSET
        elif isinstance(self.spectrum, str):
            spectrum = self.spectrum
        elif isinstance(self.spectrum, PowerLawSpectrum):
            spectrum = self.spectrum.to_dict()
        elif isinstance(self.spectrum, RationalSpectrum):
            spectrum = self.spectrum.to_dict()
        else:
            spectrum = self.spectrum.to_dict()

        percentile: list[float] | Unset = UNSET
        if not isinstance(self.percentile, Unset):
            percentile = self.percentile

        realisations = self.realisations

        seed = self.seed

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "wavelength_band_m": wavelength_band_m,
            }
        )
        if spectrum is not UNSET:
            field_dict["spectrum"] = spectrum
        if percentile is not UNSET:
            field_dict["percentile"] = percentile
        if realisations is not UNSET:
            field_dict["realisations"] = realisations
        if seed is not UNSET:
            field_dict["seed"] = seed

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.band import Band  # noqa: PLC0415
        from ..models.power_law_spectrum import PowerLawSpectrum  # noqa: PLC0415
        from ..models.rational_spectrum import RationalSpectrum  # noqa: PLC0415
        from ..models.table_spectrum import TableSpectrum  # noqa: PLC0415

        d = dict(src_dict)
        kind = cast(Literal["spectrum"], d.pop("kind"))
        if kind != "spectrum":
            raise ValueError(f"kind must match const 'spectrum', got '{kind}'")

        wavelength_band_m = []
        _wavelength_band_m = d.pop("wavelength_band_m")
        for wavelength_band_m_item_data in _wavelength_band_m:
            wavelength_band_m_item = Band.from_dict(wavelength_band_m_item_data)

            wavelength_band_m.append(wavelength_band_m_item)

        def _parse_spectrum(
            data: object,
        ) -> PowerLawSpectrum | RationalSpectrum | SpectrumSweepSpectrumType0 | TableSpectrum | Unset:
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                spectrum_type_0 = check_spectrum_sweep_spectrum_type_0(data)

                return spectrum_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                spectrum_type_1 = PowerLawSpectrum.from_dict(data)

                return spectrum_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                spectrum_type_2 = RationalSpectrum.from_dict(data)

                return spectrum_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            spectrum_type_3 = TableSpectrum.from_dict(data)

            return spectrum_type_3

        spectrum = _parse_spectrum(d.pop("spectrum", UNSET))

        percentile = cast(list[float], d.pop("percentile", UNSET))

        realisations = d.pop("realisations", UNSET)

        seed = d.pop("seed", UNSET)

        spectrum_sweep = cls(
            kind=kind,
            wavelength_band_m=wavelength_band_m,
            spectrum=spectrum,
            percentile=percentile,
            realisations=realisations,
            seed=seed,
        )

        return spectrum_sweep
