from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.harmonic_wave import HarmonicWave
    from ..models.single_dip import SingleDip
    from ..models.smooth_rail import SmoothRail
    from ..models.spectrum_sample import SpectrumSample
    from ..models.stored_profile import StoredProfile
    from ..models.sum_of import SumOf


T = TypeVar("T", bound="PreviewRequest")


@_attrs_define
class PreviewRequest:
    """An irregularity, and which part of it to look at.

    Attributes:
        irregularity (HarmonicWave | SingleDip | SmoothRail | SpectrumSample | StoredProfile | SumOf):
        start_m (float | Unset): Where to begin, m. Default: 0.0.
        length_m (float | Unset): How long, m; at most 4096 of the shortest wavelengths. Default: 100.0.
        max_points (int | Unset): Points of the profile. Of more samples, the least and greatest among neighbours are
            kept. Default: 1000.
    """

    irregularity: HarmonicWave | SingleDip | SmoothRail | SpectrumSample | StoredProfile | SumOf
    start_m: float | Unset = 0.0
    length_m: float | Unset = 100.0
    max_points: int | Unset = 1000

    def to_dict(self) -> dict[str, Any]:
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415
        from ..models.stored_profile import StoredProfile  # noqa: PLC0415

        irregularity: dict[str, Any]
        if isinstance(self.irregularity, SmoothRail):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, HarmonicWave):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, SpectrumSample):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, StoredProfile):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, SingleDip):
            irregularity = self.irregularity.to_dict()
        else:
            irregularity = self.irregularity.to_dict()

        start_m = self.start_m

        length_m = self.length_m

        max_points = self.max_points

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "irregularity": irregularity,
            }
        )
        if start_m is not UNSET:
            field_dict["start_m"] = start_m
        if length_m is not UNSET:
            field_dict["length_m"] = length_m
        if max_points is not UNSET:
            field_dict["max_points"] = max_points

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415
        from ..models.stored_profile import StoredProfile  # noqa: PLC0415
        from ..models.sum_of import SumOf  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_irregularity(
            data: object,
        ) -> HarmonicWave | SingleDip | SmoothRail | SpectrumSample | StoredProfile | SumOf:
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_0 = SmoothRail.from_dict(data)

                return irregularity_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_1 = HarmonicWave.from_dict(data)

                return irregularity_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_2 = SpectrumSample.from_dict(data)

                return irregularity_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_3 = StoredProfile.from_dict(data)

                return irregularity_type_3
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_4 = SingleDip.from_dict(data)

                return irregularity_type_4
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            irregularity_type_5 = SumOf.from_dict(data)

            return irregularity_type_5

        irregularity = _parse_irregularity(d.pop("irregularity"))

        start_m = d.pop("start_m", UNSET)

        length_m = d.pop("length_m", UNSET)

        max_points = d.pop("max_points", UNSET)

        preview_request = cls(
            irregularity=irregularity,
            start_m=start_m,
            length_m=length_m,
            max_points=max_points,
        )

        return preview_request
