"""``tracksweep``: one program for people and scripts. Exit codes: 0 done, 1 the work failed, 2 wrong usage."""

import os
from pathlib import Path
from typing import Annotated

import typer

from app.access.cli import keys
from app.cli import load_settings, service
from app.remote.cli import remote

program = typer.Typer(
    name="tracksweep",
    help="Parametric studies of a high-speed train on slab track.",
    no_args_is_help=True,
    rich_markup_mode=None,  # its import takes longer than the rest
    pretty_exceptions_enable=False,
)
program.add_typer(service)
program.add_typer(keys, name="keys")
program.add_typer(remote)


@program.command()
def solve(
    case: Annotated[Path, typer.Argument(metavar="CASE.json", help="One case: single values of what a study varies.")],
    out: Annotated[Path | None, typer.Option(metavar="FILE.npz", help="Where to keep the time histories.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Solve one case here and now, without a service, and print its peaks."""
    from worker.casefile import read_case

    checked = read_case(case)
    from worker.solve import run

    run(checked, out, as_json)


@program.command()
def verify(
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Where to write the report; docs unless --quick.")
    ] = None,
    quick: Annotated[bool, typer.Option("--quick", help="Only the checks that take seconds.")] = False,
) -> None:
    """Check the solver against answers found in other ways, and write the report."""
    from worker.verify import run

    run(out or (None if quick else Path("docs")), quick)


@program.command()
def article(
    url: Annotated[str | None, typer.Option(help="A running service; one of its own if not given.")] = None,
    out: Annotated[Path, typer.Option(metavar="DIR", help="Where to write the report.")] = Path("docs"),
    rewrite: Annotated[
        bool, typer.Option("--rewrite", help="Write the report anew from the results kept there.")
    ] = False,
) -> None:
    """Compute the article's studies by a service, and put the results beside the article's numbers."""
    from worker.article.run import run

    run(out, url, rewrite)


@program.command()
def migrate() -> None:
    """Bring the database to the schema of this release."""
    from sqlalchemy.exc import SQLAlchemyError

    import migrations
    from app.console import fail

    settings = load_settings()
    settings.data_dir.mkdir(mode=0o700, parents=True, exist_ok=True)
    try:
        migrations.upgrade(settings.resolved_database_url)
    except (SQLAlchemyError, migrations.BlockedError) as error:
        fail(error)


@program.command()
def worker() -> None:
    """Run one worker: a process that computes one batch of cases after another, on one core."""
    for library in ("OMP", "OPENBLAS", "MKL", "NUMBA"):  # two workers with all threads each take many times as long
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    from worker.celery import app

    app.worker_main(
        [
            "worker",
            "--hostname",
            f"worker-{os.getpid()}@%h",
            "--loglevel",
            "INFO",
            "--without-gossip",
            "--without-mingle",
            "--without-heartbeat",  # which would wait, and tell nobody, for a broker that is away
        ]
    )


def main() -> None:
    """Entry point."""
    program()


if __name__ == "__main__":
    main()
