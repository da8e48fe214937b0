from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

from ..models.power_law_spectrum_per import (
    PowerLawSpectrumPer,
    check_power_law_spectrum_per,
)
from ..models.power_law_spectrum_sides import (
    PowerLawSpectrumSides,
    check_power_law_spectrum_sides,
)
from ..types import UNSET, Unset

T = TypeVar("T", bound="PowerLawSpectrum")


@_attrs_define
class PowerLawSpectrum:
    """``S = A / f^k``, piece by piece.

    Attributes:
        kind (Literal['power-law']):
        per (PowerLawSpectrumPer): Unit of its frequency: S is in m^2/(1/m), or in m^2/(rad/m) of 2 pi times that.
        sides (PowerLawSpectrumSides): Whether its integral over positive frequencies is the variance (1) or half of it.
        coefficients (list[float]): A of each piece.
        exponents (list[float]): k of each piece.
        breaks (list[float] | Unset): Frequencies between the pieces.
    """

    kind: Literal["power-law"]
    per: PowerLawSpectrumPer
    sides: PowerLawSpectrumSides
    coefficients: list[float]
    exponents: list[float]
    breaks: list[float] | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        per: str = self.per

        sides: int = self.sides

        coefficients = self.coefficients

        exponents = self.exponents

        breaks: list[float] | Unset = UNSET
        if not isinstance(self.breaks, Unset):
            breaks = self.breaks

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "per": per,
                "sides": sides,
                "coefficients": coefficients,
                "exponents": exponents,
            }
        )
        if breaks is not UNSET:
            field_dict["breaks"] = breaks

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["power-law"], d.pop("kind"))
        if kind != "power-law":
            raise ValueError(f"kind must match const 'power-law', got '{kind}'")

        per = check_power_law_spectrum_per(d.pop("per"))

        sides = check_power_law_spectrum_sides(d.pop("sides"))

        coefficients = cast(list[float], d.pop("coefficients"))

        exponents = cast(list[float], d.pop("exponents"))

        breaks = cast(list[float], d.pop("breaks", UNSET))

        power_law_spectrum = cls(
            kind=kind,
            per=per,
            sides=sides,
            coefficients=coefficients,
            exponents=exponents,
            breaks=breaks,
        )

        return power_law_spectrum
