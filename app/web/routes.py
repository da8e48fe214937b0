"""The page over HTTP. It holds no data: its scripts ask the API as any client does, with a key where one is needed.

Every address in it is relative, so that a proxy may add a path before.
"""

import hashlib
from collections.abc import Mapping
from functools import partial
from mimetypes import guess_type
from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import HTMLResponse, Response
from jinja2 import Environment, PackageLoader, StrictUndefined

from app.pages import add
from app.web.scripts import needs, script

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
    """Serve the page, made once, and its files, below an address that is another one when they are.

    All of it is in memory: to look for a file takes several turns of a thread.
    """
    files = {file.relative_to(STATIC).as_posix(): file.read_bytes() for file in STATIC.rglob("*") if file.is_file()}
    files |= {f"js/{name}.js": script(name).encode() for name in PAGES.values()}
    static = f"static/{_digest(files)}"
    for file, content in files.items():
        media_type = guess_type(file)[0] or "text/plain"
        answer = partial(Response, content, media_type=media_type, headers={"Cache-Control": FOR_EVER})
        add(app, f"/{static}/{file}", answer)
    for path, name in PAGES.items():
        root = "../" * (path.count("/") - 1)
        values = {"page": name, "root": root, "static": f"{root}{static}", "charts": needs(name, "chart")}
        html = TEMPLATES.get_template(f"{name}.html").render(values)
        add(app, path, partial(HTMLResponse, html, headers=HEADERS))


def _digest(files: Mapping[str, bytes]) -> str:
    found = hashlib.sha256()
    for file, content in sorted(files.items()):
        found.update(file.encode() + content)
    return found.hexdigest()[:16]
