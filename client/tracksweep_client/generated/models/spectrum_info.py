from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

if TYPE_CHECKING:
    from ..models.field_source import FieldSource
    from ..models.interval import Interval
    from ..models.spectrum_info_definition import SpectrumInfoDefinition


T = TypeVar("T", bound="SpectrumInfo")


@_attrs_define
class SpectrumInfo:
    """A named spectrum.

    Attributes:
        name (str):
        title (str):
        unit (str): Of its density.
        definition (SpectrumInfoDefinition): The same as a spectrum of one's own, to be changed.
        wavelength_range_m (Interval | None): For which it was drawn up.
        speed_range_kmh (Interval | None): For which it was drawn up.
        sources (list[FieldSource]):
    """

    name: str
    title: str
    unit: str
    definition: SpectrumInfoDefinition
    wavelength_range_m: Interval | None
    speed_range_kmh: Interval | None
    sources: list[FieldSource]
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.interval import Interval  # noqa: PLC0415

        name = self.name

        title = self.title

        unit = self.unit

        definition = self.definition.to_dict()

        wavelength_range_m: dict[str, Any] | None
        if isinstance(self.wavelength_range_m, Interval):
            wavelength_range_m = self.wavelength_range_m.to_dict()
        else:
            wavelength_range_m = self.wavelength_range_m

        speed_range_kmh: dict[str, Any] | None
        if isinstance(self.speed_range_kmh, Interval):
            speed_range_kmh = self.speed_range_kmh.to_dict()
        else:
            speed_range_kmh = self.speed_range_kmh

        sources = []
        for sources_item_data in self.sources:
            sources_item = sources_item_data.to_dict()
            sources.append(sources_item)

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "name": name,
                "title": title,
                "unit": unit,
                "definition": definition,
                "wavelength_range_m": wavelength_range_m,
                "speed_range_kmh": speed_range_kmh,
                "sources": sources,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.field_source import FieldSource  # noqa: PLC0415
        from ..models.interval import Interval  # noqa: PLC0415
        from ..models.spectrum_info_definition import SpectrumInfoDefinition  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name")

        title = d.pop("title")

        unit = d.pop("unit")

        definition = SpectrumInfoDefinition.from_dict(d.pop("definition"))

        def _parse_wavelength_range_m(data: object) -> Interval | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                wavelength_range_m_type_0 = Interval.from_dict(data)

                return wavelength_range_m_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Interval | None, data)

        wavelength_range_m = _parse_wavelength_range_m(d.pop("wavelength_range_m"))

        def _parse_speed_range_kmh(data: object) -> Interval | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                speed_range_kmh_type_0 = Interval.from_dict(data)

                return speed_range_kmh_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Interval | None, data)

        speed_range_kmh = _parse_speed_range_kmh(d.pop("speed_range_kmh"))

        sources = []
        _sources = d.pop("sources")
        for sources_item_data in _sources:
            sources_item = FieldSource.from_dict(sources_item_data)

            sources.append(sources_item)

        spectrum_info = cls(
            name=name,
            title=title,
            unit=unit,
            definition=definition,
            wavelength_range_m=wavelength_range_m,
            speed_range_kmh=speed_range_kmh,
            sources=sources,
        )

        spectrum_info.additional_properties = d
        return spectrum_info

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
