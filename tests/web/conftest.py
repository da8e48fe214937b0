"""A browser that looks at a running service, and what every test of the page asserts beside its own."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Page, sync_playwright

from tests.e2e.conftest import Served, service  # noqa: F401 - a fixture
from tests.web.browser import FLAGS, find

AXE = (Path(__file__).parent / "vendor/axe.min.js").read_text()
SERIOUS = {"serious", "critical"}
WIDE, NARROW = 1280, 360

Open = Callable[..., Any]


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Not longer than a module: while it is there, no other test of the process can run a loop of its own."""
    executable = find()
    assert executable is not None, "no Chromium: run `python -m tests.web.browser`, as `make test` does"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=FLAGS)
        yield browser
        browser.close()


@contextmanager
def opened(browser: Browser, served: Served, **options: Any) -> Iterator[Page]:
    """A tab, in which nothing may go wrong and from which nothing is asked of anybody else."""
    wrong: list[str] = []
    host = urlsplit(str(served.http.base_url)).netloc

    def hear(message: ConsoleMessage) -> None:
        refused = message.text.startswith("Failed to load resource") and "status of 4" in message.text
        if message.type in ("error", "warning") and not refused:
            wrong.append(f"console: {message.text}")

    def ask(url: str) -> None:
        if not url.startswith(("data:", "blob:")) and urlsplit(url).netloc != host:
            wrong.append(f"another host: {url}")

    context = browser.new_context(
        base_url=str(served.http.base_url), viewport={"width": WIDE, "height": 900}, **options
    )
    page = context.new_page()
    page.set_default_timeout(20_000)
    page.on("console", hear)
    page.on("pageerror", lambda error: wrong.append(f"script: {error}"))
    page.on("request", lambda request: ask(request.url))
    yield page
    context.close()
    assert not wrong


@pytest.fixture
def page(browser: Browser, service: Served) -> Iterator[Page]:  # noqa: F811
    with opened(browser, service) as page:
        yield page


def check_accessibility(page: Page) -> None:
    """Nothing serious by axe-core's rules, light and dark, on a telephone and on a desk; nothing beside the window."""
    page.evaluate(AXE)  # past the page's policy, which lets in no script of others
    for width in (NARROW, WIDE):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"wider than {width} px"
        for scheme in ("light", "dark"):
            page.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
            found = page.evaluate("axe.run({resultTypes: ['violations']}).then((found) => found.violations)")
            told = [
                f"{each['id']}: {each['help']} {[node['target'] for node in each['nodes']][:5]}"
                for each in found
                if each["impact"] in SERIOUS
            ]
            assert not told, f"{scheme}, {width} px: {told}"
