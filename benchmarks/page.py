"""How soon the page is painted and can be used while both workers compute.

python -m benchmarks.page [--loads N]
"""

import argparse
import time
from collections.abc import Iterator
from contextlib import contextmanager

import httpx
import numpy as np
from playwright.sync_api import Browser, sync_playwright

from benchmarks.load import BUSY
from benchmarks.results import Result, publish
from benchmarks.served import finish, served, submit
from tests.web.browser import FLAGS, find

SPEEDS = [200, 250, 300, 350]
LOOKED_AT = {
    "name": "looked at",
    "keep_history": True,
    "priority": 1,
    "sweep": {
        "kind": "product",
        "speed_kmh": SPEEDS,
        "slab": ["continuous", "discontinuous"],
        "irregularity": {"kind": "harmonic", "wavelength_m": [1.0], "amplitude_mm": [0.3]},
    },
    "numerics": {"settle_s": 0.3, "window_s": 0.5},
}

# What is there once a view shows its first data.
READY = {
    "Studies": "document.querySelector('#list tbody tr')",
    "New study": "document.querySelector('#preset')?.value",
    "Study": "document.querySelector('#table tbody tr') && document.querySelector('#curve canvas')",
    "Case": "document.querySelector('#histories canvas')",
    "Compare": "document.querySelector('#table tbody tr') && document.querySelector('#curve canvas')",
    "Queue": "document.querySelector('#queue tbody tr')",
}

# Looks at every frame; once the data are there, the next frame is drawn and then a task has its turn, as a click would.
WATCH = """window.interactive = new Promise((done) => {
  const look = () => {
    if (document.body && (%s)) requestAnimationFrame(() => setTimeout(() => done(performance.now())));
    else requestAnimationFrame(look);
  };
  look();
})"""
PAINTED = """new Promise((done) => new PerformanceObserver((list) => {
  for (const { startTime } of list.getEntriesByName("first-contentful-paint")) done(startTime);
}).observe({ type: "paint", buffered: true }))"""

HOW = """`tracksweep serve` with two workers, both computing all the time. Headless Chromium on the same machine opens
each view {loads} times, every time without a cache, the views in turns. *First paint* is the browser's own
`first-contentful-paint`. A view is *interactive* once its first data are drawn (rows and curves; in the form, the
preset) and a task that is posted after that frame has had its turn, as a click would have. Milliseconds are from the
start of the navigation."""


@contextmanager
def browser() -> Iterator[Browser]:
    """Chromium, as the tests have it."""
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=find(), args=FLAGS)
        yield found
        found.close()


def opened(browser: Browser, url: str, ready: str) -> tuple[float, float]:
    """Open a view without a cache; ms to its first paint, and until it is interactive."""
    page = browser.new_context().new_page()
    page.add_init_script(WATCH % ready)
    page.goto(url)
    interactive = page.evaluate("window.interactive")
    painted = page.evaluate(PAINTED)
    page.context.close()
    return painted, interactive


def run(loads: int) -> Result:
    """Open every view of a busy service some times."""
    found: dict[str, list[tuple[float, float]]] = {view: [] for view in READY}
    with served(2) as url, browser() as chromium, httpx.Client(base_url=url, trust_env=False) as http:
        first, second = (submit(url, LOOKED_AT | {"name": name}) for name in ("looked at", "compared with"))
        finish(url, first)
        case = http.get(f"/v1/studies/{first}/cases").json()["items"][0]["id"]
        paths = ["/", "/studies/new", f"/studies/{first}", f"/cases/{case}"]
        paths += [f"/compare?study={first}&study={second}", "/queue"]
        busy = submit(url, BUSY)
        while len([each for each in http.get("/v1/queue").json()["workers"] if each["running"]]) < 2:
            time.sleep(0.2)
        for _ in range(loads):
            for (view, ready), path in zip(READY.items(), paths, strict=True):
                found[view].append(opened(chromium, url + path, ready))
        if http.get(f"/v1/studies/{busy}").json()["finished_at"]:
            raise SystemExit("the workers had nothing to do at the end: nothing is shown")
    table = [["view", "first paint, ms", "worst", "interactive, ms", "worst"]]
    for view, times in found.items():
        painted, interactive = np.array(times).T
        numbers = np.median(painted), painted.max(), np.median(interactive), interactive.max()
        table.append([view, *(f"{number:.0f}" for number in numbers)])
    every = np.array(list(found.values()))
    medians = np.median(every, axis=1).max(axis=0)
    return Result(
        title="The page while workers compute",
        how=HOW.format(loads=loads),
        command="python -m benchmarks.page",
        values={
            "largest_median_first_paint_ms": float(medians[0]),
            "largest_median_interactive_ms": float(medians[1]),
            "worst_first_paint_ms": float(every[..., 0].max()),
            "worst_interactive_ms": float(every[..., 1].max()),
        },
        table=table,
    )


def main() -> None:
    """Run it from the command line."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--loads", type=int, default=10, help="of every view")
    options = parser.parse_args()
    publish("page", run(options.loads))


if __name__ == "__main__":
    main()
