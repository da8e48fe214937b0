"""Profiles as clients see them."""

from datetime import datetime
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from app.pagination import PageQuery


class ProfileInfo(BaseModel):
    """A stored profile."""

    model_config = ConfigDict(from_attributes=True)

    id: str = Field(description="Digest of the samples: the same samples have the same identifier.")
    points: int
    start_m: float = Field(description="Position of the first sample.")
    end_m: float = Field(description="Position of the last sample.")
    wavelength_min_m: float = Field(description="Shortest wavelength that may be used of it: twice its widest gap.")
    wavelength_max_m: float = Field(description="Longest wavelength that may be used of it.")
    lowest_mm: float = Field(description="Smallest height; heights are positive downwards.")
    highest_mm: float = Field(description="Largest height.")
    created_at: datetime


class ProfilePage(BaseModel):
    """A page of profiles."""

    items: list[ProfileInfo]
    next_cursor: str | None


class ProfileQuery(PageQuery):
    """Which profiles to list."""

    sort: Literal["created_at", "-created_at"] = "-created_at"
