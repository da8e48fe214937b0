from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.quantity_info_peak import QuantityInfoPeak, check_quantity_info_peak

if TYPE_CHECKING:
    from ..models.quantity_limit import QuantityLimit


T = TypeVar("T", bound="QuantityInfo")


@_attrs_define
class QuantityInfo:
    """A quantity of which peaks are given.

    Attributes:
        name (str):
        title (str):
        unit (str):
        convention (str): Of what it is and which sign means what; empty where the title says it.
        peak (QuantityInfoPeak): What its `peak` is the largest of.
        derived_from (None | str): The recorded quantity behind it; null if it is in histories itself.
        positions (list[str]):
        limits (list[QuantityLimit]):
    """

    name: str
    title: str
    unit: str
    convention: str
    peak: QuantityInfoPeak
    derived_from: None | str
    positions: list[str]
    limits: list[QuantityLimit]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        name = self.name

        title = self.title

        unit = self.unit

        convention = self.convention

        peak: str = self.peak

        derived_from: None | str
        derived_from = self.derived_from

        positions = self.positions

        limits = []
        for limits_item_data in self.limits:
            limits_item = limits_item_data.to_dict()
            limits.append(limits_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "name": name,
                "title": title,
                "unit": unit,
                "convention": convention,
                "peak": peak,
                "derived_from": derived_from,
                "positions": positions,
                "limits": limits,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.quantity_limit import QuantityLimit  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name")

        title = d.pop("title")

        unit = d.pop("unit")

        convention = d.pop("convention")

        peak = check_quantity_info_peak(d.pop("peak"))

        def _parse_derived_from(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        derived_from = _parse_derived_from(d.pop("derived_from"))

        positions = cast(list[str], d.pop("positions"))

        limits = []
        _limits = d.pop("limits")
        for limits_item_data in _limits:
            limits_item = QuantityLimit.from_dict(limits_item_data)

            limits.append(limits_item)

        quantity_info = cls(
            name=name,
            title=title,
            unit=unit,
            convention=convention,
            peak=peak,
            derived_from=derived_from,
            positions=positions,
            limits=limits,
        )

        quantity_info.additional_properties = d
        return quantity_info

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
