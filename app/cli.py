"""Commands of the program that run the service or its parts. What they need is imported when they run."""

import os
import socket
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from app.settings import Settings

service = typer.Typer()


@service.command()
def serve(
    data: Annotated[Path | None, typer.Option(help="Folder of the database, broker and histories.")] = None,
    host: Annotated[str | None, typer.Option(help="Address to listen on.")] = None,
    port: Annotated[int | None, typer.Option(help="Port to listen on; 0 for any free one.")] = None,
    workers: Annotated[int | None, typer.Option(help="Worker processes; each computes on one core.")] = None,
) -> None:
    """Run the whole service: database, broker, API and workers. Ctrl-C stops all of it."""
    from app import log
    from app.console import FAILED, WRONG_USAGE, fail
    from app.serve.service import CannotServeError, serve
    from app.serve.supervisor import PartFailedError

    log.configure()
    try:
        serve(load_settings(data_dir=data, host=host, port=port, workers=workers))
    except CannotServeError as error:
        fail(error, WRONG_USAGE)
    except PartFailedError as error:
        fail(error, FAILED)


@service.command()
def api(
    host: Annotated[str | None, typer.Option(help="Address to listen on.")] = None,
    port: Annotated[int | None, typer.Option(help="Port to listen on; 0 for any free one.")] = None,
    fd: Annotated[int | None, typer.Option(help="File descriptor of a socket that listens already.")] = None,
) -> None:
    """Run the API alone."""
    import uvicorn
    from uvicorn.supervisors import Multiprocess

    from app.console import WRONG_USAGE, fail
    from app.metrics.together import counting_together
    from app.serve.service import CannotServeError, listen

    settings = load_settings(host=host, port=port)
    try:
        listener = listen(settings.host, settings.port) if fd is None else socket.socket(fileno=fd)
    except CannotServeError as error:
        fail(error, WRONG_USAGE)
    os.environ["TRACKSWEEP_HOST"] = listener.getsockname()[0]  # who can reach the API decides whether it asks for keys
    processes = settings.api_processes if fd is None else 1
    # A watcher's stream may stay open for hours: what is unfinished after two seconds is cut.
    config = uvicorn.Config(
        "app.main:create_app", factory=True, workers=processes, timeout_graceful_shutdown=2, access_log=False
    )
    if processes == 1:
        uvicorn.Server(config).run(sockets=[listener])
        return
    config.timeout_worker_healthcheck = 30  # slow is not dead
    with counting_together(processes):
        Multiprocess(config, [listener]).run()


@service.command()
def openapi() -> None:
    """Print the OpenAPI document of the service."""
    import json

    from app.main import create_app

    print(json.dumps(create_app(load_settings()).openapi(), indent=2))


def load_settings(**given: Any) -> "Settings":
    """Settings from the environment, replaced by the options that were given; wrong ones end the program."""
    from pydantic import ValidationError

    from app.console import fail_with_problems
    from app.settings import Settings

    try:
        return Settings(**{name: value for name, value in given.items() if value is not None})
    except ValidationError as error:
        problems = [(".".join(map(str, each["loc"])), each["msg"]) for each in error.errors()]
        fail_with_problems("These settings are wrong:", problems)
