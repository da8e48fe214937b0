"""A browser that looks at a running service, and what every test of the page asserts beside its own."""

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, Page, expect, sync_playwright

from tests.e2e.conftest import Served, service  # noqa: F401 - a fixture
from tests.web.browser import FLAGS, find

AXE = (Path(__file__).parent / "vendor/axe.min.js").read_text()
SERIOUS = {"serious", "critical"}
WIDE, NARROW = 1280, 360
PATIENCE_MS = 60_000  # no test judges how fast a machine is

expect.set_options(timeout=PATIENCE_MS)


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    """Not longer than a module: while it is there, no other test of the process can run a loop of its own."""
    executable = find()
    assert executable is not None, "no Chromium: run `python -m tests.web.browser`, as `make test` does"
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=FLAGS)
        yield browser
        browser.close()


def new_context(browser: Browser, served: Served) -> BrowserContext:
    """A browser without a past, which asks one service."""
    return browser.new_context(base_url=str(served.http.base_url), viewport={"width": WIDE, "height": 900})


@pytest.fixture(scope="module")
def context(browser: Browser, service: Served) -> BrowserContext:  # noqa: F811
    """One for all tests of a module: it keeps the page's files, as readers' browsers do."""
    return new_context(browser, service)


@contextmanager
def opened(context: BrowserContext) -> Iterator[Page]:
    """A tab, in which nothing may go wrong and from which nothing is asked of anybody else."""
    wrong: list[str] = []
    hosts: set[str] = set()

    def hear(message: ConsoleMessage) -> None:
        refused = message.text.startswith("Failed to load resource") and "status of 4" in message.text
        if message.type in ("error", "warning") and not refused:
            wrong.append(f"console: {message.text}")

    def ask(url: str) -> None:
        if not url.startswith(("data:", "blob:")):
            hosts.add(urlsplit(url).netloc)

    page = context.new_page()
    page.on("console", hear)
    page.on("pageerror", lambda error: wrong.append(f"script: {error}"))
    page.on("request", lambda request: ask(request.url))
    yield page
    own = urlsplit(page.url).netloc
    page.close()
    assert not wrong
    assert hosts == {own}


@pytest.fixture
def page(context: BrowserContext) -> Iterator[Page]:
    with opened(context) as page:
        yield page


SHIFTED = """new Promise((done) => {
  let sum = 0;
  const add = (list) => list.getEntries().forEach(({ value }) => (sum += value));
  new PerformanceObserver(add).observe({ type: "layout-shift", buffered: true });
  setTimeout(() => done(sum), 200);
})"""


# Charts hear how wide they may be while a frame is made, and are that wide in the next.
A_FRAME = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"


def check_stillness(page: Page, path: str, sign: str) -> None:
    """While a view is filled, hardly anything moves, on a telephone or on a desk."""
    for width in (WIDE, NARROW):
        page.set_viewport_size({"width": width, "height": 800})
        page.goto(path)
        expect(page.locator(sign).first).to_be_visible()
        page.wait_for_load_state("networkidle")
        assert page.evaluate(SHIFTED) < 0.02


def check_accessibility(page: Page) -> None:
    """Nothing serious by axe-core's rules, light and dark, on a telephone and on a desk; nothing beside the window."""
    page.evaluate(AXE)  # past the page's policy, which lets in no script of others
    for width, scheme in product((NARROW, WIDE), ("light", "dark")):
        page.set_viewport_size({"width": width, "height": 900})
        page.emulate_media(color_scheme=scheme)  # type: ignore[arg-type]
        page.evaluate(A_FRAME)
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), f"wider than {width} px"
        # Without "preload", axe does not fetch the style sheets once more, for rules that are off.
        found = page.evaluate("axe.run({resultTypes: ['violations'], preload: false}).then((run) => run.violations)")
        told = [
            f"{each['id']}: {each['help']} {[node['target'] for node in each['nodes']][:5]}"
            for each in found
            if each["impact"] in SERIOUS
        ]
        assert not told, f"{scheme}, {width} px: {told}"
