"""The page over HTTP. It holds no data: its scripts ask the API as any client does, with a key where one is needed.

Every address in it is relative, so that a proxy may add a path before.
"""

import hashlib
import re
from collections.abc import Mapping
from functools import partial
from mimetypes import guess_type
from pathlib import Path

from fastapi import FastAPI
from fastapi.responses import HTMLResponse, Response
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
IMPORT = re.compile(r'^import .* from "\./(\w[\w-]*)\.js";$', re.MULTILINE)
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

    All of it is in memory: to look for a file takes several turns of a thread, and a view has twenty files.
    """
    files = {file: file.read_bytes() for file in sorted(STATIC.rglob("*")) if file.is_file()}
    static = f"static/{_digest(files)}"
    for file, content in files.items():
        address = f"/{static}/{file.relative_to(STATIC).as_posix()}"
        media_type = guess_type(file.name)[0] or "text/plain"
        add(app, address, partial(Response, content, media_type=media_type, headers={"Cache-Control": FOR_EVER}))
    for path, name in PAGES.items():
        root = "../" * (path.count("/") - 1)
        values = {"page": name, "root": root, "static": f"{root}{static}", "modules": sorted(modules(name))}
        html = TEMPLATES.get_template(f"{name}.html").render(values)
        add(app, path, partial(HTMLResponse, html, headers=HEADERS))


def modules(name: str) -> set[str]:
    """All modules that a view's module needs, itself too: a browser that is told can ask for them at once."""
    found: set[str] = set()
    ahead = {name, "page"}
    while ahead:
        found |= ahead
        scripts = ((STATIC / "js" / f"{each}.js").read_text() for each in ahead)
        ahead = {needed for script in scripts for needed in IMPORT.findall(script)} - found
    return found


def _digest(files: Mapping[Path, bytes]) -> str:
    found = hashlib.sha256()
    for file, content in files.items():
        found.update(file.name.encode() + content)
    return found.hexdigest()[:16]
