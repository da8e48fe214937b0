from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.named_set import NamedSet
    from ..models.wheel_tread import WheelTread


T = TypeVar("T", bound="VehicleList")


@_attrs_define
class VehicleList:
    """All cars, of which the first is the default, and wheel treads.

    Attributes:
        items (list[NamedSet]):
        wheel_treads (list[WheelTread]):
    """

    items: list[NamedSet]
    wheel_treads: list[WheelTread]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        items = []
        for items_item_data in self.items:
            items_item = items_item_data.to_dict()
            items.append(items_item)

        wheel_treads = []
        for wheel_treads_item_data in self.wheel_treads:
            wheel_treads_item = wheel_treads_item_data.to_dict()
            wheel_treads.append(wheel_treads_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "items": items,
                "wheel_treads": wheel_treads,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.named_set import NamedSet  # noqa: PLC0415
        from ..models.wheel_tread import WheelTread  # noqa: PLC0415

        d = dict(src_dict)
        items = []
        _items = d.pop("items")
        for items_item_data in _items:
            items_item = NamedSet.from_dict(items_item_data)

            items.append(items_item)

        wheel_treads = []
        _wheel_treads = d.pop("wheel_treads")
        for wheel_treads_item_data in _wheel_treads:
            wheel_treads_item = WheelTread.from_dict(wheel_treads_item_data)

            wheel_treads.append(wheel_treads_item)

        vehicle_list = cls(
            items=items,
            wheel_treads=wheel_treads,
        )

        vehicle_list.additional_properties = d
        return vehicle_list

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
