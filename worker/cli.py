"""``tracksweep``: one program for people and scripts. Exit codes: 0 done, 1 the work failed, 2 wrong usage."""

import os

import typer

from app.cli import service

program = typer.Typer(
    name="tracksweep",
    help="Parametric studies of a high-speed train on slab track.",
    no_args_is_help=True,
    rich_markup_mode=None,  # its import takes longer than the rest
    pretty_exceptions_enable=False,
)
program.add_typer(service)


@program.command()
def worker() -> None:
    """Run one worker: a process that computes one batch of cases after another, on one core."""
    for library in ("OMP", "OPENBLAS", "MKL", "NUMBA"):  # two workers with all threads each take many times as long
        os.environ.setdefault(f"{library}_NUM_THREADS", "1")
    from worker.celery import app

    name = f"worker-{os.getpid()}@%h"
    app.worker_main(
        ["worker", "--pool", "solo", "--hostname", name, "--loglevel", "INFO", "--without-gossip", "--without-mingle"]
    )


def main() -> None:
    """Entry point."""
    program()


if __name__ == "__main__":
    main()
