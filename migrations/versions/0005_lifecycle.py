"""Turns in the queue, the work of a case, and verifications."""

import sqlalchemy as sa
from alembic import op

revision = "0005"
down_revision = "0003"
branch_labels = None
depends_on = None

BIG_KEY = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    """Apply."""
    op.add_column("case", sa.Column("turn", BIG_KEY, nullable=False, server_default="0"))
    op.add_column("case", sa.Column("work", sa.Double(), nullable=True))
    op.drop_index("ix_case_queue", "case")
    op.create_index("ix_case_queue", "case", ["state", sa.literal_column("priority DESC"), "turn", "id"])
    op.create_table(
        "verification",
        sa.Column("id", BIG_KEY, nullable=False),
        sa.Column("case_id", BIG_KEY, nullable=False),
        sa.Column("state", sa.String(length=16), nullable=False),
        sa.Column("attempt", sa.Integer(), nullable=False),
        sa.Column("lease_token", sa.String(length=32), nullable=True),
        sa.Column("lease_expires", sa.Double(), nullable=True),
        sa.Column("requested_at", sa.Double(), nullable=False),
        sa.Column("finished_at", sa.Double(), nullable=True),
        sa.Column("solver_version", sa.String(), nullable=True),
        sa.Column("outcome", sa.String(length=16), nullable=True),
        sa.Column("differences", sa.JSON(none_as_null=True), nullable=True),
        sa.Column("error", sa.JSON(none_as_null=True), nullable=True),
        sa.ForeignKeyConstraint(
            ["case_id"], ["case.id"], name=op.f("fk_verification_case_id_case"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_verification")),
    )
    op.create_index("ix_verification_case_id_id", "verification", ["case_id", "id"])
    op.create_index("ix_verification_state_id", "verification", ["state", "id"])


def downgrade() -> None:
    """Take back."""
    op.drop_table("verification")
    op.drop_index("ix_case_queue", "case")
    op.create_index("ix_case_queue", "case", ["state", sa.literal_column("priority DESC"), "id"])
    op.drop_column("case", "work")
    op.drop_column("case", "turn")
