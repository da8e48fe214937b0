from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.preset_info_study import PresetInfoStudy


T = TypeVar("T", bound="PresetInfo")


@_attrs_define
class PresetInfo:
    """A ready-made study: its name may stand in place of a sweep.

    Attributes:
        name (str):
        title (str):
        description (str):
        cases (int):
        study (PresetInfoStudy): What `create_study` takes.
    """

    name: str
    title: str
    description: str
    cases: int
    study: PresetInfoStudy
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        name = self.name

        title = self.title

        description = self.description

        cases = self.cases

        study = self.study.to_dict()

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "name": name,
                "title": title,
                "description": description,
                "cases": cases,
                "study": study,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.preset_info_study import PresetInfoStudy  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name")

        title = d.pop("title")

        description = d.pop("description")

        cases = d.pop("cases")

        study = PresetInfoStudy.from_dict(d.pop("study"))

        preset_info = cls(
            name=name,
            title=title,
            description=description,
            cases=cases,
            study=study,
        )

        preset_info.additional_properties = d
        return preset_info

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
