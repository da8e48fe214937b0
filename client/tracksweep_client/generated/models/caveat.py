from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.caveat_code import CaveatCode, check_caveat_code

T = TypeVar("T", bound="Caveat")


@_attrs_define
class Caveat:
    """What is worth knowing before a study is computed.

    Attributes:
        code (CaveatCode): Stable name of the reason.
        pointer (str): JSON Pointer into the request: what could be changed.
        detail (str): The reason in words.
        cases (int): How many cases it concerns.
    """

    code: CaveatCode
    pointer: str
    detail: str
    cases: int
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        code: str = self.code

        pointer = self.pointer

        detail = self.detail

        cases = self.cases

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "code": code,
                "pointer": pointer,
                "detail": detail,
                "cases": cases,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        code = check_caveat_code(d.pop("code"))

        pointer = d.pop("pointer")

        detail = d.pop("detail")

        cases = d.pop("cases")

        caveat = cls(
            code=code,
            pointer=pointer,
            detail=detail,
            cases=cases,
        )

        caveat.additional_properties = d
        return caveat

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
