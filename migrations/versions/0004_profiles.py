"""Measured profiles, and which studies use them."""

import sqlalchemy as sa
from alembic import op

revision = "0004"
down_revision = "0006"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Apply."""
    op.create_table(
        "profile",
        sa.Column("id", sa.String(length=64), nullable=False),
        sa.Column("samples", sa.LargeBinary(), nullable=False),
        sa.Column("points", sa.Integer(), nullable=False),
        *(
            sa.Column(name, sa.Double(), nullable=False)
            for name in ("start_m", "end_m", "wavelength_min_m", "wavelength_max_m", "lowest_mm", "highest_mm")
        ),
        sa.Column("created_at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_profile")),
    )
    op.create_index("ix_profile_created_at", "profile", ["created_at"])
    op.create_table(
        "study_profile",
        sa.Column("study_id", sa.String(length=32), nullable=False),
        sa.Column("profile_id", sa.String(length=64), nullable=False),
        sa.ForeignKeyConstraint(["profile_id"], ["profile.id"], name=op.f("fk_study_profile_profile_id_profile")),
        sa.ForeignKeyConstraint(
            ["study_id"], ["study.id"], name=op.f("fk_study_profile_study_id_study"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("study_id", "profile_id", name=op.f("pk_study_profile")),
    )
    op.create_index("ix_study_profile_profile_id", "study_profile", ["profile_id"])


def downgrade() -> None:
    """Take back."""
    op.drop_table("study_profile")
    op.drop_table("profile")
