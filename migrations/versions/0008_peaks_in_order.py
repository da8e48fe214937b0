"""Peaks in any order with any filter, from indexes that hold what is asked."""

from alembic import op

revision = "0008"
down_revision = "0007"
branch_labels = None
depends_on = None

STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
NAMES = {
    "quantity": ["quantity", "position", "id", "peak"],
    "position": ["position", "id", "peak"],
    "unit": ["unit", "id", "position", "peak"],
}


def upgrade() -> None:
    """Apply."""
    for name, columns in NAMES.items():
        op.drop_index(f"ix_peak_{name}_id", "peak")
        op.create_index(f"ix_peak_{name}", "peak", columns)
    op.drop_index("ix_peak_peak_id", "peak")
    for name in STATISTICS:
        seen = ("case_id", "position", "speed_kmh", "percentile", "peak")
        columns = [name, "id", *(each for each in seen if each != name)]
        op.drop_index(f"ix_peak_by_{name}", "peak")
        op.create_index(f"ix_peak_{name}", "peak", columns)
        op.create_index(f"ix_peak_by_{name}", "peak", ["quantity", *columns])


def downgrade() -> None:
    """Take back."""
    for name in STATISTICS:
        op.drop_index(f"ix_peak_{name}", "peak")
        op.drop_index(f"ix_peak_by_{name}", "peak")
        op.create_index(f"ix_peak_by_{name}", "peak", ["quantity", name, "id", "speed_kmh", "percentile"])
    for name in NAMES:
        op.drop_index(f"ix_peak_{name}", "peak")
        op.create_index(f"ix_peak_{name}_id", "peak", [name, "id"])
    op.create_index("ix_peak_peak_id", "peak", ["peak", "id"])
