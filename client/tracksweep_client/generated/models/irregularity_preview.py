from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.height_density import HeightDensity
    from ..models.heights import Heights


T = TypeVar("T", bound="IrregularityPreview")


@_attrs_define
class IrregularityPreview:
    """An irregularity over some length, sampled as the solver does.

    Attributes:
        spacing_m (float): Distance between samples.
        samples (int):
        lowest_mm (float):
        highest_mm (float):
        rms_mm (float):
        profile (Heights): Heights along the track, positive downwards.
        density (HeightDensity): A one-sided power spectral density of heights, m^2/(1/m), at frequencies per metre of
            track.
        drawn_from (HeightDensity | None): The density from which realisations are drawn, with the percentile, in the
            band. Null where the irregularity is not of a spectrum.
    """

    spacing_m: float
    samples: int
    lowest_mm: float
    highest_mm: float
    rms_mm: float
    profile: Heights
    density: HeightDensity
    drawn_from: HeightDensity | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.height_density import HeightDensity  # noqa: PLC0415

        spacing_m = self.spacing_m

        samples = self.samples

        lowest_mm = self.lowest_mm

        highest_mm = self.highest_mm

        rms_mm = self.rms_mm

        profile = self.profile.to_dict()

        density = self.density.to_dict()

        drawn_from: dict[str, Any] | None
        if isinstance(self.drawn_from, HeightDensity):
            drawn_from = self.drawn_from.to_dict()
        else:
            drawn_from = self.drawn_from

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "spacing_m": spacing_m,
                "samples": samples,
                "lowest_mm": lowest_mm,
                "highest_mm": highest_mm,
                "rms_mm": rms_mm,
                "profile": profile,
                "density": density,
                "drawn_from": drawn_from,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.height_density import HeightDensity  # noqa: PLC0415
        from ..models.heights import Heights  # noqa: PLC0415

        d = dict(src_dict)
        spacing_m = d.pop("spacing_m")

        samples = d.pop("samples")

        lowest_mm = d.pop("lowest_mm")

        highest_mm = d.pop("highest_mm")

        rms_mm = d.pop("rms_mm")

        profile = Heights.from_dict(d.pop("profile"))

        density = HeightDensity.from_dict(d.pop("density"))

        def _parse_drawn_from(data: object) -> HeightDensity | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                drawn_from_type_0 = HeightDensity.from_dict(data)

                return drawn_from_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(HeightDensity | None, data)

        drawn_from = _parse_drawn_from(d.pop("drawn_from"))

        irregularity_preview = cls(
            spacing_m=spacing_m,
            samples=samples,
            lowest_mm=lowest_mm,
            highest_mm=highest_mm,
            rms_mm=rms_mm,
            profile=profile,
            density=density,
            drawn_from=drawn_from,
        )

        irregularity_preview.additional_properties = d
        return irregularity_preview

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
