from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

T = TypeVar("T", bound="HarmonicSweep")


@_attrs_define
class HarmonicSweep:
    """Sine waves of several wavelengths and amplitudes.

    Attributes:
        kind (Literal['harmonic']):
        wavelength_m (list[float]):
        amplitude_mm (list[float]):
    """

    kind: Literal["harmonic"]
    wavelength_m: list[float]
    amplitude_mm: list[float]

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

        wavelength_m = cast(list[float], d.pop("wavelength_m"))

        amplitude_mm = cast(list[float], d.pop("amplitude_mm"))

        harmonic_sweep = cls(
            kind=kind,
            wavelength_m=wavelength_m,
            amplitude_mm=amplitude_mm,
        )

        return harmonic_sweep
