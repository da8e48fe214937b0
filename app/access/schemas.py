"""What clients see of keys: their names and limits, never their secrets."""

from pydantic import BaseModel, Field

from app.db.models import Scope


class Share(BaseModel):
    """Somebody who may see a study of another."""

    key: str = Field(description="Name of the key.")


class ShareList(BaseModel):
    """Everybody with whom a study is shared, by name."""

    items: list[Share]


class CallerLimits(BaseModel):
    """What the caller may do, and has left of it."""

    key: str | None = Field(description="Name of the key; null for a request without one.")
    scope: Scope
    max_queued_cases: int | None = Field(description="Cases that may wait or run at a time; null: any number.")
    queued_cases: int = Field(description="Cases that wait or run because this caller was the first to ask for them.")
    cpu_s_per_day: float | None = Field(description="Processor time per 24 hours, s; null: any.")
    cpu_s_last_day: float = Field(
        description="Processor time of the cases that were computed in the last 24 hours because this caller was the "
        "first to ask for them, s."
    )
    reads_per_minute: int = Field(description="GET requests per minute; 0: any number.")
    writes_per_minute: int = Field(description="Other requests per minute; 0: any number.")
