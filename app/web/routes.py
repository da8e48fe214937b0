"""The page over HTTP. It holds no data: its scripts ask the API as any client does, with a key where one is needed.

Every address in it is relative, so that a proxy may add a path before.
"""

import hashlib
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import FileResponse, HTMLResponse
from jinja2 import Environment, PackageLoader, StrictUndefined

from app.pages import add

STATIC = Path(__file__).parent / "static"
POLICY = "; ".join(
    [
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' data:",
        "connect-src 'self'",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    ]
)
TEMPLATES = Environment(loader=PackageLoader("app.web"), autoescape=True, undefined=StrictUndefined)
FOR_EVER = "public, max-age=31536000, immutable"
HEADERS = {"Cache-Control": "no-cache", "Content-Security-Policy": POLICY}
PAGES = {
    "/": "studies",
    "/studies/new": "new",  # before the next, which it would be taken for
    "/studies/{study_id}": "study",
    "/cases/{case_id}": "case",
    "/compare": "compare",
    "/queue": "queue",
}


def add_web(app: FastAPI) -> None:
    """Serve the page, made once, and its files, below an address that is another one when they are."""
    files = sorted(file for file in STATIC.rglob("*") if file.is_file())
    static = f"static/{_digest(files)}"
    for file in files:
        address = f"/{static}/{file.relative_to(STATIC).as_posix()}"
        add(app, address, partial(FileResponse, file, headers={"Cache-Control": FOR_EVER}))
    for path, name in PAGES.items():
        root = "../" * (path.count("/") - 1)
        html = TEMPLATES.get_template(f"{name}.html").render(page=name, root=root, static=f"{root}{static}")
        add(app, path, partial(HTMLResponse, html, headers=HEADERS))


def _digest(files: Iterable[Path]) -> str:
    found = hashlib.sha256()
    for file in files:
        found.update(file.name.encode() + file.read_bytes())
    return found.hexdigest()[:16]
