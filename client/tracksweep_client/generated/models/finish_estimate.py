from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

T = TypeVar("T", bound="FinishEstimate")


@_attrs_define
class FinishEstimate:
    """When a study will be finished by the workers that are there, judging by what such cases took before.

    Attributes:
        expected (datetime.datetime):
        earliest (datetime.datetime):
        latest (datetime.datetime):
    """

    expected: datetime.datetime
    earliest: datetime.datetime
    latest: datetime.datetime
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        expected = self.expected.isoformat()

        earliest = self.earliest.isoformat()

        latest = self.latest.isoformat()

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "expected": expected,
                "earliest": earliest,
                "latest": latest,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        expected = datetime.datetime.fromisoformat(d.pop("expected"))

        earliest = datetime.datetime.fromisoformat(d.pop("earliest"))

        latest = datetime.datetime.fromisoformat(d.pop("latest"))

        finish_estimate = cls(
            expected=expected,
            earliest=earliest,
            latest=latest,
        )

        finish_estimate.additional_properties = d
        return finish_estimate

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
