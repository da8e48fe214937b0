"""What a queue holds, from its index alone."""

from typing import Any

import sqlalchemy as sa
from alembic import op

revision = "0009"
down_revision = "0008"
branch_labels = None
depends_on = None

PLACE: tuple[Any, ...] = ("state", sa.literal_column("priority DESC"), "turn", "id")


def upgrade() -> None:
    """Apply."""
    op.drop_index("ix_case_queue", "case")
    op.create_index("ix_case_queue", "case", [*PLACE, "operator_key", "work"])


def downgrade() -> None:
    """Take back."""
    op.drop_index("ix_case_queue", "case")
    op.create_index("ix_case_queue", "case", [*PLACE])
