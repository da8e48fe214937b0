from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.running_case import RunningCase


T = TypeVar("T", bound="WorkerInfo")


@_attrs_define
class WorkerInfo:
    """A worker that said lately that it is there.

    Attributes:
        name (str):
        draining (bool): Whether it takes no more cases, and ends when these are finished.
        running (int): Cases it computes now, side by side.
        cases (list[RunningCase]): Those of them that the caller sees.
    """

    name: str
    draining: bool
    running: int
    cases: list[RunningCase]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        name = self.name

        draining = self.draining

        running = self.running

        cases = []
        for cases_item_data in self.cases:
            cases_item = cases_item_data.to_dict()
            cases.append(cases_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "name": name,
                "draining": draining,
                "running": running,
                "cases": cases,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.running_case import RunningCase  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name")

        draining = d.pop("draining")

        running = d.pop("running")

        cases = []
        _cases = d.pop("cases")
        for cases_item_data in _cases:
            cases_item = RunningCase.from_dict(cases_item_data)

            cases.append(cases_item)

        worker_info = cls(
            name=name,
            draining=draining,
            running=running,
            cases=cases,
        )

        worker_info.additional_properties = d
        return worker_info

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
