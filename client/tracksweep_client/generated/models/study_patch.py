from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.study_patch_labels import StudyPatchLabels


T = TypeVar("T", bound="StudyPatch")


@_attrs_define
class StudyPatch:
    """Changes to a study, as a JSON merge patch (RFC 7396): what is left out stays, a label of null is removed.

    Attributes:
        name (str | Unset):
        labels (StudyPatchLabels | Unset): At most 64 may remain.
        priority (int | Unset): Cases of a higher priority are computed first.
    """

    name: str | Unset = UNSET
    labels: StudyPatchLabels | Unset = UNSET
    priority: int | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        name = self.name

        labels: dict[str, Any] | Unset = UNSET
        if not isinstance(self.labels, Unset):
            labels = self.labels.to_dict()

        priority = self.priority

        field_dict: dict[str, Any] = {}

        field_dict.update({})
        if name is not UNSET:
            field_dict["name"] = name
        if labels is not UNSET:
            field_dict["labels"] = labels
        if priority is not UNSET:
            field_dict["priority"] = priority

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.study_patch_labels import StudyPatchLabels  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name", UNSET)

        _labels = d.pop("labels", UNSET)
        labels: StudyPatchLabels | Unset
        if isinstance(_labels, Unset):
            labels = UNSET
        else:
            labels = StudyPatchLabels.from_dict(_labels)

        priority = d.pop("priority", UNSET)

        study_patch = cls(
            name=name,
            labels=labels,
            priority=priority,
        )

        return study_patch
