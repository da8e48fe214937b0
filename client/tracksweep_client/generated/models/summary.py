from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.confidence_interval import ConfidenceInterval
    from ..models.quantiles import Quantiles
    from ..models.summary_conditions import SummaryConditions


T = TypeVar("T", bound="Summary")


@_attrs_define
class Summary:
    """Statistics over the realisations of one condition.

    Attributes:
        quantity (str):
        position (str):
        unit (str):
        conditions (SummaryConditions): Of all that varies in the study, what these cases have in common; by its name in
            the study, as in `track.pad_stiffness_n_per_m`.
        count (int):
        mean (float):
        std (float | None): Of the sample, over count - 1. Null for less than two.
        minimum (float):
        maximum (float):
        quantiles (Quantiles): Values that a part of the realisations stays below, interpolated linearly.
        mean_95 (ConfidenceInterval | None): Interval that holds the mean of all possible realisations with a confidence
            of 95 %, by Student's t. Null for less than two.
    """

    quantity: str
    position: str
    unit: str
    conditions: SummaryConditions
    count: int
    mean: float
    std: float | None
    minimum: float
    maximum: float
    quantiles: Quantiles
    mean_95: ConfidenceInterval | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.confidence_interval import ConfidenceInterval  # noqa: PLC0415

        quantity = self.quantity

        position = self.position

        unit = self.unit

        conditions = self.conditions.to_dict()

        count = self.count

        mean = self.mean

        std: float | None
        std = self.std

        minimum = self.minimum

        maximum = self.maximum

        quantiles = self.quantiles.to_dict()

        mean_95: dict[str, Any] | None
        if isinstance(self.mean_95, ConfidenceInterval):
            mean_95 = self.mean_95.to_dict()
        else:
            mean_95 = self.mean_95

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "quantity": quantity,
                "position": position,
                "unit": unit,
                "conditions": conditions,
                "count": count,
                "mean": mean,
                "std": std,
                "minimum": minimum,
                "maximum": maximum,
                "quantiles": quantiles,
                "mean_95": mean_95,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.confidence_interval import ConfidenceInterval  # noqa: PLC0415
        from ..models.quantiles import Quantiles  # noqa: PLC0415
        from ..models.summary_conditions import SummaryConditions  # noqa: PLC0415

        d = dict(src_dict)
        quantity = d.pop("quantity")

        position = d.pop("position")

        unit = d.pop("unit")

        conditions = SummaryConditions.from_dict(d.pop("conditions"))

        count = d.pop("count")

        mean = d.pop("mean")

        def _parse_std(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        std = _parse_std(d.pop("std"))

        minimum = d.pop("minimum")

        maximum = d.pop("maximum")

        quantiles = Quantiles.from_dict(d.pop("quantiles"))

        def _parse_mean_95(data: object) -> ConfidenceInterval | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                mean_95_type_0 = ConfidenceInterval.from_dict(data)

                return mean_95_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(ConfidenceInterval | None, data)

        mean_95 = _parse_mean_95(d.pop("mean_95"))

        summary = cls(
            quantity=quantity,
            position=position,
            unit=unit,
            conditions=conditions,
            count=count,
            mean=mean,
            std=std,
            minimum=minimum,
            maximum=maximum,
            quantiles=quantiles,
            mean_95=mean_95,
        )

        summary.additional_properties = d
        return summary

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
