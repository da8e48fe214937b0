from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

from ..models.rational_spectrum_per import (
    RationalSpectrumPer,
    check_rational_spectrum_per,
)
from ..models.rational_spectrum_sides import (
    RationalSpectrumSides,
    check_rational_spectrum_sides,
)
from ..types import UNSET, Unset

T = TypeVar("T", bound="RationalSpectrum")


@_attrs_define
class RationalSpectrum:
    """``S = A c^2 / ((f^2 + r^2) (f^2 + c^2))``.

    Attributes:
        kind (Literal['rational']):
        per (RationalSpectrumPer): Unit of its frequency: S is in m^2/(1/m), or in m^2/(rad/m) of 2 pi times that.
        sides (RationalSpectrumSides): Whether its integral over positive frequencies is the variance (1) or half of it.
        roughness (float): A, m^2 times the unit of frequency.
        cutoff (float): C, cut-off frequency.
        lower_cutoff (float | Unset): R, lower cut-off frequency, at most 0.99 c. Default: 0.0.
    """

    kind: Literal["rational"]
    per: RationalSpectrumPer
    sides: RationalSpectrumSides
    roughness: float
    cutoff: float
    lower_cutoff: float | Unset = 0.0

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        per: str = self.per

        sides: int = self.sides

        roughness = self.roughness

        cutoff = self.cutoff

        lower_cutoff = self.lower_cutoff

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "per": per,
                "sides": sides,
                "roughness": roughness,
                "cutoff": cutoff,
            }
        )
        if lower_cutoff is not UNSET:
            field_dict["lower_cutoff"] = lower_cutoff

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["rational"], d.pop("kind"))
        if kind != "rational":
            raise ValueError(f"kind must match const 'rational', got '{kind}'")

        per = check_rational_spectrum_per(d.pop("per"))

        sides = check_rational_spectrum_sides(d.pop("sides"))

        roughness = d.pop("roughness")

        cutoff = d.pop("cutoff")

        lower_cutoff = d.pop("lower_cutoff", UNSET)

        rational_spectrum = cls(
            kind=kind,
            per=per,
            sides=sides,
            roughness=roughness,
            cutoff=cutoff,
            lower_cutoff=lower_cutoff,
        )

        return rational_spectrum
