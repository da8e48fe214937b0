from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.catalogue_value_mark import CatalogueValueMark, check_catalogue_value_mark

T = TypeVar("T", bound="CatalogueValue")


@_attrs_define
class CatalogueValue:
    """A value of a track or a car.

    Attributes:
        source (str):
        mark (CatalogueValueMark): How sure that is: V, read in the named source; C, in common use in the literature,
            its primary source not seen; A, assumed here.
        name (str): As in the study's `track` or `vehicle`; with a dot within `joint`.
        value (float | str):
        unit (str):
        meaning (str):
        basis (str): Of what the value is: one rail, one axle, a whole car.
    """

    source: str
    mark: CatalogueValueMark
    name: str
    value: float | str
    unit: str
    meaning: str
    basis: str
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        source = self.source

        mark: str = self.mark

        name = self.name

        value: float | str
        value = self.value

        unit = self.unit

        meaning = self.meaning

        basis = self.basis

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "source": source,
                "mark": mark,
                "name": name,
                "value": value,
                "unit": unit,
                "meaning": meaning,
                "basis": basis,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        source = d.pop("source")

        mark = check_catalogue_value_mark(d.pop("mark"))

        name = d.pop("name")

        def _parse_value(data: object) -> float | str:
            return cast(float | str, data)

        value = _parse_value(d.pop("value"))

        unit = d.pop("unit")

        meaning = d.pop("meaning")

        basis = d.pop("basis")

        catalogue_value = cls(
            source=source,
            mark=mark,
            name=name,
            value=value,
            unit=unit,
            meaning=meaning,
            basis=basis,
        )

        catalogue_value.additional_properties = d
        return catalogue_value

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
