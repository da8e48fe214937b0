from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.caller_limits_scope import CallerLimitsScope, check_caller_limits_scope

T = TypeVar("T", bound="CallerLimits")


@_attrs_define
class CallerLimits:
    """What the caller may do, and has left of it.

    Attributes:
        key (None | str): Name of the key; null for a request without one.
        scope (CallerLimitsScope):
        max_queued_cases (int | None): Cases that may wait or run at a time; null: any number.
        queued_cases (int): Cases that wait or run because this caller was the first to ask for them.
        cpu_s_per_day (float | None): Processor time per 24 hours, s; null: any.
        cpu_s_last_day (float): Processor time of the cases that were computed in the last 24 hours because this caller
            was the first to ask for them, s.
        reads_per_minute (int): GET requests per minute; 0: any number.
        writes_per_minute (int): Other requests per minute; 0: any number.
    """

    key: None | str
    scope: CallerLimitsScope
    max_queued_cases: int | None
    queued_cases: int
    cpu_s_per_day: float | None
    cpu_s_last_day: float
    reads_per_minute: int
    writes_per_minute: int
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        key: None | str
        key = self.key

        scope: str = self.scope

        max_queued_cases: int | None
        max_queued_cases = self.max_queued_cases

        queued_cases = self.queued_cases

        cpu_s_per_day: float | None
        cpu_s_per_day = self.cpu_s_per_day

        cpu_s_last_day = self.cpu_s_last_day

        reads_per_minute = self.reads_per_minute

        writes_per_minute = self.writes_per_minute

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "key": key,
                "scope": scope,
                "max_queued_cases": max_queued_cases,
                "queued_cases": queued_cases,
                "cpu_s_per_day": cpu_s_per_day,
                "cpu_s_last_day": cpu_s_last_day,
                "reads_per_minute": reads_per_minute,
                "writes_per_minute": writes_per_minute,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)

        def _parse_key(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        key = _parse_key(d.pop("key"))

        scope = check_caller_limits_scope(d.pop("scope"))

        def _parse_max_queued_cases(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        max_queued_cases = _parse_max_queued_cases(d.pop("max_queued_cases"))

        queued_cases = d.pop("queued_cases")

        def _parse_cpu_s_per_day(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        cpu_s_per_day = _parse_cpu_s_per_day(d.pop("cpu_s_per_day"))

        cpu_s_last_day = d.pop("cpu_s_last_day")

        reads_per_minute = d.pop("reads_per_minute")

        writes_per_minute = d.pop("writes_per_minute")

        caller_limits = cls(
            key=key,
            scope=scope,
            max_queued_cases=max_queued_cases,
            queued_cases=queued_cases,
            cpu_s_per_day=cpu_s_per_day,
            cpu_s_last_day=cpu_s_last_day,
            reads_per_minute=reads_per_minute,
            writes_per_minute=writes_per_minute,
        )

        caller_limits.additional_properties = d
        return caller_limits

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
