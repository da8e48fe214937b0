"""Verifications as clients see them."""

from datetime import datetime

from pydantic import BaseModel, ConfigDict, Field

from app.cases.views import CaseError
from app.db.models import VerificationOutcome, VerificationState

TOLERANCE = 1e-6  # beyond what another processor's rounding does to a peak, below what anybody reads


class VerificationDetail(BaseModel):
    """A case computed once more. What is stored of the case is not touched, whatever comes of it."""

    model_config = ConfigDict(from_attributes=True)

    case_id: int
    state: VerificationState
    requested_at: datetime
    finished_at: datetime | None
    solver_version: str | None = Field(description="Of the solver that computed it once more.")
    outcome: VerificationOutcome | None = Field(
        description=f"`same` if no number differs by more than {TOLERANCE:g} of its quantity's largest magnitude."
    )
    differences: dict[str, float] | None = Field(
        description="Of every stored quantity the largest difference between a stored number and the new one, as part "
        "of the largest magnitude of the quantity there; 1 if it is not computed any more."
    )
    error: CaseError | None = Field(description="Why it could not be computed.")
