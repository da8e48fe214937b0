"""A study's progress: a bar where somebody watches, a line per change anywhere else."""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import UTC, datetime, timedelta
from typing import Any

Show = Callable[[dict[str, Any]], None]


@contextmanager
def shown() -> Iterator[Show]:
    """A function that shows the progress it is given, on standard error. The bar needs Rich."""
    try:
        from rich.console import Console
    except ImportError:
        yield _lines()
        return
    console = Console(stderr=True)
    if not (console.is_terminal or console.is_jupyter):
        yield _lines()
        return
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

    with Progress(BarColumn(), TaskProgressColumn(), TextColumn("{task.description}"), console=console) as bars:
        bar = bars.add_task("", total=1.0)
        yield lambda study: bars.update(bar, completed=study["progress"], description=_words(study))


def _lines() -> Show:
    said = ""

    def show(study: dict[str, Any]) -> None:
        nonlocal said
        if (counts := _counts(study)) != said:
            print(f"{study['progress']:4.0%}  {_words(study)}", file=sys.stderr)
            said = counts

    return show


def _words(study: dict[str, Any]) -> str:
    return f"{_counts(study)}{_time_left(study)}"


def _counts(study: dict[str, Any]) -> str:
    cases = study["cases"]
    parts = [f"{cases['succeeded']} of {cases['total']} cases done"]
    parts += [f"{cases[state]} {state}" for state in ("running", "failed", "cancelled") if cases[state]]
    return ", ".join([f"{study['state'].replace('_', ' ')}: {parts[0]}", *parts[1:]])


def _time_left(study: dict[str, Any]) -> str:
    if study["finish"] is None:
        return ""
    left = max(timedelta(0), datetime.fromisoformat(study["finish"]["expected"]) - datetime.now(UTC))
    return f", about {timedelta(seconds=round(left.total_seconds()))} left"
