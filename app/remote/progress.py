"""A study's progress: a bar where somebody watches, a line per change anywhere else."""

from collections.abc import Iterable
from datetime import UTC, datetime, timedelta

from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

from app.console import err
from app.remote.client import Json


def follow(studies: Iterable[Json]) -> Json:
    """Show the progress of one study, given as it is again and again, to its end; the study at its end."""
    last: Json = {}
    if err.is_terminal:
        columns = (BarColumn(), TaskProgressColumn(), TextColumn("{task.description}"))
        with Progress(*columns, console=err) as progress:
            bar = progress.add_task("", total=1.0)
            for last in studies:
                progress.update(bar, completed=last["progress"], description=_words(last))
    else:
        said = ""
        for last in studies:
            if (counts := _counts(last)) != said:
                err.print(f"{last['progress']:4.0%}  {_words(last)}", highlight=False)
                said = counts
    return last


def _words(study: Json) -> str:
    return f"{_counts(study)}{_time_left(study)}"


def _counts(study: Json) -> str:
    cases = study["cases"]
    parts = [f"{cases['succeeded']} of {cases['total']} cases done"]
    parts += [f"{cases[state]} {state}" for state in ("running", "failed", "cancelled") if cases[state]]
    return ", ".join([f"{study['state'].replace('_', ' ')}: {parts[0]}", *parts[1:]])


def _time_left(study: Json) -> str:
    if study["finish"] is None:
        return ""
    left = max(timedelta(0), datetime.fromisoformat(study["finish"]["expected"]) - datetime.now(UTC))
    return f", about {timedelta(seconds=round(left.total_seconds()))} left"
