"""Every change of state that was committed: triggers write it down in the transaction that makes it."""

from contextlib import suppress
from threading import Event, Thread
from typing import Any

from sqlalchemy import bindparam, text
from sqlalchemy.exc import SQLAlchemyError

from app.db.session import Database, create_engine_for
from tests.chaos.record import Record

COLUMNS = ("what", "study_id", "case_id", "was", "now", "attempt", "worker", "was_token", "token", "detail")
NEW = text("SELECT * FROM chaos_change WHERE n > :highest OR n IN :missing ORDER BY n").bindparams(
    bindparam("missing", expanding=True)
)

CASE = {
    "case_id": "NEW.id",
    "now": "NEW.state",
    "attempt": "NEW.attempt",
    "worker": "NEW.worker",
    "token": "NEW.lease_token",
}
LIVE = "CASE WHEN NEW.cancel_requested_at IS NULL THEN 'live' ELSE 'cancelled' END"
# What happens to which table, and what is written down of it.
TRIGGERS: list[tuple[str, str, dict[str, str]]] = [
    ("INSERT", "case", {"what": "'case'"} | CASE),
    (
        "UPDATE OF state, lease_token, finished_at",
        "case",
        {"what": "'case'", "was": "OLD.state", "was_token": "OLD.lease_token"} | CASE,
    ),
    ("DELETE", "case", {"what": "'case'", "case_id": "OLD.id", "was": "OLD.state"}),
    ("INSERT", "study", {"what": "'study'", "study_id": "NEW.id", "now": "'live'"}),
    ("UPDATE OF cancel_requested_at", "study", {"what": "'study'", "study_id": "NEW.id", "now": LIVE}),
    ("DELETE", "study", {"what": "'study'", "study_id": "OLD.id", "now": "'deleted'"}),
    ("INSERT", "study_case", {"what": "'link'", "study_id": "NEW.study_id", "case_id": "NEW.case_id"}),
    (
        "INSERT",
        "event",
        {
            "what": "'event'",
            "study_id": "NEW.study_id",
            "now": "NEW.kind",
            "attempt": "NEW.id",
            "detail": "CAST(NEW.payload AS VARCHAR)",
        },
    ),
    ("INSERT", "worker", {"what": "'sweep'", "worker": "NEW.name"}),
    ("UPDATE", "worker", {"what": "'sweep'", "worker": "NEW.name"}),
]


def install(url: str) -> None:
    """Create the table of changes and the triggers that fill it, in a migrated database."""
    engine = create_engine_for(url)
    sqlite = engine.dialect.name == "sqlite"
    number = "INTEGER PRIMARY KEY AUTOINCREMENT" if sqlite else "BIGSERIAL PRIMARY KEY"
    types = ", ".join(f"{name} {'BIGINT' if name in ('case_id', 'attempt') else 'VARCHAR'}" for name in COLUMNS)
    with engine.begin() as connection:
        connection.exec_driver_sql(f"CREATE TABLE chaos_change (n {number}, {types})")
        for k, (happening, table, values) in enumerate(TRIGGERS):
            insert = f"INSERT INTO chaos_change ({', '.join(values)}) VALUES ({', '.join(values.values())});"
            head = f'CREATE TRIGGER chaos_{k} AFTER {happening} ON "{table}" FOR EACH ROW'
            if sqlite:
                connection.exec_driver_sql(f"{head} BEGIN {insert} END")
            else:
                body = f"BEGIN {insert} RETURN NULL; END"
                function = f"CREATE FUNCTION chaos_{k}() RETURNS trigger LANGUAGE plpgsql AS $${body}$$"
                connection.exec_driver_sql(function)
                connection.exec_driver_sql(f"{head} EXECUTE FUNCTION chaos_{k}()")
    engine.dispose()


class Follower:
    """Copies changes to the record as they are committed, and knows who holds which case."""

    def __init__(self, url: str, record: Record) -> None:
        self.database = Database(url)
        self._record = record
        self._highest = 0
        self._missing: set[int] = set()  # on PostgreSQL a row may become visible after those that were numbered later
        self._over = Event()
        self._thread = Thread(target=self._run, name="follower")
        self.holders: dict[int, str] = {}  # worker by case
        self.present: set[str] = set()  # workers that ever said that they are there
        self.succeeded = 0
        self._thread.start()

    def close(self) -> None:
        """End, once everything is copied."""
        self._over.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._over.wait(0.05):
            with suppress(SQLAlchemyError):  # the database is away: there is nothing new
                self._copy()
        self._copy()

    def _copy(self) -> None:
        for row in self._new():
            self._missing.update(range(self._highest + 1, row["n"]))
            self._missing.discard(row["n"])
            self._highest = max(self._highest, row["n"])
            self._record.write("change", **{name: value for name, value in row.items() if value is not None})
            if row["what"] == "sweep":
                self.present.add(row["worker"])
            elif row["what"] == "case" and row["now"] == "running":
                self.holders[row["case_id"]] = row["worker"]
            elif row["what"] == "case":
                self.holders.pop(row["case_id"], None)
                self.succeeded += row["now"] == "succeeded"

    def _new(self) -> list[dict[str, Any]]:
        with self.database.read() as session:
            rows = session.execute(NEW, {"highest": self._highest, "missing": list(self._missing)})
            return [dict(row) for row in rows.mappings()]
