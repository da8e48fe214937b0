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

from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.band import Band


T = TypeVar("T", bound="ProfileSweep")


@_attrs_define
class ProfileSweep:
    """A stored profile, of which several bands of wavelengths are used: all that it holds if none is given.

    Attributes:
        kind (Literal['measured']):
        profile_id (str):
        wavelength_band_m (list[Band] | None | Unset):
    """

    kind: Literal["measured"]
    profile_id: str
    wavelength_band_m: list[Band] | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        kind = self.kind

        profile_id = self.profile_id

        wavelength_band_m: list[dict[str, Any]] | None | Unset
        if isinstance(self.wavelength_band_m, Unset):
            wavelength_band_m = UNSET
        elif isinstance(self.wavelength_band_m, list):
            wavelength_band_m = []
            for wavelength_band_m_type_0_item_data in self.wavelength_band_m:
                wavelength_band_m_type_0_item = wavelength_band_m_type_0_item_data.to_dict()
                wavelength_band_m.append(wavelength_band_m_type_0_item)

        else:
            wavelength_band_m = self.wavelength_band_m

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "kind": kind,
                "profile_id": profile_id,
            }
        )
        if wavelength_band_m is not UNSET:
            field_dict["wavelength_band_m"] = wavelength_band_m

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.band import Band  # noqa: PLC0415

        d = dict(src_dict)
        kind = cast(Literal["measured"], d.pop("kind"))
        if kind != "measured":
            raise ValueError(f"kind must match const 'measured', got '{kind}'")

        profile_id = d.pop("profile_id")

        def _parse_wavelength_band_m(data: object) -> list[Band] | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, list):
                    raise TypeError()
                wavelength_band_m_type_0 = []
                _wavelength_band_m_type_0 = data
                for wavelength_band_m_type_0_item_data in _wavelength_band_m_type_0:
                    wavelength_band_m_type_0_item = Band.from_dict(wavelength_band_m_type_0_item_data)

                    wavelength_band_m_type_0.append(wavelength_band_m_type_0_item)

                return wavelength_band_m_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(list[Band] | None | Unset, data)

        wavelength_band_m = _parse_wavelength_band_m(d.pop("wavelength_band_m", UNSET))

        profile_sweep = cls(
            kind=kind,
            profile_id=profile_id,
            wavelength_band_m=wavelength_band_m,
        )

        return profile_sweep
