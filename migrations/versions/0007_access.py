"""API keys, who owns a study or profile and sees it, and to whom a case is charged."""

import sqlalchemy as sa
from alembic import op

revision = "0007"
down_revision = "0004"
branch_labels = None
depends_on = None

BIG_KEY = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    """Apply."""
    op.create_table(
        "api_key",
        sa.Column("id", BIG_KEY, nullable=False),
        sa.Column("name", sa.String(), nullable=False),
        sa.Column("scope", sa.String(length=16), nullable=False),
        sa.Column("hash", sa.String(length=64), nullable=False),
        sa.Column("max_queued_cases", sa.Integer(), nullable=True),
        sa.Column("cpu_s_per_day", sa.Double(), nullable=True),
        sa.Column("created_at", sa.Double(), nullable=False),
        sa.Column("revoked_at", sa.Double(), nullable=True),
        sa.Column("last_used_at", sa.Double(), nullable=True),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_api_key")),
        sa.UniqueConstraint("name", name=op.f("uq_api_key_name")),
    )
    with op.batch_alter_table("study") as study:
        study.add_column(sa.Column("owner_id", BIG_KEY, nullable=True))
        study.add_column(sa.Column("end_turn", BIG_KEY, nullable=False, server_default="0"))
        study.create_foreign_key(op.f("fk_study_owner_id_api_key"), "api_key", ["owner_id"], ["id"])
        study.create_index("ix_study_owner_id", ["owner_id"])
    op.create_table(
        "study_share",
        sa.Column("study_id", sa.String(length=32), nullable=False),
        sa.Column("key_id", BIG_KEY, nullable=False),
        sa.ForeignKeyConstraint(["key_id"], ["api_key.id"], name=op.f("fk_study_share_key_id_api_key")),
        sa.ForeignKeyConstraint(
            ["study_id"], ["study.id"], name=op.f("fk_study_share_study_id_study"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("study_id", "key_id", name=op.f("pk_study_share")),
    )
    op.create_index("ix_study_share_key_id", "study_share", ["key_id"])
    op.create_table(
        "profile_key",
        sa.Column("profile_id", sa.String(length=64), nullable=False),
        sa.Column("key_id", BIG_KEY, nullable=False),
        sa.ForeignKeyConstraint(["key_id"], ["api_key.id"], name=op.f("fk_profile_key_key_id_api_key")),
        sa.ForeignKeyConstraint(
            ["profile_id"], ["profile.id"], name=op.f("fk_profile_key_profile_id_profile"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("profile_id", "key_id", name=op.f("pk_profile_key")),
    )
    op.create_index("ix_profile_key_key_id", "profile_key", ["key_id"])
    op.add_column("case", sa.Column("charged_to", BIG_KEY, nullable=True))
    op.create_index("ix_case_charged", "case", ["charged_to", "finished_at"])


def downgrade() -> None:
    """Take back."""
    op.drop_index("ix_case_charged", "case")
    op.drop_column("case", "charged_to")
    op.drop_table("profile_key")
    op.drop_table("study_share")
    with op.batch_alter_table("study") as study:
        study.drop_index("ix_study_owner_id")
        study.drop_constraint("fk_study_owner_id_api_key", type_="foreignkey")
        study.drop_column("end_turn")
        study.drop_column("owner_id")
    op.drop_table("api_key")
