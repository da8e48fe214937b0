"""Peaks found in any order, and beside each the conditions it grows with."""

import sqlalchemy as sa
from alembic import op

revision = "0006"
down_revision = "0005"
branch_labels = None
depends_on = None

STATISTICS = ("peak", "maximum", "minimum", "mean", "std", "rms", "time_s", "track_position_m")
CONDITIONS = (
    *("speed_kmh", "slab", "irregularity", "spectrum", "percentile", "wavelength_min_m", "wavelength_max_m"),
    *("seed", "realisation", "wavelength_m", "amplitude_mm", "solver_version"),
)


def upgrade() -> None:
    """Apply."""
    with op.batch_alter_table("peak") as peak:
        peak.drop_index("ix_peak_quantity_peak")
        peak.add_column(sa.Column("speed_kmh", sa.Double(), nullable=True))
        peak.add_column(sa.Column("percentile", sa.Double(), nullable=True))
    op.execute(
        """
        UPDATE peak SET speed_kmh = (SELECT speed_kmh FROM "case" WHERE "case".id = case_id),
                        percentile = (SELECT percentile FROM "case" WHERE "case".id = case_id)
        """
    )
    with op.batch_alter_table("peak") as peak:
        peak.alter_column("speed_kmh", nullable=False)
    for name in ("quantity", "position", "unit", "peak"):
        op.create_index(f"ix_peak_{name}_id", "peak", [name, "id"])
    for name in STATISTICS:
        op.create_index(f"ix_peak_by_{name}", "peak", ["quantity", name, "id", "speed_kmh", "percentile"])
    for name in CONDITIONS:
        op.create_index(f"ix_case_{name}_id", "case", [name, "id"])


def downgrade() -> None:
    """Take back."""
    for name in CONDITIONS:
        op.drop_index(f"ix_case_{name}_id", "case")
    for name in ("quantity", "position", "unit", "peak"):
        op.drop_index(f"ix_peak_{name}_id", "peak")
    for name in STATISTICS:
        op.drop_index(f"ix_peak_by_{name}", "peak")
    with op.batch_alter_table("peak") as peak:
        peak.drop_column("percentile")
        peak.drop_column("speed_kmh")
    op.create_index("ix_peak_quantity_peak", "peak", ["quantity", "peak"])
