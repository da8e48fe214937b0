"""What is written for readers agrees with the code."""

import re
from pathlib import Path

from app.settings import Settings

ROOT = Path(__file__).parent.parent


def documented_settings() -> dict[str, str]:
    rows = re.findall(r"^\| `TRACKSWEEP_(\w+)` \|([^|]*)\|", (ROOT / "docs/settings.md").read_text(), re.MULTILINE)
    return {name.lower(): default.strip().strip("`") for name, default in rows}


def test_every_setting_is_documented_with_its_default() -> None:
    assert documented_settings() == {name: str(field.default) for name, field in Settings.model_fields.items()}


def test_links_of_the_documents_lead_somewhere() -> None:
    for document in [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]:
        for target in re.findall(r"\]\((?!https?:|#|mailto:)([^)#]+)", document.read_text()):
            assert (document.parent / target).exists(), f"{document.name} links to {target}"


def test_decision_records_have_numbers_of_their_own() -> None:
    numbers = [path.name[:4] for path in (ROOT / "docs/decisions").glob("*.md")]
    assert all(number.isdigit() for number in numbers)
    assert len(numbers) == len(set(numbers))
