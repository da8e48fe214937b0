from __future__ import annotations

from collections.abc import Mapping
from typing import (
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

from ..models.table_spectrum_per import TableSpectrumPer, check_table_spectrum_per
from ..models.table_spectrum_sides import TableSpectrumSides, check_table_spectrum_sides

T = TypeVar("T", bound="TableSpectrum")


@_attrs_define
class TableSpectrum:
    """Densities at frequencies, with straight lines between them in double logarithmic scale.

    Attributes:
        kind (Literal['table']):
        per (TableSpectrumPer): Unit of its frequency: S is in m^2/(1/m), or in m^2/(rad/m) of 2 pi times that.
        sides (TableSpectrumSides): Whether its integral over positive frequencies is the variance (1) or half of it.
        frequencies (list[float]): Increasing frequencies.
        densities (list[float]): Densities there.
    """

    kind: Literal["table"]
    per: TableSpectrumPer
    sides: TableSpectrumSides
    frequencies: list[float]
    densities: list[float]

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        per: str = self.per

        sides: int = self.sides

        frequencies = self.frequencies

        densities = self.densities

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "per": per,
                "sides": sides,
                "frequencies": frequencies,
                "densities": densities,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        kind = cast(Literal["table"], d.pop("kind"))
        if kind != "table":
            raise ValueError(f"kind must match const 'table', got '{kind}'")

        per = check_table_spectrum_per(d.pop("per"))

        sides = check_table_spectrum_sides(d.pop("sides"))

        frequencies = cast(list[float], d.pop("frequencies"))

        densities = cast(list[float], d.pop("densities"))

        table_spectrum = cls(
            kind=kind,
            per=per,
            sides=sides,
            frequencies=frequencies,
            densities=densities,
        )

        return table_spectrum
