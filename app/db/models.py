"""The tables. Instants are seconds since 1970 (UTC) by the database's clock."""

from typing import Any, Literal, get_args

from sqlalchemy import (
    JSON,
    CheckConstraint,
    Double,
    ForeignKey,
    Index,
    LargeBinary,
    MetaData,
    String,
    UniqueConstraint,
    false,
)
from sqlalchemy.orm import DeclarativeBase, Mapped, mapped_column

from app.db.types import BigKey, Clock, Word

CaseState = Literal["queued", "running", "succeeded", "failed", "cancelled"]
StudyState = Literal["queued", "running", "cancelling", "succeeded", "partially_failed", "failed", "cancelled"]
STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
EventKind = Literal["state", "case", "done"]
VerificationState = Literal["queued", "running", "succeeded", "failed"]
VerificationOutcome = Literal["same", "differs"]
Scope = Literal["read", "write", "admin"]
SCHEMA = "0012"  # the revision of the migrations that makes these tables


class Base(DeclarativeBase):
    """Base of the tables."""

    metadata = MetaData(
        naming_convention={
            "ix": "ix_%(table_name)s_%(column_0_N_name)s",
            "uq": "uq_%(table_name)s_%(column_0_N_name)s",
            "ck": "ck_%(table_name)s_%(constraint_name)s",
            "fk": "fk_%(table_name)s_%(column_0_N_name)s_%(referred_table_name)s",
            "pk": "pk_%(table_name)s",
        }
    )
    type_annotation_map = {float: Double(), dict[str, Any]: JSON(), str: String(), CaseState: String(16)}  # noqa: RUF012 - SQLAlchemy's own protocol


class ApiKey(Base):
    """Who may use the service: a name, of whose secret only a hash is known. It is revoked, never deleted."""

    __tablename__ = "api_key"

    id: Mapped[int] = mapped_column(BigKey, primary_key=True)
    name: Mapped[str] = mapped_column(unique=True)
    scope: Mapped[Scope] = mapped_column(String(16))
    hash: Mapped[str] = mapped_column(String(64))  # SHA-256 of the secret, which is random and needs no salt
    max_queued_cases: Mapped[int | None]
    cpu_s_per_day: Mapped[float | None]
    created_at: Mapped[float] = mapped_column(default=Clock())
    revoked_at: Mapped[float | None]
    last_used_at: Mapped[float | None]  # to the hour


class Study(Base):
    """A parametric study as it was asked for. Its state is derived from its cases and never stored."""

    __tablename__ = "study"

    id: Mapped[str] = mapped_column(String(32), primary_key=True)
    owner_id: Mapped[int | None] = mapped_column(ForeignKey("api_key.id"), index=True)  # null: asked for without a key
    name: Mapped[str]
    labels: Mapped[dict[str, Any]]
    priority: Mapped[int]
    end_turn: Mapped[int] = mapped_column(BigKey, server_default="0")  # behind its last case, see app/cases/queue.py
    keep_history: Mapped[bool]
    request: Mapped[dict[str, Any]]
    cases_reused: Mapped[int]
    created_at: Mapped[float] = mapped_column(default=Clock(), index=True)
    started_at: Mapped[float | None]
    finished_at: Mapped[float | None]
    cancel_requested_at: Mapped[float | None]


class Case(Base):
    """One simulation, whoever asked for it: the queue, the lease and the outcome are this row."""

    __tablename__ = "case"
    __table_args__ = (
        UniqueConstraint("digest", "solver_version"),
        CheckConstraint(f"state IN ({', '.join(map(repr, get_args(CaseState)))})", name="state"),
    )

    id: Mapped[int] = mapped_column(BigKey, primary_key=True)
    digest: Mapped[str] = mapped_column(String(64))
    solver_version: Mapped[str]
    operator_key: Mapped[str] = mapped_column(String(64))  # equal for cases that can be computed side by side
    inputs: Mapped[dict[str, Any]]  # Case.to_dict(samples=False), SI
    work: Mapped[float | None]  # unknowns times steps; null in rows older than this column

    speed_kmh: Mapped[float]
    slab: Mapped[str]
    irregularity: Mapped[str]
    spectrum: Mapped[str | None]
    percentile: Mapped[float | None]
    wavelength_min_m: Mapped[float | None]
    wavelength_max_m: Mapped[float | None]
    seed: Mapped[int | None] = mapped_column(BigKey)
    realisation: Mapped[int | None]
    wavelength_m: Mapped[float | None]
    amplitude_mm: Mapped[float | None]

    state: Mapped[CaseState] = mapped_column(default="queued")
    priority: Mapped[int]
    turn: Mapped[int] = mapped_column(BigKey, server_default="0")  # place in the queue, see app/cases/queue.py
    attempt: Mapped[int] = mapped_column(default=0)  # with the token, fences out a worker that lost its lease
    charged_to: Mapped[int | None] = mapped_column(BigKey)  # the key that asked for its computation first
    lease_token: Mapped[str | None] = mapped_column(String(32))
    lease_expires: Mapped[float | None]
    heartbeat_at: Mapped[float | None]
    worker: Mapped[str | None]
    progress: Mapped[float] = mapped_column(default=0.0)
    error: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))  # {"code", "detail"}
    cpu_s: Mapped[float | None]
    processing: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))  # how its peaks were derived
    created_at: Mapped[float] = mapped_column(default=Clock())
    started_at: Mapped[float | None]
    finished_at: Mapped[float | None]


CONDITIONS = (
    *("speed_kmh", "slab", "irregularity", "spectrum", "percentile", "wavelength_min_m", "wavelength_max_m"),
    *("seed", "realisation", "wavelength_m", "amplitude_mm", "solver_version"),
)
for _name in CONDITIONS:
    Index(None, getattr(Case, _name), Case.id)
# The last two are what is asked of all that wait.
Index("ix_case_queue", Case.state, Case.priority.desc(), Case.turn, Case.id, Case.operator_key, Case.work)
Index("ix_case_charged", Case.charged_to, Case.finished_at)
Index("ix_case_operator", Case.operator_key, Case.state, Case.priority, Case.id)


class Worker(Base):
    """A worker that said lately that it is there."""

    __tablename__ = "worker"

    name: Mapped[str] = mapped_column(primary_key=True)
    expires: Mapped[float]
    draining: Mapped[bool] = mapped_column(server_default=false())  # it takes no more cases


class StudyShare(Base):
    """That a key may see a study of another."""

    __tablename__ = "study_share"

    study_id: Mapped[str] = mapped_column(ForeignKey("study.id", ondelete="CASCADE"), primary_key=True)
    key_id: Mapped[int] = mapped_column(ForeignKey("api_key.id"), primary_key=True, index=True)


class StudyCase(Base):
    """That a study contains a case, and at which place."""

    __tablename__ = "study_case"

    study_id: Mapped[str] = mapped_column(ForeignKey("study.id", ondelete="CASCADE"), primary_key=True)
    case_id: Mapped[int] = mapped_column(ForeignKey("case.id"), primary_key=True, index=True)
    position: Mapped[int]


class Profile(Base):
    """A measured profile of the rail head, named by the digest of its samples."""

    __tablename__ = "profile"

    id: Mapped[str] = mapped_column(String(64), primary_key=True)
    samples: Mapped[bytes] = mapped_column(LargeBinary, deferred=True)  # megabytes: read where they are asked for
    points: Mapped[int]
    start_m: Mapped[float]
    end_m: Mapped[float]
    wavelength_min_m: Mapped[float]
    wavelength_max_m: Mapped[float]
    lowest_mm: Mapped[float]
    highest_mm: Mapped[float]
    created_at: Mapped[float] = mapped_column(default=Clock(), index=True)


class ProfileKey(Base):
    """That a key has stored a profile, maybe after another did."""

    __tablename__ = "profile_key"

    profile_id: Mapped[str] = mapped_column(ForeignKey("profile.id", ondelete="CASCADE"), primary_key=True)
    key_id: Mapped[int] = mapped_column(ForeignKey("api_key.id"), primary_key=True, index=True)


class StudyProfile(Base):
    """That a study uses a profile, which therefore stays."""

    __tablename__ = "study_profile"

    study_id: Mapped[str] = mapped_column(ForeignKey("study.id", ondelete="CASCADE"), primary_key=True)
    profile_id: Mapped[str] = mapped_column(ForeignKey("profile.id"), primary_key=True, index=True)


def _in_order_of(statistic: str) -> tuple[str, ...]:
    """What an index holds from which peaks are read in this order. Which of them pass is seen there, without looking
    rows up; docs/decisions/0007 tells more.
    """
    seen = "case_id", "position", "speed_kmh", "percentile", "peak"
    return statistic, "id", *(name for name in seen if name != statistic)


class Peak(Base):
    """Peak and statistics of one quantity at one position, in ``unit``, over the steady window of a case."""

    __tablename__ = "peak"
    __table_args__ = (
        UniqueConstraint("case_id", "quantity", "position"),
        Index("ix_peak_quantity", "quantity", "position", "id", "peak"),
        Index("ix_peak_position", "position", "id", "peak"),
        Index("ix_peak_unit", "unit", "id", "position", "peak"),
        Index("ix_peak_peak", *_in_order_of("peak")),
        *(Index(f"ix_peak_by_{name}", "quantity", *_in_order_of(name)) for name in STATISTICS),
    )

    id: Mapped[int] = mapped_column(BigKey, primary_key=True)
    case_id: Mapped[int] = mapped_column(ForeignKey("case.id", ondelete="CASCADE"))
    quantity: Mapped[str] = mapped_column(Word)
    position: Mapped[str] = mapped_column(Word)
    unit: Mapped[str] = mapped_column(Word)
    peak: Mapped[float]
    maximum: Mapped[float]
    minimum: Mapped[float]
    mean: Mapped[float]
    std: Mapped[float]
    rms: Mapped[float]
    time_s: Mapped[float]
    track_position_m: Mapped[float]
    speed_kmh: Mapped[float]  # of its case, as is the percentile
    percentile: Mapped[float | None]


class History(Base):
    """Where the stored time history of a case lies: one immutable object of the history store."""

    __tablename__ = "history"

    case_id: Mapped[int] = mapped_column(ForeignKey("case.id", ondelete="CASCADE"), primary_key=True)
    key: Mapped[str]
    digest: Mapped[str] = mapped_column(String(64))  # SHA-256 of the object
    size_bytes: Mapped[int] = mapped_column(BigKey)


class Verification(Base):
    """A case computed once more, to see whether it still gives the stored numbers."""

    __tablename__ = "verification"
    __table_args__ = (Index(None, "case_id", "id"), Index(None, "state", "id"))

    id: Mapped[int] = mapped_column(BigKey, primary_key=True)
    case_id: Mapped[int] = mapped_column(ForeignKey("case.id", ondelete="CASCADE"))
    state: Mapped[VerificationState] = mapped_column(String(16), default="queued")
    attempt: Mapped[int] = mapped_column(default=0)
    lease_token: Mapped[str | None] = mapped_column(String(32))
    lease_expires: Mapped[float | None]
    requested_at: Mapped[float] = mapped_column(default=Clock())
    finished_at: Mapped[float | None]
    solver_version: Mapped[str | None]
    outcome: Mapped[VerificationOutcome | None] = mapped_column(String(16))
    differences: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))  # largest, by quantity
    error: Mapped[dict[str, Any] | None] = mapped_column(JSON(none_as_null=True))  # {"code", "detail"}


class Event(Base):
    """Something that happened to a study, numbered in the order in which a follower hears of it."""

    __tablename__ = "event"
    __table_args__ = (Index(None, "study_id", "id"),)

    id: Mapped[int] = mapped_column(BigKey, primary_key=True)
    study_id: Mapped[str] = mapped_column(ForeignKey("study.id", ondelete="CASCADE"))
    kind: Mapped[EventKind] = mapped_column(String(16))
    payload: Mapped[dict[str, Any]]
    created_at: Mapped[float] = mapped_column(default=Clock())


class IdempotencyKey(Base):
    """The first answer to a request that may be repeated."""

    __tablename__ = "idempotency_key"

    key: Mapped[str] = mapped_column(String(255), primary_key=True)
    request_digest: Mapped[str] = mapped_column(String(64))
    response: Mapped[dict[str, Any]]
    created_at: Mapped[float] = mapped_column(default=Clock(), index=True)


class Tally(Base):
    """One of the counts that operators are shown."""

    __tablename__ = "tally"

    name: Mapped[str] = mapped_column(String(32), primary_key=True)
    label: Mapped[str] = mapped_column(String(32), primary_key=True)
    value: Mapped[float]
