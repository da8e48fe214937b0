from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.wheel_tread_mark import WheelTreadMark, check_wheel_tread_mark

T = TypeVar("T", bound="WheelTread")


@_attrs_define
class WheelTread:
    """A wheel tread: the Hertz constant is `factor * R^exponent`, m/N^(2/3), of the wheel's radius R in m.

    Attributes:
        source (str):
        mark (WheelTreadMark): How sure that is: V, read in the named source; C, in common use in the literature, its
            primary source not seen; A, assumed here.
        name (str):
        title (str):
        factor (float):
        exponent (float):
    """

    source: str
    mark: WheelTreadMark
    name: str
    title: str
    factor: float
    exponent: float
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        source = self.source

        mark: str = self.mark

        name = self.name

        title = self.title

        factor = self.factor

        exponent = self.exponent

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "source": source,
                "mark": mark,
                "name": name,
                "title": title,
                "factor": factor,
                "exponent": exponent,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        source = d.pop("source")

        mark = check_wheel_tread_mark(d.pop("mark"))

        name = d.pop("name")

        title = d.pop("title")

        factor = d.pop("factor")

        exponent = d.pop("exponent")

        wheel_tread = cls(
            source=source,
            mark=mark,
            name=name,
            title=title,
            factor=factor,
            exponent=exponent,
        )

        wheel_tread.additional_properties = d
        return wheel_tread

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
