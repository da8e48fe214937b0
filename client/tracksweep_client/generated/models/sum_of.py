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

if TYPE_CHECKING:
    from ..models.harmonic_wave import HarmonicWave
    from ..models.single_dip import SingleDip
    from ..models.spectrum_sample import SpectrumSample
    from ..models.stored_profile import StoredProfile


T = TypeVar("T", bound="SumOf")


@_attrs_define
class SumOf:
    """Several irregularities added up.

    Attributes:
        kind (Literal['sum']):
        terms (list[HarmonicWave | SingleDip | SpectrumSample | StoredProfile]):
    """

    kind: Literal["sum"]
    terms: list[HarmonicWave | SingleDip | SpectrumSample | StoredProfile]

    def to_dict(self) -> dict[str, Any]:
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415

        kind = self.kind

        terms = []
        for terms_item_data in self.terms:
            terms_item: dict[str, Any]
            if isinstance(terms_item_data, HarmonicWave):
                terms_item = terms_item_data.to_dict()
            elif isinstance(terms_item_data, SpectrumSample):
                terms_item = terms_item_data.to_dict()
            elif isinstance(terms_item_data, SingleDip):
                terms_item = terms_item_data.to_dict()
            else:
                terms_item = terms_item_data.to_dict()

            terms.append(terms_item)

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "terms": terms,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.harmonic_wave import HarmonicWave  # noqa: PLC0415
        from ..models.single_dip import SingleDip  # noqa: PLC0415
        from ..models.spectrum_sample import SpectrumSample  # noqa: PLC0415
        from ..models.stored_profile import StoredProfile  # noqa: PLC0415

        d = dict(src_dict)
        kind = cast(Literal["sum"], d.pop("kind"))
        if kind != "sum":
            raise ValueError(f"kind must match const 'sum', got '{kind}'")

        terms = []
        _terms = d.pop("terms")
        for terms_item_data in _terms:

            def _parse_terms_item(data: object) -> HarmonicWave | SingleDip | SpectrumSample | StoredProfile:
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    terms_item_type_0 = HarmonicWave.from_dict(data)

                    return terms_item_type_0
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    terms_item_type_1 = SpectrumSample.from_dict(data)

                    return terms_item_type_1
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                try:
                    if not isinstance(data, dict):
                        raise TypeError()
                    terms_item_type_2 = SingleDip.from_dict(data)

                    return terms_item_type_2
                except (TypeError, ValueError, AttributeError, KeyError):
                    pass
                if not isinstance(data, dict):
                    raise TypeError()
                terms_item_type_3 = StoredProfile.from_dict(data)

                return terms_item_type_3

            terms_item = _parse_terms_item(terms_item_data)

            terms.append(terms_item)

        sum_of = cls(
            kind=kind,
            terms=terms,
        )

        return sum_of
