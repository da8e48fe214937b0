"""The pages at /docs and /redoc: they need nothing from elsewhere, and browsers are told to load nothing else."""

import hashlib
import re
from base64 import b64encode
from collections.abc import Callable
from functools import partial
from importlib.resources import files
from pathlib import Path

from fastapi import FastAPI
from fastapi.openapi.docs import get_redoc_html, get_swagger_ui_html
from fastapi.responses import FileResponse, HTMLResponse, Response

# With every answer. What is no page may be shown nowhere and load nothing, should a browser take it for one.
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; frame-ancestors 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
}
ASSETS = "docs-assets"  # relative, so that a proxy may add a path before


def add_pages(app: FastAPI) -> None:
    """Serve the pages and, each by its name, the files that they need."""
    for asset in Path(str(files("fastapi_offline"))).glob("static/*"):
        add(app, f"/{ASSETS}/{asset.name}", partial(FileResponse, asset))
    icon, title = f"{ASSETS}/favicon.png", app.title
    swagger = get_swagger_ui_html(
        openapi_url="openapi.json",
        title=title,
        swagger_js_url=f"{ASSETS}/swagger-ui-bundle.js",
        swagger_css_url=f"{ASSETS}/swagger-ui.css",
        swagger_favicon_url=icon,
    )
    redoc = get_redoc_html(
        openapi_url="openapi.json",
        title=title,
        redoc_js_url=f"{ASSETS}/redoc.standalone.js",
        redoc_favicon_url=icon,
        with_google_fonts=False,
    )
    for path, page in (("/docs", swagger), ("/redoc", redoc)):
        html = bytes(page.body).decode()
        add(app, path, partial(HTMLResponse, html, headers={"Content-Security-Policy": _policy(html)}))


def add(app: FastAPI, path: str, make: Callable[[], Response]) -> None:
    """Serve what a function makes, beside the API."""

    async def show() -> Response:
        return make()

    app.add_api_route(path, show, include_in_schema=False)


def _policy(html: str) -> str:
    """Scripts are the files of this service and those that stand in the page as it was made, by their hashes."""
    scripts = [f"'sha256-{_sha256(script)}'" for script in re.findall(r"<script>(.*?)</script>", html, re.DOTALL)]
    return "; ".join(
        [
            "default-src 'none'",
            " ".join(["script-src 'self'", *scripts]),
            "style-src 'self' 'unsafe-inline'",  # both pages make styles as they go, which no hash can name
            "img-src 'self' data:",
            "connect-src 'self'",
            "worker-src blob:",  # Redoc searches in one
            "base-uri 'none'",
            "form-action 'none'",
            "frame-ancestors 'none'",
        ]
    )


def _sha256(text: str) -> str:
    return b64encode(hashlib.sha256(text.encode()).digest()).decode()
