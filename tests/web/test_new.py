"""New study: the form says what is sent, and what is wrong with it at its fields."""

import json
import re
from typing import Any

import pytest
from playwright.sync_api import Page, Response, expect

from tests.e2e.conftest import SMALL, Served
from tests.web.conftest import check_accessibility, check_stillness

PROFILE = "x_m,eta_mm\n" + "".join(f"{n / 4},{(n * 7 % 11 - 5) / 10}\n" for n in range(200))
ESTIMATES, PREVIEWS = "/v1/study-estimates", "/v1/irregularity-previews"


@pytest.fixture
def form(page: Page) -> Page:
    """The form, filled with its first preset."""
    page.goto("/studies/new")
    expect(page.locator("#estimate dl")).to_be_visible()
    return page


def answers(path: str) -> Any:
    return lambda response: response.url.endswith(path) and response.request.method == "POST"


def sent(response: Response) -> dict[str, Any]:
    return dict(json.loads(response.request.post_data or ""))


def test_a_study_is_created_through_the_form(form: Page, service: Served) -> None:
    form.get_by_label("Name").fill("By hand")
    form.get_by_label("Labels").fill("line=test, owner=somebody")
    form.get_by_role("radio", name="list").check()
    form.get_by_label("Speeds, km/h").fill("251 252")
    form.get_by_label("discontinuous").uncheck()
    form.get_by_role("button", name="Add a parameter").click()
    form.get_by_role("combobox", name="Parameter", exact=True).fill("track.pad_stiffness_n_per_m")
    form.get_by_label("Values", exact=True).fill("5e7")
    form.locator("#numerics-values summary").click()
    for name, value in SMALL.items():
        form.locator(f"[id='numerics.{name}']").fill(str(value))
    with form.expect_response(answers("/v1/studies")) as creating:
        form.get_by_role("button", name="Create study").click()
    form.wait_for_url(re.compile(r"/studies/[0-9a-f]{32}$"))
    study = service.get(f"/v1/studies/{form.url.rpartition('/')[2]}")
    assert creating.value.request.headers["idempotency-key"]
    assert study["definition"] == {
        "name": "By hand",
        "labels": {"line": "test", "owner": "somebody"},
        "sweep": {
            "kind": "product",
            "speed_kmh": [251, 252],
            "slab": ["continuous"],
            "irregularity": {"kind": "harmonic", "wavelength_m": [1], "amplitude_mm": [0.3]},
            "vary": {"track.pad_stiffness_n_per_m": [5e7]},
        },
        "track": {"base": "crts2"},
        "vehicle": {"base": "crh3"},
        "numerics": SMALL,
    }


@pytest.mark.parametrize("name", ["article-wavelength-bands", "pad-stiffness"])
def test_a_preset_fills_the_form_with_itself(form: Page, service: Served, name: str) -> None:
    (preset,) = [each for each in service.get("/v1/presets")["items"] if each["name"] == name]
    with form.expect_response(answers(ESTIMATES)) as asking:
        form.get_by_label("Begin with").select_option(name)
    study = sent(asking.value)
    defaults = {"percentile": [63.2], "realisations": 1, "seed": 1}  # which the form spells out
    assert study["sweep"].pop("irregularity") == defaults | preset["study"]["sweep"].pop("irregularity")
    assert study == preset["study"]
    assert asking.value.json()["cases"]["total"] == preset["cases"]


def test_what_is_refused_is_told_at_its_field(form: Page) -> None:
    field = form.get_by_label("Amplitudes, mm")
    with form.expect_response(answers(ESTIMATES)) as asking:
        field.fill("0.3, 50")
    (error,) = asking.value.json()["errors"]
    expect(field).to_have_attribute("aria-invalid", "true")
    expect(field).to_have_accessible_description(re.compile(re.escape(error["detail"])))
    form.locator("#vehicle-values summary").click()
    form.locator("[id='vehicle.wheelset_mass_kg']").fill("heavy")
    form.locator("#vehicle-values summary").click()
    field.fill("0.3")
    expect(field).not_to_have_attribute("aria-invalid", "true")
    form.get_by_role("button", name="Create study").click()
    mass = form.locator("[id='vehicle.wheelset_mass_kg']")
    expect(mass).to_be_focused()
    expect(mass).to_have_accessible_description(re.compile("valid number"))
    expect(form).to_have_url(re.compile("/studies/new$"))


def test_a_measured_profile_is_uploaded_and_looked_at(form: Page, service: Served) -> None:
    form.get_by_label("Kind").select_option("measured")
    bad = {"name": "bad.csv", "mimeType": "text/csv", "buffer": b"x_m,eta_mm\n0,1\n1,up\n"}
    form.get_by_label("Upload another").set_input_files(bad)  # type: ignore[arg-type]
    expect(form.get_by_label("Upload another")).to_have_accessible_description(re.compile("Line 3 must be two numbers"))
    good = {"name": "good.csv", "mimeType": "text/csv", "buffer": PROFILE.encode()}
    of_profile = "profile_id"  # an earlier preview may still be under way
    with form.expect_response(lambda r: answers(PREVIEWS)(r) and of_profile in sent(r)["irregularity"]) as asking:
        form.get_by_label("Upload another").set_input_files(good)  # type: ignore[arg-type]
    profile_id = sent(asking.value)["irregularity"]["profile_id"]
    expect(form.get_by_label("Stored profile")).to_have_value(profile_id)
    expect(form.get_by_role("img", name="Profile of the rail head")).to_be_visible()
    service.http.delete(f"/v1/profiles/{profile_id}").raise_for_status()


def test_what_the_form_has_no_fields_for_is_written_as_json(form: Page) -> None:
    form.get_by_role("checkbox", name="as JSON").check()
    text = form.get_by_label("Study as JSON")
    study = json.loads(text.input_value())
    study["sweep"] = {"kind": "list", "cases": [{"speed_kmh": 99, "irregularity": {"kind": "none"}}] * 2}
    with form.expect_response(answers(ESTIMATES)) as asking:
        text.fill(json.dumps(study))
    assert asking.value.json()["cases"]["total"] == 1
    text.fill("{")
    expect(form.locator("#refused")).to_contain_text("not JSON")
    text.fill(json.dumps({**study, "weight": 1}))
    expect(text).to_have_attribute("aria-invalid", "true")


def test_nothing_moves_while_the_form_is_filled(page: Page) -> None:
    check_stillness(page, "/studies/new", "#preset")


def test_nothing_of_the_form_stands_in_the_way_of_anybody(form: Page) -> None:
    form.get_by_label("Begin with").select_option("pad-stiffness")
    form.get_by_label("Percentiles, %").fill("500")
    expect(form.get_by_label("Percentiles, %")).to_have_attribute("aria-invalid", "true")
    for part in ("track", "vehicle", "numerics"):
        form.locator(f"#{part}-values summary").click()
    form.locator("#request summary").click()
    check_accessibility(form)
