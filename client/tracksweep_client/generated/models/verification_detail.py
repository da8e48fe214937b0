from __future__ import annotations

import datetime
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

from attrs import define as _attrs_define
from attrs import field as _attrs_field

from ..models.verification_detail_outcome_type_0 import (
    VerificationDetailOutcomeType0,
    check_verification_detail_outcome_type_0,
)
from ..models.verification_detail_state import (
    VerificationDetailState,
    check_verification_detail_state,
)

if TYPE_CHECKING:
    from ..models.case_error import CaseError
    from ..models.verification_detail_differences_type_0 import (
        VerificationDetailDifferencesType0,
    )


T = TypeVar("T", bound="VerificationDetail")


@_attrs_define
class VerificationDetail:
    """A case computed once more. What is stored of the case is not touched, whatever comes of it.

    Attributes:
        case_id (int):
        state (VerificationDetailState):
        requested_at (datetime.datetime):
        finished_at (datetime.datetime | None):
        solver_version (None | str): Of the solver that computed it once more.
        outcome (None | VerificationDetailOutcomeType0): `same` if no number differs by more than 1e-06 of its
            quantity's largest magnitude.
        differences (None | VerificationDetailDifferencesType0): Of every stored quantity the largest difference between
            a stored number and the new one, as part of the largest magnitude of the quantity there; 1 if it is not computed
            any more.
        error (CaseError | None): Why it could not be computed.
    """

    case_id: int
    state: VerificationDetailState
    requested_at: datetime.datetime
    finished_at: datetime.datetime | None
    solver_version: None | str
    outcome: None | VerificationDetailOutcomeType0
    differences: None | VerificationDetailDifferencesType0
    error: CaseError | None
    additional_properties: dict[str, Any] = _attrs_field(init=False, factory=dict)

    def to_dict(self) -> dict[str, Any]:
        from ..models.case_error import CaseError  # noqa: PLC0415
        from ..models.verification_detail_differences_type_0 import (
            VerificationDetailDifferencesType0,  # noqa: PLC0415
        )

        case_id = self.case_id

        state: str = self.state

        requested_at = self.requested_at.isoformat()

        finished_at: None | str
        if isinstance(self.finished_at, datetime.datetime):
            finished_at = self.finished_at.isoformat()
        else:
            finished_at = self.finished_at

        solver_version: None | str
        solver_version = self.solver_version

        outcome: None | str
        if isinstance(self.outcome, str):
            outcome = self.outcome
        else:
            outcome = self.outcome

        differences: dict[str, Any] | None
        if isinstance(self.differences, VerificationDetailDifferencesType0):
            differences = self.differences.to_dict()
        else:
            differences = self.differences

        error: dict[str, Any] | None
        if isinstance(self.error, CaseError):
            error = self.error.to_dict()
        else:
            error = self.error

        field_dict: dict[str, Any] = {}
        field_dict.update(self.additional_properties)
        field_dict.update(
            {
                "case_id": case_id,
                "state": state,
                "requested_at": requested_at,
                "finished_at": finished_at,
                "solver_version": solver_version,
                "outcome": outcome,
                "differences": differences,
                "error": error,
            }
        )

        return field_dict

    @classmethod
    def from_dict(cls: type[T], src_dict: Mapping[str, Any]) -> T:
        from ..models.case_error import CaseError  # noqa: PLC0415
        from ..models.verification_detail_differences_type_0 import (
            VerificationDetailDifferencesType0,  # noqa: PLC0415
        )

        d = dict(src_dict)
        case_id = d.pop("case_id")

        state = check_verification_detail_state(d.pop("state"))

        requested_at = datetime.datetime.fromisoformat(d.pop("requested_at"))

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

        def _parse_solver_version(data: object) -> None | str:
            if data is None:
                return data
            return cast(None | str, data)

        solver_version = _parse_solver_version(d.pop("solver_version"))

        def _parse_outcome(data: object) -> None | VerificationDetailOutcomeType0:
            if data is None:
                return data
            try:
                if not isinstance(data, str):
                    raise TypeError()
                outcome_type_0 = check_verification_detail_outcome_type_0(data)

                return outcome_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(None | VerificationDetailOutcomeType0, data)

        outcome = _parse_outcome(d.pop("outcome"))

        def _parse_differences(data: object) -> None | VerificationDetailDifferencesType0:
            if data is None:
                return data
            try:
                if not isinstance(data, dict):
                    raise TypeError()
                differences_type_0 = VerificationDetailDifferencesType0.from_dict(data)

                return differences_type_0
            except (TypeError, ValueError, AttributeError, KeyError):
                pass
            return cast(None | VerificationDetailDifferencesType0, data)

        differences = _parse_differences(d.pop("differences"))

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

        verification_detail = cls(
            case_id=case_id,
            state=state,
            requested_at=requested_at,
            finished_at=finished_at,
            solver_version=solver_version,
            outcome=outcome,
            differences=differences,
            error=error,
        )

        verification_detail.additional_properties = d
        return verification_detail

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
