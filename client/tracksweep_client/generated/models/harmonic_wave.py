from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

T = TypeVar("T", bound="HarmonicWave")


@_attrs_define
class HarmonicWave:
    """A sine wave.

    Attributes:
        kind (Literal['harmonic']):
        wavelength_m (float): Wavelength, m.
        amplitude_mm (float): Amplitude, mm.
    """

    kind: Literal["harmonic"]
    wavelength_m: float
    amplitude_mm: float

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        wavelength_m = self.wavelength_m

        amplitude_mm = self.amplitude_mm

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "wavelength_m": wavelength_m,
                "amplitude_mm": amplitude_mm,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["harmonic"], d.pop("kind"))
        if kind != "harmonic":
            raise ValueError(f"kind must match const 'harmonic', got '{kind}'")

        wavelength_m = d.pop("wavelength_m")

        amplitude_mm = d.pop("amplitude_mm")

        harmonic_wave = cls(
            kind=kind,
            wavelength_m=wavelength_m,
            amplitude_mm=amplitude_mm,
        )

        return harmonic_wave
