"""The views of studies, of their comparison, and of the queue."""

import csv
import io
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from tests.e2e.conftest import SECONDS_LONG, SMALL, Served, served, study, tracksweep
from tests.web.conftest import check_accessibility, check_stillness, new_context, opened

QUERY = {"quantity": "wheel_rail_force", "position": "wheelset_1"}


def sweep(name: str, *speeds: float, slabs: tuple[str, ...] = ("continuous", "discontinuous")) -> dict[str, object]:
    body = study(*speeds) | {"name": name, "labels": {"line": "test"}}
    return body | {"sweep": body["sweep"] | {"slab": list(slabs)}}


@pytest.fixture(scope="module")
def ended(service: Served) -> str:
    """A study that has ended."""
    study_id = service.submit(sweep("Two speeds", 250, 300))
    assert service.ended(study_id)["state"] == "succeeded"
    return study_id


@pytest.fixture(scope="module")
def another(service: Served) -> str:
    """Another one, with a speed in common."""
    study_id = service.submit(sweep("One slab", 250, 300, 320, slabs=("continuous",)))
    assert service.ended(study_id)["state"] == "succeeded"
    return study_id


@pytest.fixture
def guarded(tmp_path: Path) -> Iterator[tuple[Served, str]]:
    """A service that asks for keys, and a key."""
    data = tmp_path / "data"
    with served(data, "--workers", "0", TRACKSWEEP_REQUIRE_KEYS="always") as service:
        created = tracksweep("keys", "create", "anna", "--scope", "write", TRACKSWEEP_DATA_DIR=data)
        yield service, created.stdout.strip()


def rows(page: Page, table: str) -> list[dict[str, str]]:
    """A table by its headings."""
    headings = [re.sub(r"\W.*", "", text) for text in page.locator(f"{table} thead th").all_inner_texts()]
    found = page.locator(f"{table} tbody tr")
    return [dict(zip(headings, row.locator("th, td").all_inner_texts(), strict=True)) for row in found.all()]


def test_a_study_is_watched_to_its_end_without_reloading(page: Page, service: Served) -> None:
    study_id = service.submit(sweep("Watched", 180, 190))
    page.goto(f"/studies/{study_id}")
    page.evaluate("window.sameDocument = true")
    expect(page.locator("#study-state")).to_have_text("succeeded", timeout=120_000)
    expect(page.locator("#table tbody tr")).to_have_count(4)
    expect(page.locator("#curve canvas")).to_be_visible()
    assert page.evaluate("window.sameDocument")


def test_a_peak_in_the_table_is_the_one_of_the_api(page: Page, ended: str, service: Served) -> None:
    page.goto(f"/studies/{ended}")
    expect(page.locator("#table tbody tr")).to_have_count(4)
    peaks = {
        (f"{row['speed_kmh']:g}", row["slab"]): row["peak"]
        for row in service.get("/v1/peaks", study_id=ended, **QUERY)["items"]
    }
    shown = {(row["speed"], row["slab"]): float(row["peak"]) for row in rows(page, "#table")}
    assert shown == {key: pytest.approx(value / 1000, rel=5e-4) for key, value in peaks.items()}

    page.locator("#table").get_by_role("button", name="peak").click()
    page.locator("#table").get_by_role("button", name="peak").click()
    assert [float(row["peak"]) for row in rows(page, "#table")] == sorted(shown.values(), reverse=True)


def test_differences_are_those_of_the_api(page: Page, ended: str, service: Served) -> None:
    page.goto(f"/studies/{ended}?quantity=pad_force")
    expect(page.locator("#pairs tbody tr")).to_have_count(2)
    found = service.get(f"/v1/studies/{ended}/comparison", axis="slab", quantity="pad_force", position="pads")
    shown = [float(row["difference"].replace("\u2212", "-")) for row in rows(page, "#pairs")]
    assert shown == [pytest.approx(100 * group["differences"][0]["relative"], rel=5e-3) for group in found["groups"]]


def test_what_is_chosen_is_in_the_address(page: Page, ended: str) -> None:
    page.goto(f"/studies/{ended}")
    page.get_by_label("Quantity").select_option("pad_force")
    expect(page.locator("#curve-title")).to_have_text("Pad force, peak, kN")
    page.reload()
    expect(page.locator("#curve-title")).to_have_text("Pad force, peak, kN")
    page.locator("#multiples").get_by_role("button", name="Wheel-rail force", exact=True).click()
    expect(page.locator("#curve-title")).to_have_text("Wheel-rail force, peak, kN")


def test_files_are_downloaded(page: Page, ended: str) -> None:
    page.goto(f"/studies/{ended}")
    with page.expect_download() as download:
        page.get_by_role("link", name="CSV").click()
    table = list(csv.DictReader(io.StringIO(download.value.path().read_text())))
    assert len({row["case_id"] for row in table}) == 4
    for kind, begin in (("SVG", b"<svg"), ("PNG", b"\x89PNG")):
        with page.expect_download() as download:
            page.get_by_role("button", name=kind).click()
        assert download.value.suggested_filename == f"wheel-rail-force-peak-kn.{kind.lower()}"
        assert download.value.path().read_bytes().startswith(begin)


def test_the_requests_it_shows_give_what_it_shows(page: Page, ended: str, service: Served) -> None:
    page.goto(f"/studies/{ended}")
    page.get_by_text("The request behind this").click()
    shown = page.locator("#request .asked").first.locator("pre")
    expect(shown.first).to_be_visible()
    curl, python = shown.all_inner_texts()
    peaks = service.get("/v1/peaks", study_id=ended, **QUERY)
    answer = subprocess.run(
        ["bash", "-c", curl.replace("curl", "curl -s", 1)], capture_output=True, check=True, timeout=60
    )
    assert json.loads(answer.stdout) == peaks
    names: dict[str, object] = {}
    exec(python, names)
    assert names["answer"].to_dict() == peaks  # type: ignore[attr-defined]


@pytest.fixture
def unwanted(service: Served) -> Iterator[str]:
    """A study that takes long, whose worker is set free whatever becomes of it."""
    body = sweep("Never mind", 200, slabs=("continuous",))
    study_id = service.submit(body | {"numerics": SMALL | {"window_s": 2 * SECONDS_LONG}})
    yield study_id
    service.http.post(f"/v1/studies/{study_id}/cancel")


def test_a_study_is_found_cancelled_retried_and_deleted(page: Page, unwanted: str, service: Served) -> None:
    study_id = unwanted
    page.goto("/")
    page.get_by_label("Name contains").fill("never")
    row = page.locator(f"#study-{study_id}")
    expect(page.locator("#list tbody tr")).to_have_count(1)
    row.get_by_role("button", name="Cancel").click()
    page.get_by_role("button", name="Keep").click()
    row.get_by_role("button", name="Cancel").click()
    page.get_by_role("button", name="Cancel the study").click()
    expect(row).to_contain_text("cancelled")
    row.get_by_role("button", name="Retry").click()
    expect(row).to_contain_text(re.compile("queued|running"))
    row.get_by_role("button", name="Cancel").click()
    page.get_by_role("button", name="Cancel the study").click()
    expect(row).to_contain_text("cancelled")
    row.get_by_role("button", name="Delete").click()
    page.get_by_role("button", name="Delete the study").click()
    expect(page.locator("#list")).to_contain_text("No study of this service is like that.")
    assert service.http.get(f"/v1/studies/{study_id}").status_code == 404


def test_names_are_text_and_nothing_else(page: Page, service: Served) -> None:
    name = """<img src=x onerror="document.title='taken'"> & <script>'`${1}"""
    study_id = service.submit(sweep(name, 250, slabs=("continuous",)) | {"labels": {name[:60]: name}})
    for view, place in (("/", f"#study-{study_id} .name"), (f"/studies/{study_id}", "#name"), ("/compare", "#studies")):
        page.goto(view)
        expect(page.locator(place)).to_contain_text(name)
        assert page.locator("main img, main script").count() == 0
        assert page.title() != "taken"


def test_a_study_that_is_not_there(page: Page) -> None:
    page.goto(f"/studies/{'0' * 32}")
    expect(page.locator("main")).to_contain_text("There is no such study.")
    page.get_by_role("link", name="See which there are.").click()
    expect(page.get_by_role("heading", level=1)).to_have_text("Studies")


def test_studies_over_one_another(page: Page, ended: str, another: str) -> None:
    page.goto("/")
    for study_id in (ended, another):
        page.locator(f"#choose-{study_id}").check()
    page.get_by_role("link", name="Compare 2").click()
    expect(page.locator("#table tbody tr")).to_have_count(7)
    found = rows(page, "#table")
    alone = [row["mean"] for row in found if row["study"] == "One slab" and row["speed"] != "320"]
    assert alone == [row["mean"] for row in found if row["study"] == "Two speeds" and row["slab"] == "continuous"]


def test_what_is_the_same_stays_under_a_click_or_a_selection(page: Page, ended: str) -> None:
    page.goto("/")
    page.get_by_text("The request behind this").click()
    page.evaluate("document.querySelector('#request pre').title = 'mine'")
    page.evaluate("new Promise((done) => document.addEventListener('htmx:after:swap', () => done(), { once: true }))")
    assert page.locator("#request pre").first.get_attribute("title") == "mine"


LOADED_AND_ASKED = """() => {
  const asked = performance.getEntriesByType("resource");
  const of = (path) => asked.find(({ name }) => new URL(name).pathname.endsWith(path));
  return [of("/studies.js").responseEnd, of("/v1/studies").startTime];
}"""


def test_nothing_is_asked_before_the_script_that_shows_it_is_there(page: Page, ended: str) -> None:
    late: list[Route] = []
    page.route("**/studies.js", lambda route: late.append(route))  # noqa: PLW0108 - it takes no builtin
    with page.expect_event("requestfinished", lambda request: request.url.endswith("/htmx.min.js")):
        page.goto("/", wait_until="commit")
    late[0].continue_()
    expect(page.locator("#list tbody tr").first).to_be_visible()
    loaded, asked = page.evaluate(LOADED_AND_ASKED)
    assert loaded <= asked


def test_the_queue_tells_who_works(page: Page, service: Served) -> None:
    page.goto("/queue")
    (worker,) = service.get("/v1/queue")["workers"]
    expect(page.locator("#queue tbody")).to_contain_text(worker["name"])


def test_nothing_moves_while_a_view_is_filled(page: Page, ended: str, another: str) -> None:
    comparison = f"compare?study={ended}&study={another}"
    for view, table in (("", "#list"), (f"studies/{ended}", "#table"), (comparison, "#table")):
        check_stillness(page, f"/{view}", f"{table} tbody tr")


PLACES_OF_WHAT_IS_BELOW = """new Promise((done) => {
  const places = new Set();
  const look = () => {
    const charts = document.querySelectorAll("#multiples .sheet canvas").length;
    const request = document.getElementById("request");
    if (charts && !request.hidden) places.add(request.offsetTop);
    const all = charts === document.querySelectorAll("#multiples .sheet").length;
    if (charts > 20 && all) done([charts, ...places]);
    else requestAnimationFrame(look);
  };
  look();
})"""


def test_what_is_below_the_charts_stays_while_they_are_drawn(page: Page, ended: str) -> None:
    page.goto(f"/studies/{ended}", wait_until="commit")
    page.wait_for_function("document.getElementById('request')")
    charts, *places = page.evaluate(PLACES_OF_WHAT_IS_BELOW)
    assert charts > 20
    assert len(places) == 1


def test_no_view_stands_in_the_way_of_anybody(page: Page, ended: str, another: str) -> None:
    comparison = f"compare?study={ended}&study={another}"
    for view, table in (("", "#list"), (f"studies/{ended}", "#table"), (comparison, "#table")):
        page.goto(f"/{view}")
        expect(page.locator(f"{table} tbody tr").first).to_be_visible()
        page.get_by_text("The request behind this").click()
        check_accessibility(page)


def test_a_key_is_asked_for_and_kept_in_the_tab(browser: Browser, guarded: tuple[Served, str]) -> None:
    service, secret = guarded
    with opened(new_context(browser, service)) as page:
        page.goto("/")
        expect(page.get_by_role("heading", name="API key")).to_be_visible()
        page.get_by_label("Key, as").fill("ts_wrong")
        page.get_by_role("button", name="Use this key").click()
        expect(page.locator("#key-why")).to_have_text("The key is unknown or was revoked.")
        page.get_by_label("Key, as").fill(secret)
        page.get_by_role("button", name="Use this key").click()
        expect(page.locator("#list")).to_contain_text("There is no study yet.")
        assert page.evaluate("localStorage.length") == 0
        page.goto("/queue")
        expect(page.locator("#queue")).to_contain_text("No worker is there")
        page.get_by_role("button", name="Forget key").click()
        expect(page.get_by_role("heading", name="API key")).to_be_visible()


def test_what_failed_is_told_with_its_reason(page: Page, service: Served) -> None:
    soft = {"track": {"pad_stiffness_n_per_m": 1e-6}, "vehicle": {"car_body_mass_kg": 1e6}}
    study_id = service.submit(sweep("Hopeless", 300, slabs=("continuous",)) | soft)
    assert service.ended(study_id)["state"] == "failed"
    (case,) = service.cases(study_id)
    page.goto(f"/studies/{study_id}")
    expect(page.locator("#failures-table tbody tr")).to_have_count(1)
    (row,) = rows(page, "#failures-table")
    expect(page.locator("#failures-title")).to_have_text("1 case failed")
    assert (row["case"], row["why"]) == (str(case["id"]), f"{case['error']['code']} {case['error']['detail']}")
    check_accessibility(page)
