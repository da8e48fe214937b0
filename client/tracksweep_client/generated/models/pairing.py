from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.difference import Difference
    from ..models.pairing_conditions import PairingConditions


T = TypeVar("T", bound="Pairing")


@_attrs_define
class Pairing:
    """Cases that differ along the axis only.

    Attributes:
        quantity (str):
        position (str):
        unit (str):
        conditions (PairingConditions): Of all that varies in the study, what these cases have in common; by its name in
            the study, as in `track.pad_stiffness_n_per_m`.
        baseline_value (float):
        differences (list[Difference]):
    """

    quantity: str
    position: str
    unit: str
    conditions: PairingConditions
    baseline_value: float
    differences: list[Difference]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        quantity = self.quantity

        position = self.position

        unit = self.unit

        conditions = self.conditions.to_dict()

        baseline_value = self.baseline_value

        differences = []
        for differences_item_data in self.differences:
            differences_item = differences_item_data.to_dict()
            differences.append(differences_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "conditions": conditions,
                "baseline_value": baseline_value,
                "differences": differences,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.difference import Difference  # noqa: PLC0415
        from ..models.pairing_conditions import PairingConditions  # noqa: PLC0415

        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        conditions = PairingConditions.from_dict(d.pop("conditions"))

        baseline_value = d.pop("baseline_value")

        differences = []
        _differences = d.pop("differences")
        for differences_item_data in _differences:
            differences_item = Difference.from_dict(differences_item_data)

            differences.append(differences_item)

        pairing = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            conditions=conditions,
            baseline_value=baseline_value,
            differences=differences,
        )

        pairing.additional_properties = d
        return pairing

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
