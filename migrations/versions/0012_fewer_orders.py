"""Peaks in order within a quantity only, but for the peak itself, and their names compared by their bytes."""

import sqlalchemy as sa
from alembic import op

revision = "0012"
down_revision = "0011"
branch_labels = None
depends_on = None

STATISTICS = ("maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
NAMES = ("quantity", "position", "unit")


def upgrade() -> None:
    """Apply."""
    for name in STATISTICS:
        op.drop_index(f"ix_peak_{name}", "peak")
    _compare_names(sa.String(collation="C"))


def downgrade() -> None:
    """Take back."""
    _compare_names(sa.String(collation="default"))
    for name in STATISTICS:
        op.create_index(
            f"ix_peak_{name}", "peak", [name, "id", "case_id", "position", "speed_kmh", "percentile", "peak"]
        )


def _compare_names(kind: sa.String) -> None:
    """One statement, so that PostgreSQL builds indexes once. SQLite compares bytes anyway."""
    if op.get_bind().dialect.name == "postgresql":
        changes = (f"ALTER {name} TYPE {kind.compile(dialect=op.get_bind().dialect)}" for name in NAMES)
        op.execute(f"ALTER TABLE peak {', '.join(changes)}")
