"""Whom a request comes from, found before anything else is done with it."""

from dataclasses import dataclass
from ipaddress import ip_address
from typing import Annotated

from anyio import to_thread
from fastapi import Depends, Request
from structlog.contextvars import bind_contextvars

from app.access import keys
from app.access.rates import Policy, Rate, Rates
from app.context import Context, ContextDep
from app.db.models import Scope
from app.problems import Problem
from app.settings import Settings

CHALLENGE = {"WWW-Authenticate": 'Bearer realm="tracksweep"'}


@dataclass(frozen=True, kw_only=True)
class Caller:
    """Who sends a request. Without arguments: anybody, where no key is required, who may do everything."""

    key_id: int | None = None
    name: str | None = None
    scope: Scope = "admin"
    max_queued_cases: int | None = None
    cpu_s_per_day: float | None = None

    @property
    def is_admin(self) -> bool:
        """Whether there is nothing this caller may not see or do."""
        return self.scope == "admin"


ANYBODY = Caller()


async def identify(request: Request, context: ContextDep) -> Caller:
    """The caller; the request is counted, once however often this is asked.

    Raises
    ------
    Problem
        401 without a valid key where one is required, and with an invalid one anywhere; 403 if the key's scope does not
        suffice or, without a key, a page of another site sent the request; 429 if there were too many requests.
    """
    bind_contextvars(**request.path_params)  # the log tells what a request is about
    if not hasattr(request.state, "caller"):
        request.state.caller = await _identify(request, context)
    caller: Caller = request.state.caller
    return caller


async def _identify(request: Request, context: Context) -> Caller:
    policy: Policy = "reads" if request.method == "GET" else "writes"
    caller = ANYBODY if _sent_key(request) is None else await to_thread.run_sync(sender, context, request)
    address = request.client.host if request.client else ""
    who = address if caller is None or caller.key_id is None else f"key {caller.key_id}"
    if (rate := await _count(request.app.state.rates, policy, who)) is not None:
        request.state.headers |= rate.headers()
        rate.check()
    if caller is None:
        headers = {"WWW-Authenticate": f'{CHALLENGE["WWW-Authenticate"]}, error="invalid_token"'}
        raise Problem(401, "The key is unknown or was revoked.", code="key-invalid", headers=headers)
    if caller is ANYBODY and keys_required(context.settings, request):
        detail = "Send an API key: Authorization: Bearer ts_…"
        raise Problem(401, detail, code="key-missing", headers=CHALLENGE)
    if caller is ANYBODY and context.settings.require_keys == "auto" and not _is_local(request):
        raise forbidden("Without a key, only programs and pages of this machine are answered.", "cross-site")
    if policy == "writes" and caller.scope == "read":
        raise forbidden("The key may only read.", "scope-insufficient")
    return caller


CallerDep = Annotated[Caller, Depends(identify)]


def forbidden(detail: str, code: str) -> Problem:
    """A 403."""
    return Problem(403, detail, code=code)


def keys_required(settings: Settings, request: Request | None = None) -> bool:
    """Whether a request must have a key. Where that depends on who can reach the service, both what it was told to
    listen on and what the request came in by must be the loopback: another server may run the application.
    """
    if settings.require_keys != "auto":
        return settings.require_keys == "always"
    hosts = [settings.host]
    if request is not None and (server := request.scope.get("server")) is not None:
        hosts.append(server[0])
    return not all(map(_is_loopback, hosts))


def _is_local(request: Request) -> bool:
    """Whether the request was meant for this machine. Browsers let any page send requests to the loopback. They say
    which page (Origin); and a page whose own name leads to the loopback still has that name in the address (Host).
    """
    host = request.headers.get("host", request.url.netloc)  # of an unreadable one the URL says nothing
    origin = request.headers.get("origin", f"http://{host}")
    return _is_loopback(request.url.hostname or "") and request.url.netloc == host == origin.partition("://")[2]


def _is_loopback(host: str) -> bool:
    try:
        return host == "localhost" or ip_address(host).is_loopback
    except ValueError:
        return False


def _sent_key(request: Request) -> str | None:
    kind, _, value = request.headers.get("authorization", "").partition(" ")
    return value.strip() if kind.lower() == "bearer" else None


def sender(context: Context, request: Request) -> Caller | None:
    """Who sends a request; None if the key it is sent with is not valid, or not any more."""
    if (sent := _sent_key(request)) is None:
        return ANYBODY
    if (key := keys.authenticate(context.database, sent)) is None:
        return None
    return Caller(
        key_id=key.id,
        name=key.name,
        scope=key.scope,
        max_queued_cases=key.max_queued_cases,
        cpu_s_per_day=key.cpu_s_per_day,
    )


async def _count(rates: Rates, policy: Policy, who: str) -> Rate | None:
    return await to_thread.run_sync(rates.hit, policy, who) if rates.waits else rates.hit(policy, who)
