"""``tracksweep keys``: who has a key. Works on the database itself."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from app.cli import load_settings

if TYPE_CHECKING:
    from sqlalchemy.orm import Session

    from app.db.models import ApiKey

keys = typer.Typer(help="Create, list, renew and revoke API keys.", no_args_is_help=True)

Name = Annotated[str, typer.Argument(help="Of the person or program that has the key.")]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]
INSTANTS = ("created_at", "revoked_at", "last_used_at")


@keys.command()
def create(
    name: Name,
    scope: Annotated[Literal["read", "write", "admin"], typer.Option(help="What it may do.")],
    max_queued_cases: Annotated[int | None, typer.Option(min=0, help="Cases that may be queued at a time.")] = None,
    cpu_s_per_day: Annotated[float | None, typer.Option(min=0, help="Processor time per 24 hours, s.")] = None,
    as_json: AsJson = False,
) -> None:
    """Create a key and print it, which cannot be done again."""
    from app.access import keys

    _give(lambda session: keys.create(session, name, scope, max_queued_cases, cpu_s_per_day), as_json)


@keys.command()
def renew(name: Name, as_json: AsJson = False) -> None:
    """Replace a key, be it lost or revoked, and print the new one. Its studies and limits stay."""
    from app.access import keys

    _give(lambda session: keys.renew(session, name), as_json)


@keys.command()
def revoke(name: Name, as_json: AsJson = False) -> None:
    """Void a key. Its studies stay, and a renewed key has them again."""
    from app.access import keys
    from app.console import out

    with _database() as session:
        described = _describe(keys.revoke(session, name))
    print(json.dumps(described)) if as_json else out.print(f"{name} is revoked.", highlight=False)


@keys.command("list")
def list_(as_json: AsJson = False) -> None:
    """List all keys, by name."""
    from rich.table import Table

    from app.access import keys
    from app.console import out

    with _database() as session:
        described = [_describe(key) for key in keys.find_all(session)]
    if as_json:
        print(json.dumps(described))
        return
    table = Table(*(name.replace("_", " ") for name in COLUMNS), box=None, pad_edge=False)
    for each in described:
        table.add_row(*("" if (value := each[name]) is None else str(value) for name in COLUMNS))
    out.print(table)


COLUMNS = ("name", "scope", "max_queued_cases", "cpu_s_per_day", *INSTANTS)


def _describe(key: "ApiKey") -> dict[str, Any]:
    values = {name: getattr(key, name) for name in COLUMNS}
    return values | {name: _instant(values[name]) for name in INSTANTS}


def _instant(seconds: float | None) -> str | None:
    return None if seconds is None else datetime.fromtimestamp(seconds, UTC).isoformat(timespec="seconds")


def _give(make: "Callable[[Session], tuple[ApiKey, str]]", as_json: bool) -> None:
    with _database() as session:
        key, secret = make(session)
        described = _describe(key)
    print(json.dumps(described | {"key": secret}) if as_json else secret)


@contextmanager
def _database() -> "Iterator[Session]":
    from sqlalchemy.exc import SQLAlchemyError

    from app.access.keys import KeyNameError
    from app.console import WRONG_USAGE, fail
    from app.db.session import Database

    database = Database(load_settings().resolved_database_url)
    try:
        with database.write() as session:
            yield session
    except KeyNameError as error:
        fail(error, WRONG_USAGE)
    except SQLAlchemyError as error:
        fail(f"{error}\nIf the database is new, prepare it by: tracksweep migrate")
    finally:
        database.close()
