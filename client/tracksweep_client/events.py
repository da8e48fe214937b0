"""Server-Sent Events, which the generated client cannot read."""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, kw_only=True)
class Event:
    """Something that happened to a study.

    Attributes
    ----------
    kind : str
        ``progress``, ``state``, ``case`` or ``done``.
    data : dict
        What the service says of it.
    id : int, optional
        By which watching goes on after this event; ``progress`` has none.
    """

    kind: str
    data: dict[str, Any]
    id: int | None


def read(lines: Iterable[str]) -> Iterator[Event]:
    """The events of a stream."""
    fields: dict[str, str] = {}
    for line in lines:
        name, _, value = line.partition(":")
        if name:
            value = value.removeprefix(" ")
            fields[name] = f"{fields[name]}\n{value}" if name == "data" and name in fields else value
        elif not line:
            if "data" in fields:
                number = int(fields["id"]) if fields.get("id") else None
                yield Event(kind=fields.get("event", "message"), data=json.loads(fields["data"]), id=number)
            fields = {}
