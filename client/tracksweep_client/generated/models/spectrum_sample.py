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

from ..models.spectrum_sample_spectrum_type_0 import (
    SpectrumSampleSpectrumType0,
    check_spectrum_sample_spectrum_type_0,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.band import Band
    from ..models.power_law_spectrum import PowerLawSpectrum
    from ..models.rational_spectrum import RationalSpectrum
    from ..models.table_spectrum import TableSpectrum


T = TypeVar("T", bound="SpectrumSample")


@_attrs_define
class SpectrumSample:
    """One realisation of a spectrum.

    Attributes:
        kind (Literal['spectrum']):
        wavelength_band_m (Band): A band of wavelengths, m.
        spectrum (PowerLawSpectrum | RationalSpectrum | SpectrumSampleSpectrumType0 | TableSpectrum | Unset):  Default:
            'tb3352-ballastless'.
        percentile (float | Unset): Percentile of the spectrum, %. Default: 63.2.
        seed (int | Unset): Seed of the random phases. Default: 1.
        realisation (int | Unset): Number of the realisation, from 0. Default: 0.
    """

    kind: Literal["spectrum"]
    wavelength_band_m: Band
    spectrum: PowerLawSpectrum | RationalSpectrum | SpectrumSampleSpectrumType0 | TableSpectrum | Unset = (
        "tb3352-ballastless"
    )
    percentile: float | Unset = 63.2
    seed: int | Unset = 1
    realisation: int | Unset = 0

    def to_dict(self) -> dict[str, Any]:
        from ..models.power_law_spectrum import PowerLawSpectrum  # noqa: PLC0415
        from ..models.rational_spectrum import RationalSpectrum  # noqa: PLC0415

        kind = self.kind

        wavelength_band_m = self.wavelength_band_m.to_dict()

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

        percentile = self.percentile

        seed = self.seed

        realisation = self.realisation

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
        if seed is not UNSET:
            field_dict["seed"] = seed
        if realisation is not UNSET:
            field_dict["realisation"] = realisation

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

        wavelength_band_m = Band.from_dict(d.pop("wavelength_band_m"))

        def _parse_spectrum(
            data: object,
        ) -> PowerLawSpectrum | RationalSpectrum | SpectrumSampleSpectrumType0 | TableSpectrum | Unset:
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                spectrum_type_0 = check_spectrum_sample_spectrum_type_0(data)

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

        percentile = d.pop("percentile", UNSET)

        seed = d.pop("seed", UNSET)

        realisation = d.pop("realisation", UNSET)

        spectrum_sample = cls(
            kind=kind,
            wavelength_band_m=wavelength_band_m,
            spectrum=spectrum,
            percentile=percentile,
            seed=seed,
            realisation=realisation,
        )

        return spectrum_sample
