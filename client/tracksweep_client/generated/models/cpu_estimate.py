from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeVar

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.cpu_estimate_basis import CpuEstimateBasis, check_cpu_estimate_basis

T = TypeVar("T", bound="CpuEstimate")


@_attrs_define
class CpuEstimate:
    """Processor time of the new cases, s.

    Attributes:
        expected_s (float):
        least_s (float):
        most_s (float):
        basis (CpuEstimateBasis): From what it was told: computed cases of the same track, speed and numerics; any
            computed cases, by unknowns and steps; or a benchmark, where none was computed yet.
    """

    expected_s: float
    least_s: float
    most_s: float
    basis: CpuEstimateBasis
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        expected_s = self.expected_s

        least_s = self.least_s

        most_s = self.most_s

        basis: str = self.basis

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "expected_s": expected_s,
                "least_s": least_s,
                "most_s": most_s,
                "basis": basis,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        d = dict(src_dict)
        expected_s = d.pop("expected_s")

        least_s = d.pop("least_s")

        most_s = d.pop("most_s")

        basis = check_cpu_estimate_basis(d.pop("basis"))

        cpu_estimate = cls(
            expected_s=expected_s,
            least_s=least_s,
            most_s=most_s,
            basis=basis,
        )

        cpu_estimate.additional_properties = d
        return cpu_estimate

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
