from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..models.listed_case_slab import ListedCaseSlab, check_listed_case_slab
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.changes import Changes
    from ..models.harmonic_wave import HarmonicWave
    from ..models.single_dip import SingleDip
    from ..models.smooth_rail import SmoothRail
    from ..models.spectrum_sample import SpectrumSample
    from ..models.stored_profile import StoredProfile
    from ..models.sum_of import SumOf


T = TypeVar("T", bound="ListedCase")


@_attrs_define
class ListedCase:
    """One case of a list: single values.

    Attributes:
        speed_kmh (float): Speed of the train, km/h.
        irregularity (HarmonicWave | SingleDip | SmoothRail | SpectrumSample | StoredProfile | SumOf):
        slab (ListedCaseSlab | Unset):  Default: 'continuous'.
        vary (Changes | Unset): Values of parameters; each replaces what the study says of it.
    """

    speed_kmh: float
    irregularity: HarmonicWave | SingleDip | SmoothRail | SpectrumSample | StoredProfile | SumOf
    slab: ListedCaseSlab | Unset = "continuous"
    vary: Changes | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415
        from ..models.stored_profile import StoredProfile  # noqa: PLC0415

        speed_kmh = self.speed_kmh

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

        slab: str | Unset = UNSET
        if not isinstance(self.slab, Unset):
            slab = self.slab

        vary: dict[str, Any] | Unset = UNSET
        if not isinstance(self.vary, Unset):
            vary = self.vary.to_dict()

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "speed_kmh": speed_kmh,
                "irregularity": irregularity,
            }
        )
        if slab is not UNSET:
            field_dict["slab"] = slab
        if vary is not UNSET:
            field_dict["vary"] = vary

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.changes import Changes  # noqa: PLC0415
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415
        from ..models.stored_profile import StoredProfile  # noqa: PLC0415
        from ..models.sum_of import SumOf  # noqa: PLC0415

        d = dict(src_dict)
        speed_kmh = d.pop("speed_kmh")

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

        _slab = d.pop("slab", UNSET)
        slab: ListedCaseSlab | Unset
        if isinstance(_slab, Unset):
            slab = UNSET
        else:
            slab = check_listed_case_slab(_slab)

        _vary = d.pop("vary", UNSET)
        vary: Changes | Unset
        if isinstance(_vary, Unset):
            vary = UNSET
        else:
            vary = Changes.from_dict(_vary)

        listed_case = cls(
            speed_kmh=speed_kmh,
            irregularity=irregularity,
            slab=slab,
            vary=vary,
        )

        return listed_case
