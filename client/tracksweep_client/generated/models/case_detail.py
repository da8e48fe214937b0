from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.case_detail_state import CaseDetailState, check_case_detail_state
from ..types import UNSET, Unset

if TYPE_CHECKING:
    from ..models.case_detail_inputs import CaseDetailInputs
    from ..models.case_detail_processing_type_0 import CaseDetailProcessingType0
    from ..models.case_error import CaseError
    from ..models.stored_history import StoredHistory


T = TypeVar("T", bound="CaseDetail")


@_attrs_define
class CaseDetail:
    """A case with everything that went into it.

    Attributes:
        speed_kmh (float):
        slab (str):
        irregularity (str): Kind of irregularity.
        spectrum (None | str):
        percentile (float | None):
        wavelength_min_m (float | None):
        wavelength_max_m (float | None):
        seed (int | None):
        realisation (int | None):
        wavelength_m (float | None):
        amplitude_mm (float | None):
        id (int):
        digest (str): SHA-256 of the inputs.
        solver_version (str):
        state (CaseDetailState):
        progress (float): Fraction done, 0 to 1.
        attempt (int): Number of the attempt that runs or ran last; 0 before the first.
        worker (None | str):
        error (CaseError | None):
        cpu_s (float | None): Processor time of the successful attempt, s; of cases computed together, a share.
        created_at (datetime.datetime):
        started_at (datetime.datetime | None):
        finished_at (datetime.datetime | None):
        inputs (CaseDetailInputs): The case as `tracksweep solve` takes it, every value spelled out; of a measured
            profile, the `profile_id`, where `tracksweep solve` takes a file.
        history (None | StoredHistory):
        processing (CaseDetailProcessingType0 | None | Unset): How its peaks were derived: sampling, window, filters,
            indices, conventions. Null for a case that has not succeeded or was computed before this was stored.
    """

    speed_kmh: float
    slab: str
    irregularity: str
    spectrum: None | str
    percentile: float | None
    wavelength_min_m: float | None
    wavelength_max_m: float | None
    seed: int | None
    realisation: int | None
    wavelength_m: float | None
    amplitude_mm: float | None
    id: int
    digest: str
    solver_version: str
    state: CaseDetailState
    progress: float
    attempt: int
    worker: None | str
    error: CaseError | None
    cpu_s: float | None
    created_at: datetime.datetime
    started_at: datetime.datetime | None
    finished_at: datetime.datetime | None
    inputs: CaseDetailInputs
    history: None | StoredHistory
    processing: CaseDetailProcessingType0 | None | Unset = UNSET
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.case_detail_processing_type_0 import CaseDetailProcessingType0  # noqa: PLC0415
        from ..models.case_error import CaseError  # noqa: PLC0415
        from ..models.stored_history import StoredHistory  # noqa: PLC0415

        speed_kmh = self.speed_kmh

        slab = self.slab

        irregularity = self.irregularity

        spectrum: None | str
        spectrum = self.spectrum

        percentile: float | None
        percentile = self.percentile

        wavelength_min_m: float | None
        wavelength_min_m = self.wavelength_min_m

        wavelength_max_m: float | None
        wavelength_max_m = self.wavelength_max_m

        seed: int | None
        seed = self.seed

        realisation: int | None
        realisation = self.realisation

        wavelength_m: float | None
        wavelength_m = self.wavelength_m

        amplitude_mm: float | None
        amplitude_mm = self.amplitude_mm

        id = self.id

        digest = self.digest

        solver_version = self.solver_version

        state: str = self.state

        progress = self.progress

        attempt = self.attempt

        worker: None | str
        worker = self.worker

        error: dict[str, Any] | None
        if isinstance(self.error, CaseError):
            error = self.error.to_dict()
        else:
            error = self.error

        cpu_s: float | None
        cpu_s = self.cpu_s

        created_at = self.created_at.isoformat()

        started_at: None | str
        if isinstance(self.started_at, datetime.datetime):
            started_at = self.started_at.isoformat()
        else:
            started_at = self.started_at

        finished_at: None | str
        if isinstance(self.finished_at, datetime.datetime):
            finished_at = self.finished_at.isoformat()
        else:
            finished_at = self.finished_at

        inputs = self.inputs.to_dict()

        history: dict[str, Any] | None
        if isinstance(self.history, StoredHistory):
            history = self.history.to_dict()
        else:
            history = self.history

        processing: dict[str, Any] | None | Unset
        if isinstance(self.processing, Unset):
            processing = UNSET
        elif isinstance(self.processing, CaseDetailProcessingType0):
            processing = self.processing.to_dict()
        else:
            processing = self.processing

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "speed_kmh": speed_kmh,
                "slab": slab,
                "irregularity": irregularity,
                "spectrum": spectrum,
                "percentile": percentile,
                "wavelength_min_m": wavelength_min_m,
                "wavelength_max_m": wavelength_max_m,
                "seed": seed,
                "realisation": realisation,
                "wavelength_m": wavelength_m,
                "amplitude_mm": amplitude_mm,
                "id": id,
                "digest": digest,
                "solver_version": solver_version,
                "state": state,
                "progress": progress,
                "attempt": attempt,
                "worker": worker,
                "error": error,
                "cpu_s": cpu_s,
                "created_at": created_at,
                "started_at": started_at,
                "finished_at": finished_at,
                "inputs": inputs,
                "history": history,
            }
        )
        if processing is not UNSET:
            field_dict["processing"] = processing

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.case_detail_inputs import CaseDetailInputs  # noqa: PLC0415
        from ..models.case_detail_processing_type_0 import CaseDetailProcessingType0  # noqa: PLC0415
        from ..models.case_error import CaseError  # noqa: PLC0415
        from ..models.stored_history import StoredHistory  # noqa: PLC0415

        d = dict(src_dict)
        speed_kmh = d.pop("speed_kmh")

        slab = d.pop("slab")

        irregularity = d.pop("irregularity")

        def _parse_spectrum(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        spectrum = _parse_spectrum(d.pop("spectrum"))

        def _parse_percentile(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        percentile = _parse_percentile(d.pop("percentile"))

        def _parse_wavelength_min_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_min_m = _parse_wavelength_min_m(d.pop("wavelength_min_m"))

        def _parse_wavelength_max_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_max_m = _parse_wavelength_max_m(d.pop("wavelength_max_m"))

        def _parse_seed(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        seed = _parse_seed(d.pop("seed"))

        def _parse_realisation(data: object) -> int | None:
            if data is None:
                return data
            return cast(int | None, data)

        realisation = _parse_realisation(d.pop("realisation"))

        def _parse_wavelength_m(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        wavelength_m = _parse_wavelength_m(d.pop("wavelength_m"))

        def _parse_amplitude_mm(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        amplitude_mm = _parse_amplitude_mm(d.pop("amplitude_mm"))

        id = d.pop("id")

        digest = d.pop("digest")

        solver_version = d.pop("solver_version")

        state = check_case_detail_state(d.pop("state"))

        progress = d.pop("progress")

        attempt = d.pop("attempt")

        def _parse_worker(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        worker = _parse_worker(d.pop("worker"))

        def _parse_error(data: object) -> CaseError | None:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                error_type_0 = CaseError.from_dict(data)

                return error_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(CaseError | None, data)

        error = _parse_error(d.pop("error"))

        def _parse_cpu_s(data: object) -> float | None:
            if data is None:
                return data
            return cast(float | None, data)

        cpu_s = _parse_cpu_s(d.pop("cpu_s"))

        created_at = datetime.datetime.fromisoformat(d.pop("created_at"))

        def _parse_started_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                started_at_type_0 = datetime.datetime.fromisoformat(data)

                return started_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        started_at = _parse_started_at(d.pop("started_at"))

        def _parse_finished_at(data: object) -> datetime.datetime | None:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                finished_at_type_0 = datetime.datetime.fromisoformat(data)

                return finished_at_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(datetime.datetime | None, data)

        finished_at = _parse_finished_at(d.pop("finished_at"))

        inputs = CaseDetailInputs.from_dict(d.pop("inputs"))

        def _parse_history(data: object) -> None | StoredHistory:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                history_type_0 = StoredHistory.from_dict(data)

                return history_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(None | StoredHistory, data)

        history = _parse_history(d.pop("history"))

        def _parse_processing(data: object) -> CaseDetailProcessingType0 | None | Unset:
            if data is None:
                return data
            if isinstance(data, Unset):
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                processing_type_0 = CaseDetailProcessingType0.from_dict(data)

                return processing_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(CaseDetailProcessingType0 | None | Unset, data)

        processing = _parse_processing(d.pop("processing", UNSET))

        case_detail = cls(
            speed_kmh=speed_kmh,
            slab=slab,
            irregularity=irregularity,
            spectrum=spectrum,
            percentile=percentile,
            wavelength_min_m=wavelength_min_m,
            wavelength_max_m=wavelength_max_m,
            seed=seed,
            realisation=realisation,
            wavelength_m=wavelength_m,
            amplitude_mm=amplitude_mm,
            id=id,
            digest=digest,
            solver_version=solver_version,
            state=state,
            progress=progress,
            attempt=attempt,
            worker=worker,
            error=error,
            cpu_s=cpu_s,
            created_at=created_at,
            started_at=started_at,
            finished_at=finished_at,
            inputs=inputs,
            history=history,
            processing=processing,
        )

        case_detail.additional_properties = d
        return case_detail

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
