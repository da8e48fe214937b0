from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.mean_difference import MeanDifference
    from ..models.pairing import Pairing


T = TypeVar("T", bound="Comparison")


@_attrs_define
class Comparison:
    """Differences along one axis of a study, between cases that are otherwise equal.

    Attributes:
        study_id (str):
        axis (str):
        statistic (str):
        baseline (Any):
        averages (list[MeanDifference]):
        groups (list[Pairing]):
        groups_without_baseline (int): Left out: their case at the baseline has not succeeded.
    """

    study_id: str
    axis: str
    statistic: str
    baseline: Any
    averages: list[MeanDifference]
    groups: list[Pairing]
    groups_without_baseline: int
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        study_id = self.study_id

        axis = self.axis

        statistic = self.statistic

        baseline = self.baseline

        averages = []
        for averages_item_data in self.averages:
            averages_item = averages_item_data.to_dict()
            averages.append(averages_item)

        groups = []
        for groups_item_data in self.groups:
            groups_item = groups_item_data.to_dict()
            groups.append(groups_item)

        groups_without_baseline = self.groups_without_baseline

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "study_id": study_id,
                "axis": axis,
                "statistic": statistic,
                "baseline": baseline,
                "averages": averages,
                "groups": groups,
                "groups_without_baseline": groups_without_baseline,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.mean_difference import MeanDifference  # noqa: PLC0415
        from ..models.pairing import Pairing  # noqa: PLC0415

        d = dict(src_dict)
        study_id = d.pop("study_id")

        axis = d.pop("axis")

        statistic = d.pop("statistic")

        baseline = d.pop("baseline")

        averages = []
        _averages = d.pop("averages")
        for averages_item_data in _averages:
            averages_item = MeanDifference.from_dict(averages_item_data)

            averages.append(averages_item)

        groups = []
        _groups = d.pop("groups")
        for groups_item_data in _groups:
            groups_item = Pairing.from_dict(groups_item_data)

            groups.append(groups_item)

        groups_without_baseline = d.pop("groups_without_baseline")

        comparison = cls(
            study_id=study_id,
            axis=axis,
            statistic=statistic,
            baseline=baseline,
            averages=averages,
            groups=groups,
            groups_without_baseline=groups_without_baseline,
        )

        comparison.additional_properties = d
        return comparison

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
