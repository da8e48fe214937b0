from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.caveat import Caveat
    from ..models.cpu_estimate import CpuEstimate
    from ..models.estimated_cases import EstimatedCases
    from ..models.finish_estimate import FinishEstimate


T = TypeVar("T", bound="StudyEstimate")


@_attrs_define
class StudyEstimate:
    """What a study would take.

    Attributes:
        cases (EstimatedCases): How many cases a study would have, and what is known of them already.
        cpu (CpuEstimate): Processor time of the new cases, s.
        queue_cpu_s (float): Expected processor time of what is computed before the study's last case.
        workers (int): How many workers are there to compute.
        finish (FinishEstimate | None): Null when there is nothing to compute, or no worker.
        warnings (list[Caveat]):
    """

    cases: EstimatedCases
    cpu: CpuEstimate
    queue_cpu_s: float
    workers: int
    finish: FinishEstimate | None
    warnings: list[Caveat]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.finish_estimate import FinishEstimate  # noqa: PLC0415

        cases = self.cases.to_dict()

        cpu = self.cpu.to_dict()

        queue_cpu_s = self.queue_cpu_s

        workers = self.workers

        finish: dict[str, Any] | None
        if isinstance(self.finish, FinishEstimate):
            finish = self.finish.to_dict()
        else:
            finish = self.finish

        warnings = []
        for warnings_item_data in self.warnings:
            warnings_item = warnings_item_data.to_dict()
            warnings.append(warnings_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "cases": cases,
                "cpu": cpu,
                "queue_cpu_s": queue_cpu_s,
                "workers": workers,
                "finish": finish,
                "warnings": warnings,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.caveat import Caveat  # noqa: PLC0415
        from ..models.cpu_estimate import CpuEstimate  # noqa: PLC0415
        from ..models.estimated_cases import EstimatedCases  # noqa: PLC0415
        from ..models.finish_estimate import FinishEstimate  # noqa: PLC0415

        d = dict(src_dict)
        cases = EstimatedCases.from_dict(d.pop("cases"))

        cpu = CpuEstimate.from_dict(d.pop("cpu"))

        queue_cpu_s = d.pop("queue_cpu_s")

        workers = d.pop("workers")

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

        warnings = []
        _warnings = d.pop("warnings")
        for warnings_item_data in _warnings:
            warnings_item = Caveat.from_dict(warnings_item_data)

            warnings.append(warnings_item)

        study_estimate = cls(
            cases=cases,
            cpu=cpu,
            queue_cpu_s=queue_cpu_s,
            workers=workers,
            finish=finish,
            warnings=warnings,
        )

        study_estimate.additional_properties = d
        return study_estimate

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
