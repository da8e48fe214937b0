"""The pictures in docs/screenshots: ``make screenshots`` runs studies on a service of its own and looks at its page."""

import tempfile
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, expect, sync_playwright

from tests.e2e.conftest import Served, served, study
from tests.web.browser import FLAGS, find

FOLDER = Path(__file__).parents[2] / "docs/screenshots"
SIZE = {"width": 1280, "height": 860}
WAVES = {"kind": "spectrum", "spectrum": "tb3352-ballastless", "wavelength_band_m": [{"min": 2, "max": 30}]}


def _sweep(name: str, labels: dict[str, str], **sweep: Any) -> dict[str, Any]:
    body = study(300) | {"name": name, "labels": labels, "keep_history": True}
    return body | {"sweep": body["sweep"] | {"slab": ["continuous", "discontinuous"]} | sweep}


def _studies(service: Served) -> tuple[str, int]:
    """Some studies, of which the last still runs; the one to look at, and a case of it."""
    speeds = {"kind": "range", "start": 160, "stop": 350, "step": 10}
    pads = {"track.pad_stiffness_n_per_m": [2e7, 3e7, 4e7, 5e7, 6e7, 8e7]}
    spectrum = WAVES | {"percentile": [25, 63.2, 90], "realisations": 4, "seed": 1}
    service.submit(_sweep("Speeds over a sine wave", {"line": "test"}, speed_kmh=speeds))
    chosen = service.submit(
        _sweep("Percentiles of the spectrum", {}, speed_kmh=[200, 250, 300, 350], irregularity=spectrum)
    )
    last = service.submit(_sweep("Pad stiffness", {"line": "test"}, vary=pads))
    service.ended(chosen)
    service.ended(last)
    service.submit(_sweep("Percentiles at more speeds", {}, speed_kmh=speeds, irregularity=spectrum))
    case = service.get(f"/v1/studies/{chosen}/cases", speed_kmh_min=350, percentile=90)["items"][0]
    return chosen, case["id"]


def _look(browser: Browser, service: Served, views: dict[str, str]) -> None:
    for name, address in views.items():
        for scheme in ("light", "dark"):
            page = browser.new_page(base_url=str(service.http.base_url), viewport=SIZE, color_scheme=scheme)  # type: ignore[arg-type]
            page.goto(address)
            expect(page.locator("[aria-busy=true]")).to_have_count(0)
            page.wait_for_timeout(6000)  # whatever is fetched after that is there
            page.screenshot(path=FOLDER / f"{name}-{scheme}.png")
            page.close()


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    with (
        tempfile.TemporaryDirectory() as folder,
        served(Path(folder) / "data") as service,
        sync_playwright() as playwright,
    ):
        study_id, case_id = _studies(service)
        browser = playwright.chromium.launch(executable_path=find(), args=FLAGS)
        views = {"studies": "/", "study": f"/studies/{study_id}", "new": "/studies/new", "case": f"/cases/{case_id}"}
        _look(browser, service, views)
        browser.close()
