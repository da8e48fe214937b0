from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.caller_limits import CallerLimits
    from ..models.parameter_info import ParameterInfo


T = TypeVar("T", bound="Limits")


@_attrs_define
class Limits:
    """How much can be asked for.

    Attributes:
        caller (CallerLimits): What the caller may do, and has left of it.
        max_cases_per_study (int):
        max_page_size (int):
        max_body_bytes (int):
        max_profile_bytes (int):
        max_profile_points (int):
        max_labels (int):
        max_irregularity_terms (int):
        max_spectrum_points (int):
        parameters (list[ParameterInfo]):
    """

    caller: CallerLimits
    max_cases_per_study: int
    max_page_size: int
    max_body_bytes: int
    max_profile_bytes: int
    max_profile_points: int
    max_labels: int
    max_irregularity_terms: int
    max_spectrum_points: int
    parameters: list[ParameterInfo]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        caller = self.caller.to_dict()

        max_cases_per_study = self.max_cases_per_study

        max_page_size = self.max_page_size

        max_body_bytes = self.max_body_bytes

        max_profile_bytes = self.max_profile_bytes

        max_profile_points = self.max_profile_points

        max_labels = self.max_labels

        max_irregularity_terms = self.max_irregularity_terms

        max_spectrum_points = self.max_spectrum_points

        parameters = []
        for parameters_item_data in self.parameters:
            parameters_item = parameters_item_data.to_dict()
            parameters.append(parameters_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "caller": caller,
                "max_cases_per_study": max_cases_per_study,
                "max_page_size": max_page_size,
                "max_body_bytes": max_body_bytes,
                "max_profile_bytes": max_profile_bytes,
                "max_profile_points": max_profile_points,
                "max_labels": max_labels,
                "max_irregularity_terms": max_irregularity_terms,
                "max_spectrum_points": max_spectrum_points,
                "parameters": parameters,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.caller_limits import CallerLimits  # noqa: PLC0415
        from ..models.parameter_info import ParameterInfo  # noqa: PLC0415

        d = dict(src_dict)
        caller = CallerLimits.from_dict(d.pop("caller"))

        max_cases_per_study = d.pop("max_cases_per_study")

        max_page_size = d.pop("max_page_size")

        max_body_bytes = d.pop("max_body_bytes")

        max_profile_bytes = d.pop("max_profile_bytes")

        max_profile_points = d.pop("max_profile_points")

        max_labels = d.pop("max_labels")

        max_irregularity_terms = d.pop("max_irregularity_terms")

        max_spectrum_points = d.pop("max_spectrum_points")

        parameters = []
        _parameters = d.pop("parameters")
        for parameters_item_data in _parameters:
            parameters_item = ParameterInfo.from_dict(parameters_item_data)

            parameters.append(parameters_item)

        limits = cls(
            caller=caller,
            max_cases_per_study=max_cases_per_study,
            max_page_size=max_page_size,
            max_body_bytes=max_body_bytes,
            max_profile_bytes=max_profile_bytes,
            max_profile_points=max_profile_points,
            max_labels=max_labels,
            max_irregularity_terms=max_irregularity_terms,
            max_spectrum_points=max_spectrum_points,
            parameters=parameters,
        )

        limits.additional_properties = d
        return limits

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
