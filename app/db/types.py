"""What both databases must agree on: one clock and one kind of large key."""

from typing import Any

from sqlalchemy import BigInteger, Double, Integer, String
from sqlalchemy.ext.compiler import compiles
from sqlalchemy.sql.compiler import SQLCompiler
from sqlalchemy.sql.functions import FunctionElement

# SQLite numbers its rows by itself only in a column of exactly INTEGER.
BigKey = BigInteger().with_variant(Integer, "sqlite")

# A name out of a list of ours, ordered by its bytes: PostgreSQL would ask the rules of a language, at every comparison.
Word = String().with_variant(String(collation="C"), "postgresql")


class Clock(FunctionElement[float]):
    """Seconds since 1970 (UTC), to the millisecond, by the database's own clock.

    Every instant that is stored or compared comes from here, so that workers whose clocks differ still agree on
    whose lease has run out. Seconds as a number because adding to them means the same on every database; whole
    milliseconds because such a number survives being shown as a date and sent back.
    """

    type = Double()
    inherit_cache = True


@compiles(Clock, "sqlite")
def _clock_of_sqlite(element: Clock, compiler: SQLCompiler, **kw: Any) -> str:
    return "ROUND((julianday('now') - 2440587.5) * 86400.0, 3)"


@compiles(Clock, "postgresql")
def _clock_of_postgresql(element: Clock, compiler: SQLCompiler, **kw: Any) -> str:
    return "CAST(ROUND(EXTRACT(EPOCH FROM clock_timestamp()), 3) AS DOUBLE PRECISION)"
