"""The HTTP application: ``uvicorn app.main:create_app --factory``."""

import threading
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress
from importlib.metadata import version

import structlog
from fastapi import Depends, FastAPI
from fastapi.routing import iter_route_contexts
from sqlalchemy.exc import SQLAlchemyError

from app import log, openapi, problems
from app.access import keys
from app.access.caller import identify, keys_required
from app.access.rates import Rates
from app.access.routes import router as shares
from app.analysis.routes import router as analysis
from app.cases.routes import router as cases
from app.catalogue.routes import router as catalogue
from app.context import Context
from app.db.session import Database
from app.histories.routes import router as histories
from app.metrics.http import Requests, RequestsMiddleware
from app.metrics.routes import router as operations
from app.pages import add_pages
from app.peaks.routes import of_cases
from app.peaks.routes import router as peaks
from app.previews.routes import router as previews
from app.profiles.routes import router as profiles
from app.queue import Doorbell
from app.requests import HeadMiddleware, RequestIdMiddleware
from app.settings import Settings
from app.storage import HistoryStore
from app.studies.routes import estimates
from app.studies.routes import router as studies
from app.verifications.routes import router as verifications
from app.web.routes import add_web
from app.workload.routes import router as workload


def _warn_without_keys(context: Context) -> None:
    if not keys_required(context.settings):
        return
    with suppress(SQLAlchemyError), context.database.read() as session:  # whoever asks is told that it is away
        if not keys.any_valid(session):
            hint = "tracksweep keys create NAME --scope admin"
            structlog.get_logger().warning("every request needs an API key, and there is none", create_one=hint)


def create_app(settings: Settings | None = None) -> FastAPI:
    """The application.

    Parameters
    ----------
    settings : Settings, optional
        From the environment when not given. The database must have been migrated.
    """
    log.configure()
    settings = settings or Settings()
    context = Context(
        settings=settings,
        database=Database(settings.resolved_database_url),
        doorbell=Doorbell(settings),
        histories=HistoryStore(settings.resolved_storage_url),
    )

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        _warn_without_keys(context)
        yield
        context.database.close()

    app = FastAPI(
        docs_url=None,  # app.pages has them
        redoc_url=None,
        title="TrackSweep",
        version=version("tracksweep"),
        description="Parametric studies of a high-speed train on ballastless slab track.",
        lifespan=lifespan,
        generate_unique_id_function=lambda route: route.name,
        redirect_slashes=False,
    )
    app.state.context = context
    app.state.rates = Rates(settings)
    app.state.watchers = threading.BoundedSemaphore(settings.max_watchers)
    app.state.requests = Requests()
    app.add_middleware(RequestsMiddleware, requests=app.state.requests)
    app.add_middleware(HeadMiddleware)
    app.add_middleware(RequestIdMiddleware)
    problems.install(app)
    add_pages(app)
    add_web(app)
    app.include_router(operations)
    for router in (
        studies,
        shares,
        estimates,
        cases,
        histories,
        peaks,
        of_cases,
        analysis,
        catalogue,
        verifications,
        profiles,
        previews,
        workload,
    ):
        app.include_router(router, dependencies=[Depends(identify)])
    list(iter_route_contexts(app.routes))  # FastAPI prepares routes when first asked for: by now, not by a request
    app.openapi = lambda: openapi.document(app)  # type: ignore[method-assign]  # FastAPI's documented way
    return app
