from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="EstimatedCases")


@_attrs_define
class EstimatedCases:
    """How many cases a study would have, and what is known of them already.

    Attributes:
        total (int):
        computed (int): Already computed.
        failed (int): Already tried in vain; they stay failed unless the study is retried.
        in_flight (int): Queued or running for another study.
        new (int): To be computed for this study.
    """

    total: int
    computed: int
    failed: int
    in_flight: int
    new: int
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        total = self.total

        computed = self.computed

        failed = self.failed

        in_flight = self.in_flight

        new = self.new

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "total": total,
                "computed": computed,
                "failed": failed,
                "in_flight": in_flight,
                "new": new,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        total = d.pop("total")

        computed = d.pop("computed")

        failed = d.pop("failed")

        in_flight = d.pop("in_flight")

        new = d.pop("new")

        estimated_cases = cls(
            total=total,
            computed=computed,
            failed=failed,
            in_flight=in_flight,
            new=new,
        )

        estimated_cases.additional_properties = d
        return estimated_cases

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
