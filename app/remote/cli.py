"""Commands of the program that talk to a running service."""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from app.cli import load_settings

if TYPE_CHECKING:
    from app.settings import Settings
    from tracksweep_client import Service
    from tracksweep_client.generated.models import StudyDetail

remote = typer.Typer()

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]
StudyId = Annotated[str, typer.Argument(metavar="ID")]


def service_url(settings: "Settings") -> str:
    """The service that is named by the settings or else serves the data folder."""
    if settings.url:
        return settings.url
    try:
        return str(json.loads((settings.data_dir / "serve.json").read_text())["url"])
    except (OSError, ValueError, KeyError):
        return f"http://{settings.host}:{settings.port}"


@contextmanager
def connected() -> Iterator["Service"]:
    """The service of the settings; its problems are printed and end the program."""
    import httpx

    from app.console import FAILED, WRONG_USAGE, fail
    from tracksweep_client import ProblemError, Service

    url = service_url(load_settings())
    try:
        with Service(url) as service:
            yield service
    except ProblemError as problem:
        fail(problem, FAILED if problem.status >= 500 else WRONG_USAGE)
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
        out.print_json(data=stored.to_dict())
    else:
        print(stored.id)


@remote.command()
def watch(study_id: StudyId, as_json: AsJson = False) -> None:
    """Follow a study until it has ended. Exit code 1 unless all of its cases succeeded."""
    from app.console import DONE, FAILED, out

    with connected() as service:
        study = service.wait(study_id)
    if as_json:
        out.print_json(data=study.to_dict())
    raise typer.Exit(DONE if study.state == "succeeded" else FAILED)


@remote.command()
def cancel(study_id: StudyId, as_json: AsJson = False) -> None:
    """Cancel what is left of a study."""
    with connected() as service:
        _print_state(service.cancel(study_id), as_json)


@remote.command()
def retry(study_id: StudyId, as_json: AsJson = False) -> None:
    """Queue the failed and cancelled cases of a study once more."""
    with connected() as service:
        _print_state(service.retry(study_id), as_json)


@remote.command()
def peaks(
    *,
    study: Annotated[str | None, typer.Option(help="Only of this study.", metavar="ID")] = None,
    quantity: Annotated[str | None, typer.Option(help="Only this quantity, such as wheel_rail_force.")] = None,
    position: Annotated[str | None, typer.Option(help="Only at this position, such as wheelset_1.")] = None,
    slab: Annotated[str | None, typer.Option(help="Only on this slab.")] = None,
    irregularity: Annotated[str | None, typer.Option(help="Only over this kind of irregularity.")] = None,
    spectrum: Annotated[str | None, typer.Option(help="Only of this spectrum.")] = None,
    speed_kmh_min: Annotated[float | None, typer.Option(help="Only from this speed on.")] = None,
    speed_kmh_max: Annotated[float | None, typer.Option(help="Only up to this speed.")] = None,
    percentile: Annotated[float | None, typer.Option(help="Only of this percentile.")] = None,
    wavelength_min_m: Annotated[float | None, typer.Option(help="Only of the band that begins here.")] = None,
    wavelength_max_m: Annotated[float | None, typer.Option(help="Only of the band that ends here.")] = None,
    wavelength_m: Annotated[float | None, typer.Option(help="Only of harmonic waves of this length.")] = None,
    value_min: Annotated[float | None, typer.Option(help="Only peaks of at least this, in SI.")] = None,
    value_max: Annotated[float | None, typer.Option(help="Only peaks of at most this, in SI.")] = None,
    parameter: Annotated[
        list[str] | None,
        typer.Option(help="Tell this parameter of every case, too, by its path; those that a study varies by default."),
    ] = None,
    sort: Annotated[str | None, typer.Option(help="A column; with a minus sign, from large to small.")] = None,
    csv: Annotated[Path | None, typer.Option(metavar="FILE", help="Write them to this file instead.")] = None,
    parquet: Annotated[Path | None, typer.Option(metavar="FILE", help="The same as Parquet.")] = None,
    as_json: AsJson = False,
) -> None:
    """Print the peaks of all studies, or of those cases that pass the filters."""
    filters = {name: value for name, value in locals().items() if name not in ("csv", "parquet", "as_json")}
    filters["study_id"] = filters.pop("study")
    given = {name: value for name, value in filters.items() if value not in (None, [])}
    if csv is None and parquet is None:
        _print_peaks(given, as_json)
    else:
        _save_peaks(given, csv, parquet)


def _print_peaks(filters: dict[str, Any], as_json: bool) -> None:
    from app.console import out
    from app.remote.tables import table

    with connected() as service:
        rows = [row.to_dict() for row in service.peaks(**filters)]
    if as_json:
        out.print_json(data=rows)
    else:
        out.print(table(rows))


def _save_peaks(filters: dict[str, Any], csv: Path | None, parquet: Path | None) -> None:
    from app.console import WRONG_USAGE, fail

    with connected() as service:
        try:
            if csv is not None:
                service.save_peaks(csv, "csv", **filters)
            if parquet is not None:
                service.save_peaks(parquet, "parquet", **filters)
        except OSError as error:
            fail(f"Cannot write {error.filename}: {error.strerror}.", WRONG_USAGE)


def _print_state(study: "StudyDetail", as_json: bool) -> None:
    from app.console import out

    if as_json:
        out.print_json(data=study.to_dict())
    else:
        print(study.state)
