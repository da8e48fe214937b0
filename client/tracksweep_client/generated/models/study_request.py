from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from attrs import define as _attrs_define

from ..models.study_request_sweep_type_0 import (
    StudyRequestSweepType0,
    check_study_request_sweep_type_0,
)
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.list_sweep import ListSweep
    from ..models.numerics_overrides import NumericsOverrides
    from ..models.product_sweep import ProductSweep
    from ..models.study_request_labels import StudyRequestLabels
    from ..models.track_overrides import TrackOverrides
    from ..models.vehicle_overrides import VehicleOverrides
    from ..models.zip_sweep import ZipSweep


T = TypeVar("T", bound="StudyRequest")


@_attrs_define
class StudyRequest:
    """A parametric study: a sweep of one model.

    Attributes:
        name (str):
        sweep (ListSweep | ProductSweep | StudyRequestSweepType0 | ZipSweep): Which cases there are. The name of a
            preset stands for its sweep, and for its track, vehicle and numerics as far as the study does not say otherwise.
        track (TrackOverrides | Unset): Rail, slab and concrete base on a roadbed. Values are of one rail and half the
            slab and base.
        vehicle (VehicleOverrides | Unset): A four-axle car with two suspension stages. Values are of the whole car; the
            model takes half of each.
        numerics (NumericsOverrides | Unset): Mesh, step and observed time.
        labels (StudyRequestLabels | Unset):
        priority (int | Unset): Cases of a higher priority are computed first. Default: 0.
        keep_history (bool | Unset): Whether to store the time histories of every case. Default: False.
    """

    name: str
    sweep: ListSweep | ProductSweep | StudyRequestSweepType0 | ZipSweep
    track: TrackOverrides | Unset = UNSET
    vehicle: VehicleOverrides | Unset = UNSET
    numerics: NumericsOverrides | Unset = UNSET
    labels: StudyRequestLabels | Unset = UNSET
    priority: int | Unset = 0
    keep_history: bool | Unset = False

    def to_dict(self) -> dict[str, Any]:
        from ..models.product_sweep import ProductSweep  # noqa: PLC0415
        from ..models.zip_sweep import ZipSweep  # noqa: PLC0415

        name = self.name

        sweep: dict[str, Any] | str
        if isinstance(self.sweep, str):
            sweep = self.sweep
        elif isinstance(self.sweep, ProductSweep):
            sweep = self.sweep.to_dict()
        elif isinstance(self.sweep, ZipSweep):
            sweep = self.sweep.to_dict()
        else:
            sweep = self.sweep.to_dict()

        track: dict[str, Any] | Unset = UNSET
        if not isinstance(self.track, Unset):
            track = self.track.to_dict()

        vehicle: dict[str, Any] | Unset = UNSET
        if not isinstance(self.vehicle, Unset):
            vehicle = self.vehicle.to_dict()

        numerics: dict[str, Any] | Unset = UNSET
        if not isinstance(self.numerics, Unset):
            numerics = self.numerics.to_dict()

        labels: dict[str, Any] | Unset = UNSET
        if not isinstance(self.labels, Unset):
            labels = self.labels.to_dict()

        priority = self.priority

        keep_history = self.keep_history

        field_dict: dict[str, Any] = {}

        field_dict.update(
            {
                "name": name,
                "sweep": sweep,
            }
        )
        if track is not UNSET:
            field_dict["track"] = track
        if vehicle is not UNSET:
            field_dict["vehicle"] = vehicle
        if numerics is not UNSET:
            field_dict["numerics"] = numerics
        if labels is not UNSET:
            field_dict["labels"] = labels
        if priority is not UNSET:
            field_dict["priority"] = priority
        if keep_history is not UNSET:
            field_dict["keep_history"] = keep_history

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.list_sweep import ListSweep  # noqa: PLC0415
        from ..models.numerics_overrides import NumericsOverrides  # noqa: PLC0415
        from ..models.product_sweep import ProductSweep  # noqa: PLC0415
        from ..models.study_request_labels import StudyRequestLabels  # noqa: PLC0415
        from ..models.track_overrides import TrackOverrides  # noqa: PLC0415
        from ..models.vehicle_overrides import VehicleOverrides  # noqa: PLC0415
        from ..models.zip_sweep import ZipSweep  # noqa: PLC0415

        d = dict(src_dict)
        name = d.pop("name")

        def _parse_sweep(data: object) -> ListSweep | ProductSweep | StudyRequestSweepType0 | ZipSweep:
            try:
                if not isinstance(data, str):
                    raise TypeError()
                sweep_type_0 = check_study_request_sweep_type_0(data)

                return sweep_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                sweep_type_1 = ProductSweep.from_dict(data)

                return sweep_type_1
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                sweep_type_2 = ZipSweep.from_dict(data)

                return sweep_type_2
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            if not isinstance(data, dict):
                raise TypeError()
            sweep_type_3 = ListSweep.from_dict(data)

            return sweep_type_3

        sweep = _parse_sweep(d.pop("sweep"))

        _track = d.pop("track", UNSET)
        track: TrackOverrides | Unset
        if isinstance(_track, Unset):
            track = UNSET
        else:
            track = TrackOverrides.from_dict(_track)

        _vehicle = d.pop("vehicle", UNSET)
        vehicle: VehicleOverrides | Unset
        if isinstance(_vehicle, Unset):
            vehicle = UNSET
        else:
            vehicle = VehicleOverrides.from_dict(_vehicle)

        _numerics = d.pop("numerics", UNSET)
        numerics: NumericsOverrides | Unset
        if isinstance(_numerics, Unset):
            numerics = UNSET
        else:
            numerics = NumericsOverrides.from_dict(_numerics)

        _labels = d.pop("labels", UNSET)
        labels: StudyRequestLabels | Unset
        if isinstance(_labels, Unset):
            labels = UNSET
        else:
            labels = StudyRequestLabels.from_dict(_labels)

        priority = d.pop("priority", UNSET)

        keep_history = d.pop("keep_history", UNSET)

        study_request = cls(
            name=name,
            sweep=sweep,
            track=track,
            vehicle=vehicle,
            numerics=numerics,
            labels=labels,
            priority=priority,
            keep_history=keep_history,
        )

        return study_request
