"""Commands of the program that talk to a running service."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli import load_settings

if TYPE_CHECKING:
    from app.remote.client import Service

remote = typer.Typer()

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]


@contextmanager
def connected() -> Iterator["Service"]:
    """The service of the settings; its problems are printed and end the program."""
    import httpx

    from app.console import FAILED, WRONG_USAGE, fail, fail_with_problems
    from app.remote.client import ProblemError, Service, service_url

    url = service_url(load_settings())
    try:
        with Service(url) as service:
            yield service
    except ProblemError as problem:
        fail_with_problems(str(problem), problem.fields, FAILED if problem.status >= 500 else WRONG_USAGE)
    except (httpx.HTTPError, httpx.InvalidURL) as error:
        fail(f"No answer from {url} ({error}). `tracksweep serve` starts a service.", FAILED)


@remote.command()
def submit(
    study: Annotated[Path, typer.Argument(metavar="STUDY.json", help="A study, as POST /v1/studies takes it.")],
    as_json: AsJson = False,
) -> None:
    """Submit a study and print its id."""
    from app.console import WRONG_USAGE, fail, out, read_file

    try:
        body = json.loads(read_file(study))
    except ValueError as error:
        fail(f"{study} is not JSON: {error}.", WRONG_USAGE)
    with connected() as service:
        stored = service.submit(body)
    if as_json:
        out.print_json(data=stored)
    else:
        print(stored["id"])


@remote.command()
def watch(study_id: Annotated[str, typer.Argument(metavar="ID")], as_json: AsJson = False) -> None:
    """Follow a study until it has ended. Exit code 1 unless all of its cases succeeded."""
    from app.console import DONE, FAILED, out
    from app.remote.progress import follow

    with connected() as service:
        study = follow(service.watch(study_id))
    if as_json:
        out.print_json(data=study)
    raise typer.Exit(DONE if study["state"] == "succeeded" else FAILED)


@remote.command()
def peaks(
    *,
    study: Annotated[str | None, typer.Option(help="Only of this study.", metavar="ID")] = None,
    quantity: Annotated[str | None, typer.Option(help="Only this quantity, such as wheel_rail_force.")] = None,
    slab: Annotated[str | None, typer.Option(help="Only on this slab.")] = None,
    speed_kmh_min: Annotated[float | None, typer.Option(help="Only from this speed on.")] = None,
    speed_kmh_max: Annotated[float | None, typer.Option(help="Only up to this speed.")] = None,
    csv: Annotated[Path | None, typer.Option(metavar="FILE", help="Write them to this file instead.")] = None,
    as_json: AsJson = False,
) -> None:
    """Print the peaks of all studies, or of those cases that pass the filters."""
    from app.console import WRONG_USAGE, fail, out
    from app.remote.tables import table, write_csv

    with connected() as service:
        rows = list(
            service.peaks(
                study_id=study, quantity=quantity, slab=slab, speed_kmh_min=speed_kmh_min, speed_kmh_max=speed_kmh_max
            )
        )
    if csv is not None:
        try:
            write_csv(csv, rows)
        except OSError as error:
            fail(f"Cannot write {csv}: {error.strerror}.", WRONG_USAGE)
    elif as_json:
        out.print_json(data=rows)
    else:
        out.print(table(rows))
