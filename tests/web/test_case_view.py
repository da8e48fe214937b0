"""Case: its numbers are the API's, finer ones are asked for where the reader looks closer."""

import re
from collections.abc import Iterator
from typing import Any
from urllib.parse import parse_qs, urlsplit

import pytest
from playwright.sync_api import Page, Response, expect

from tests.e2e.conftest import Served, study
from tests.web.conftest import check_accessibility, check_stillness

HISTORY, SPECTRUM = "history", "spectrum"


@pytest.fixture(scope="module")
def computed(service: Served) -> Iterator[dict[str, Any]]:
    """A case with a history."""
    study_id = service.submit(study(263.0) | {"keep_history": True})
    service.ended(study_id)
    yield service.cases(study_id)[0]
    service.http.delete(f"/v1/studies/{study_id}").raise_for_status()


@pytest.fixture
def case(page: Page, computed: dict[str, Any]) -> Page:
    """Its page, once all is shown."""
    page.goto(f"/cases/{computed['id']}")
    expect(page.locator("#drawing svg")).to_be_visible()
    expect(page.locator("#verify")).to_be_visible()
    return page


def answers(name: str) -> Any:
    return lambda response: urlsplit(response.url).path.endswith(f"/{name}")


def times(response: Response) -> list[float]:
    """Of the first channel."""
    return list(response.json()["channels"][0]["time_s"])


def test_its_numbers_are_those_of_the_api(case: Page, computed: dict[str, Any], service: Served) -> None:
    expect(case.get_by_role("heading", level=1)).to_have_text(re.compile("263 km/h, continuous slab"))
    expect(case.locator("#provenance")).to_contain_text(computed["digest"][:12])
    peaks = service.get(f"/v1/cases/{computed['id']}/peaks")["items"]
    expect(case.locator("#peaks tbody tr")).to_have_count(len(peaks))
    case.get_by_role("button", name=re.compile("^peak kN|^peak$")).first.click()
    force = next(each for each in peaks if (each["quantity"], each["position"]) == ("wheel_rail_force", "wheelset_2"))
    row = case.locator("#peaks tbody tr", has_text="wheelset 2").filter(
        has_text=re.compile("^Wheel-rail forcewheelset")
    )
    assert float(row.locator("td").nth(3).inner_text()) == pytest.approx(force["peak"] / 1e3, rel=1e-3)


def test_its_history_is_downloaded(case: Page, computed: dict[str, Any]) -> None:
    for name, suffix, begin in (("History as NumPy", "npz", b"PK"), ("as Parquet", "parquet", b"PAR1")):
        link = case.get_by_role("link", name=name)
        expect(link).to_have_attribute(
            "download", f"case-{computed['id']}.{suffix}"
        )  # or it is asked for without a key
        with case.expect_download() as download:
            link.click()
        assert download.value.suggested_filename == f"case-{computed['id']}.{suffix}"
        assert download.value.path().read_bytes().startswith(begin)


def test_closer_looks_ask_for_finer_samples(case: Page) -> None:
    plot = case.locator("#histories .u-over").first
    plot.scroll_into_view_if_needed()
    box = plot.bounding_box()
    assert box is not None
    with case.expect_response(answers(HISTORY)) as asking:
        case.mouse.move(box["x"] + 0.4 * box["width"], box["y"] + 40)
        case.mouse.down()
        case.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + 40, steps=4)
        case.mouse.up()
    query = parse_qs(urlsplit(asking.value.url).query)
    begin, end = float(query["time_min_s"][0]), float(query["time_max_s"][0])
    finer = times(asking.value)
    assert begin <= finer[0] < finer[-1] <= end
    assert end - begin == pytest.approx(0.02, rel=0.2)  # a tenth of the window
    assert len(finer) == asking.value.json()["samples"]  # every sample there is
    with case.expect_response(answers(HISTORY)) as asking:
        case.get_by_role("button", name="Whole window").click()
    whole = times(asking.value)
    assert (whole[-1] - whole[0]) / len(whole) > 2 * (finer[-1] - finer[0]) / len(finer)
    expect(case.get_by_role("button", name="Back")).to_be_disabled()


def test_the_spectrum_of_any_channel(case: Page) -> None:
    with case.expect_response(answers(SPECTRUM)) as asking:
        case.get_by_label("Channel", exact=True).select_option(label="Acceleration of a bogie, bogie 2")
    assert asking.value.json()["quantity"] == "bogie_acceleration"
    expect(case.get_by_role("img", name="Spectrum of bogie acceleration, bogie 2")).to_be_visible()
    with case.expect_response(answers(SPECTRUM)) as asking:
        case.get_by_label("Up to").select_option("2500")
    assert asking.value.json()["frequency_hz"][-1] > 2400


def test_the_drawing_is_of_its_instant_and_plays(case: Page, computed: dict[str, Any], service: Served) -> None:
    case.get_by_label("Instant").fill("0.1")
    drawing = case.locator("#drawing svg")
    expect(drawing).to_have_attribute("aria-label", re.compile("at 0.1000 s"))
    query = {"quantity": "wheel_rail_force", "position": "wheelset_1", "time_min_s": 0.0999, "time_max_s": 0.102}
    forces = service.get(f"/v1/cases/{computed['id']}/history", **query)["channels"][0]["values"]
    told = float((drawing.get_attribute("aria-label") or "").split("forces ")[1].split(",")[0])
    assert min(forces) / 1e3 - 0.1 <= told <= max(forces) / 1e3 + 0.1
    case.get_by_label("Slowed down").select_option("500")  # a frame is then a small part of the slider's step
    case.get_by_role("button", name="Play").click()
    expect(case.locator("#instant-told")).not_to_have_text(re.compile("^0.1000 s"))
    case.get_by_role("button", name="Pause").click()


def test_a_case_that_is_not_there(page: Page) -> None:
    page.goto("/cases/999999")
    expect(page.get_by_text("There is no such case.")).to_be_visible()


def test_nothing_moves_while_a_case_is_shown(page: Page, computed: dict[str, Any]) -> None:
    check_stillness(page, f"/cases/{computed['id']}", "#spectrum canvas")


def test_nothing_of_a_case_stands_in_the_way_of_anybody(case: Page) -> None:
    check_accessibility(case)
