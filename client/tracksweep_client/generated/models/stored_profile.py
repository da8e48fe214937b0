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


T = TypeVar("T", bound="StoredProfile")


@_attrs_define
class StoredProfile:
    """A stored profile, of which a band of wavelengths is used: all that it holds if none is given.

    Attributes:
        kind (Literal['measured']):
        profile_id (str):
        wavelength_band_m (Band | None | Unset):
    """

    kind: Literal["measured"]
    profile_id: str
    wavelength_band_m: Band | None | Unset = UNSET

    def to_dict(self) -> dict[str, Any]:
        from ..models.band import Band  # noqa: PLC0415

        kind = self.kind

        profile_id = self.profile_id

        wavelength_band_m: dict[str, Any] | None | Unset
        if isinstance(self.wavelength_band_m, Unset):
            wavelength_band_m = UNSET
        elif isinstance(self.wavelength_band_m, Band):
            wavelength_band_m = self.wavelength_band_m.to_dict()
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

        def _parse_wavelength_band_m(data: object) -> Band | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                wavelength_band_m_type_0 = Band.from_dict(data)

                return wavelength_band_m_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(Band | None | Unset, data)

        wavelength_band_m = _parse_wavelength_band_m(d.pop("wavelength_band_m", UNSET))

        stored_profile = cls(
            kind=kind,
            profile_id=profile_id,
            wavelength_band_m=wavelength_band_m,
        )

        return stored_profile
