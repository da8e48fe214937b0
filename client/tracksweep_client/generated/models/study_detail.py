from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.study_detail_state import StudyDetailState, check_study_detail_state
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.case_counts import CaseCounts
    from ..models.finish_estimate import FinishEstimate
    from ..models.study_detail_definition import StudyDetailDefinition
    from ..models.study_detail_labels import StudyDetailLabels


T = TypeVar("T", bound="StudyDetail")


@_attrs_define
class StudyDetail:
    """A study, how far it is and what was asked for.

    Attributes:
        id (str):
        name (str):
        labels (StudyDetailLabels):
        priority (int):
        keep_history (bool):
        state (StudyDetailState):
        progress (float): Fraction done, 0 to 1.
        cases (CaseCounts): How many cases of a study are in which state.
        cases_reused (int): Cases that were already computed when the study was created.
        created_at (datetime.datetime):
        started_at (datetime.datetime | None):
        finished_at (datetime.datetime | None):
        finish (FinishEstimate | None): Null when it has ended, or while no worker is there.
        definition (StudyDetailDefinition): The request that created the study.
        owner (None | str | Unset): Name of the API key that created it; null if that took none.
    """

    id: str
    name: str
    labels: StudyDetailLabels
    priority: int
    keep_history: bool
    state: StudyDetailState
    progress: float
    cases: CaseCounts
    cases_reused: int
    created_at: datetime.datetime
    started_at: datetime.datetime | None
    finished_at: datetime.datetime | None
    finish: FinishEstimate | None
    definition: StudyDetailDefinition
    owner: None | str | Unset = UNSET
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.finish_estimate import FinishEstimate  # noqa: PLC0415

        id = self.id

        name = self.name

        labels = self.labels.to_dict()

        priority = self.priority

        keep_history = self.keep_history

        state: str = self.state

        progress = self.progress

        cases = self.cases.to_dict()

        cases_reused = self.cases_reused

        created_at = self.created_at.isoformat()

        started_at: None | str
        if isinstance(self.started_at, datetime.datetime):
            started_at = self.started_at.isoformat()
        else:
            started_at = self.started_at

        finished_at: None | str
        if isinstance(self.finished_at, datetime.datetime):
            finished_at = self.finished_at.isoformat()
        else:
            finished_at = self.finished_at

        finish: dict[str, Any] | None
        if isinstance(self.finish, FinishEstimate):
            finish = self.finish.to_dict()
        else:
            finish = self.finish

        definition = self.definition.to_dict()

        owner: None | str | Unset
        if isinstance(self.owner, Unset):
            owner = UNSET
        else:
            owner = self.owner

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "id": id,
                "name": name,
                "labels": labels,
                "priority": priority,
                "keep_history": keep_history,
                "state": state,
                "progress": progress,
                "cases": cases,
                "cases_reused": cases_reused,
                "created_at": created_at,
                "started_at": started_at,
                "finished_at": finished_at,
                "finish": finish,
                "definition": definition,
            }
        )
        if owner is not UNSET:
            field_dict["owner"] = owner

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.case_counts import CaseCounts  # noqa: PLC0415
        from ..models.finish_estimate import FinishEstimate  # noqa: PLC0415
        from ..models.study_detail_definition import StudyDetailDefinition  # noqa: PLC0415
        from ..models.study_detail_labels import StudyDetailLabels  # noqa: PLC0415

        d = dict(src_dict)
        id = d.pop("id")

        name = d.pop("name")

        labels = StudyDetailLabels.from_dict(d.pop("labels"))

        priority = d.pop("priority")

        keep_history = d.pop("keep_history")

        state = check_study_detail_state(d.pop("state"))

        progress = d.pop("progress")

        cases = CaseCounts.from_dict(d.pop("cases"))

        cases_reused = d.pop("cases_reused")

        created_at = datetime.datetime.fromisoformat(d.pop("created_at"))

        def _parse_started_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                started_at_type_0 = datetime.datetime.fromisoformat(data)

                return started_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        started_at = _parse_started_at(d.pop("started_at"))

        def _parse_finished_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                finished_at_type_0 = datetime.datetime.fromisoformat(data)

                return finished_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        finished_at = _parse_finished_at(d.pop("finished_at"))

        def _parse_finish(data: object) -> FinishEstimate | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                finish_type_0 = FinishEstimate.from_dict(data)

                return finish_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(FinishEstimate | None, data)

        finish = _parse_finish(d.pop("finish"))

        definition = StudyDetailDefinition.from_dict(d.pop("definition"))

        def _parse_owner(data: object) -> None | str | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            return cast(None | str | Unset, data)

        owner = _parse_owner(d.pop("owner", UNSET))

        study_detail = cls(
            id=id,
            name=name,
            labels=labels,
            priority=priority,
            keep_history=keep_history,
            state=state,
            progress=progress,
            cases=cases,
            cases_reused=cases_reused,
            created_at=created_at,
            started_at=started_at,
            finished_at=finished_at,
            finish=finish,
            definition=definition,
            owner=owner,
        )

        study_detail.additional_properties = d
        return study_detail

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
