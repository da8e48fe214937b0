"""The queue as clients see it."""

from datetime import datetime

from pydantic import BaseModel, ConfigDict, Field


class RunningCase(BaseModel):
    """A case that a worker computes."""

    model_config = ConfigDict(from_attributes=True)

    id: int
    speed_kmh: float
    slab: str
    irregularity: str
    progress: float = Field(description="Fraction done, 0 to 1.")
    attempt: int
    started_at: datetime | None


class WorkerInfo(BaseModel):
    """A worker that said lately that it is there."""

    name: str
    draining: bool = Field(description="Whether it takes no more cases, and ends when these are finished.")
    running: int = Field(description="Cases it computes now, side by side.")
    cases: list[RunningCase] = Field(description="Those of them that the caller sees.")


class Throughput(BaseModel):
    """How many cases were computed lately, successfully or not; of the latest 10 000 cases."""

    last_minute: int
    last_hour: int
    cpu_s_last_hour: float = Field(description="Processor time of those of the last hour, s.")


class QueueInfo(BaseModel):
    """The queue and its workers."""

    queued: int = Field(description="Cases that wait, whoever asked for them.")
    running: int
    oldest_queued_at: datetime | None = Field(description="When the oldest case that waits was first asked for.")
    throughput: Throughput
    workers: list[WorkerInfo]
