"""What is counted for operators, and which request created a study."""

import sqlalchemy as sa
from alembic import op

revision = "0010"
down_revision = "0009"
branch_labels = None
depends_on = None


def upgrade() -> None:
    """Apply."""
    op.create_table(
        "tally",
        sa.Column("name", sa.String(length=32), nullable=False),
        sa.Column("label", sa.String(length=32), nullable=False),
        sa.Column("value", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("name", "label", name=op.f("pk_tally")),
    )
    op.add_column("study", sa.Column("request_id", sa.String(length=32), nullable=True))


def downgrade() -> None:
    """Take back."""
    op.drop_column("study", "request_id")
    op.drop_table("tally")
