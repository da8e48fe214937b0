"""What every view has."""

import hashlib
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.e2e.conftest import Served
from tests.web.conftest import check_accessibility

ROOT = Path(__file__).parents[2]
VIEWS = ["", "studies/new", "studies/" + "0" * 32, "cases/1", "compare", "queue"]


@pytest.mark.parametrize("folder", ["app/web/static/vendor", "tests/web/vendor"])
def test_files_of_others_are_as_they_were_published_and_have_licences(folder: str) -> None:
    sums = dict(line.split()[::-1] for line in (ROOT / folder / "SHA256SUMS").read_text().splitlines())
    files = {path.name: path for path in (ROOT / folder).iterdir() if path.name not in ("SHA256SUMS", "README.md")}
    assert {name: hashlib.sha256(path.read_bytes()).hexdigest() for name, path in files.items()} == sums
    for name in files:
        assert f"{name.partition('.')[0]}.LICENSE" in files, name


def test_a_page_holds_no_script_and_no_data(service: Served) -> None:
    for view in VIEWS:
        answer = service.http.get(f"/{view}")
        assert answer.status_code == 200
        policy = answer.headers["content-security-policy"].split("; ")
        assert {"default-src 'none'", "script-src 'self'", "style-src 'self'", "connect-src 'self'"} <= set(policy)
        assert "unsafe" not in answer.headers["content-security-policy"]
        assert not re.search(r"<script>|<style|\son\w+=|\sstyle=", answer.text)
        for address in re.findall(r"""(?:href|src)="([^"]*)\"""", answer.text):
            assert not address.startswith(("/", "http")), address


def test_its_files_are_kept_by_browsers(service: Served) -> None:
    page = service.http.get("/").text
    for address in set(re.findall(r"static/[\w./-]+", page)):
        answer = service.http.get(f"/{address}")
        assert answer.status_code == 200
        assert "immutable" in answer.headers["cache-control"]


def test_the_reader_chooses_colours(page: Page) -> None:
    page.goto("/")
    background = "getComputedStyle(document.body).backgroundColor"
    light = page.evaluate(background)
    page.get_by_label("Colours").select_option("dark")
    assert page.evaluate(background) != light
    page.reload()
    assert page.evaluate(background) != light
    expect(page.get_by_label("Colours")).to_have_value("dark")
    page.get_by_label("Colours").select_option("Auto")
    assert page.evaluate(background) == light


def test_every_view_is_reached_from_the_bar(page: Page) -> None:
    page.goto("/")
    for name in ("New study", "Compare", "Queue", "Studies"):
        page.get_by_role("navigation").get_by_role("link", name=name, exact=True).click()
        expect(page.get_by_role("heading", level=1)).to_have_text(name)
        expect(page.locator("nav [aria-current=page]")).to_have_text(name)


def test_the_content_is_two_keys_away(page: Page) -> None:
    page.goto("/")
    page.keyboard.press("Tab")
    expect(page.get_by_role("link", name="Skip to the content")).to_be_focused()
    page.keyboard.press("Enter")
    assert page.evaluate("location.hash") == "#main"


@pytest.mark.parametrize("view", ["compare", "queue"])
def test_nothing_stands_in_the_way_of_anybody(view: str, page: Page) -> None:
    page.goto(f"/{view}")
    expect(page.locator("#request")).to_be_visible()
    check_accessibility(page)
