from __future__ import annotations

from collections.abc import Mapping
from typing import (
    TYPE_CHECKING,
    Any,
    Literal,
    TypeVar,
    cast,
)

from attrs import define as _attrs_define

from ..models.product_sweep_slab_item import (
    ProductSweepSlabItem,
    check_product_sweep_slab_item,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.harmonic_sweep import HarmonicSweep
    from ..models.profile_sweep import ProfileSweep
    from ..models.single_dip import SingleDip
    from ..models.smooth_rail import SmoothRail
    from ..models.spectrum_sweep import SpectrumSweep
    from ..models.speed_range import SpeedRange
    from ..models.sum_of import SumOf
    from ..models.vary import Vary


T = TypeVar("T", bound="ProductSweep")


@_attrs_define
class ProductSweep:
    """Every value of each axis with every value of the others. An axis holds no value twice.

    Attributes:
        speed_kmh (list[float] | SpeedRange):
        irregularity (HarmonicSweep | ProfileSweep | SingleDip | SmoothRail | SpectrumSweep | SumOf):
        kind (Literal['product']):
        slab (list[ProductSweepSlabItem] | Unset):
        vary (Vary | Unset): Lists of values of parameters; each replaces what the study says of it.
    """

    speed_kmh: list[float] | SpeedRange
    irregularity: HarmonicSweep | ProfileSweep | SingleDip | SmoothRail | SpectrumSweep | SumOf
    kind: Literal["product"]
    slab: list[ProductSweepSlabItem] | Unset = UNSET
    vary: Vary | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.harmonic_sweep import HarmonicSweep  # noqa: PLC0415
        from ..models.profile_sweep import ProfileSweep  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sweep import SpectrumSweep  # noqa: PLC0415

        speed_kmh: dict[str, Any] | list[float]
        if isinstance(self.speed_kmh, list):
            speed_kmh = self.speed_kmh

        else:
            speed_kmh = self.speed_kmh.to_dict()

        irregularity: dict[str, Any]
        if isinstance(self.irregularity, SmoothRail):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, HarmonicSweep):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, SpectrumSweep):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, ProfileSweep):
            irregularity = self.irregularity.to_dict()
        elif isinstance(self.irregularity, SingleDip):
            irregularity = self.irregularity.to_dict()
        else:
            irregularity = self.irregularity.to_dict()

        kind = self.kind

        slab: list[str] | Unset = UNSET
        if not isinstance(self.slab, Unset):
            slab = []
            for slab_item_data in self.slab:
                slab_item: str = slab_item_data
                slab.append(slab_item)

        vary: dict[str, Any] | Unset = UNSET
        if not isinstance(self.vary, Unset):
            vary = self.vary.to_dict()

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "speed_kmh": speed_kmh,
                "irregularity": irregularity,
                "kind": kind,
            }
        )
        if slab is not UNSET:
            field_dict["slab"] = slab
        if vary is not UNSET:
            field_dict["vary"] = vary

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.harmonic_sweep import HarmonicSweep  # noqa: PLC0415
        from ..models.profile_sweep import ProfileSweep  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.smooth_rail import SmoothRail  # noqa: PLC0415
        from ..models.spectrum_sweep import SpectrumSweep  # noqa: PLC0415
        from ..models.speed_range import SpeedRange  # noqa: PLC0415
        from ..models.sum_of import SumOf  # noqa: PLC0415
        from ..models.vary import Vary  # noqa: PLC0415

        d = dict(src_dict)

        def _parse_speed_kmh(data: object) -> list[float] | SpeedRange:
            try:
                if not isinstance(data, list):
                    raise TypeError()
                speed_kmh_type_0 = cast(list[float], data)

                return speed_kmh_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            speed_kmh_type_1 = SpeedRange.from_dict(data)

            return speed_kmh_type_1

        speed_kmh = _parse_speed_kmh(d.pop("speed_kmh"))

        def _parse_irregularity(
            data: object,
        ) -> HarmonicSweep | ProfileSweep | SingleDip | SmoothRail | SpectrumSweep | SumOf:
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
                irregularity_type_1 = HarmonicSweep.from_dict(data)

                return irregularity_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_2 = SpectrumSweep.from_dict(data)

                return irregularity_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                irregularity_type_3 = ProfileSweep.from_dict(data)

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

        kind = cast(Literal["product"], d.pop("kind"))
        if kind != "product":
            raise ValueError(f"kind must match const 'product', got '{kind}'")

        _slab = d.pop("slab", UNSET)
        slab: list[ProductSweepSlabItem] | Unset = UNSET
        if _slab is not UNSET:
            slab = []
            for slab_item_data in _slab:
                slab_item = check_product_sweep_slab_item(slab_item_data)

                slab.append(slab_item)

        _vary = d.pop("vary", UNSET)
        vary: Vary | Unset
        if isinstance(_vary, Unset):
            vary = UNSET
        else:
            vary = Vary.from_dict(_vary)

        product_sweep = cls(
            speed_kmh=speed_kmh,
            irregularity=irregularity,
            kind=kind,
            slab=slab,
            vary=vary,
        )

        return product_sweep
