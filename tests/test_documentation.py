"""What is written for readers agrees with the code."""

import ast
import json
import re
from pathlib import Path

from app import problems
from app.catalogue import service as catalogue
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


def given_codes() -> set[str]:
    """Every `code` that stands in the sources as an argument of what makes a problem."""
    found = set(problems._CODES.values())
    for path in (ROOT / "app").rglob("*.py"):
        for call in ast.walk(ast.parse(path.read_text())):
            if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Name):
                continue
            place = {"invalid": 1, "forbidden": 1, "PydanticCustomError": 0}.get(call.func.id)
            values = [] if place is None else call.args[place : place + 1]
            if call.func.id in ("Problem", "FieldProblem", "Discriminator"):
                values = [k.value for k in call.keywords if k.arg in ("code", "custom_error_type")]
            found |= {value.value for value in values if isinstance(value, ast.Constant)}
    return found


def test_every_problem_code_is_documented() -> None:
    documented = re.findall(r"^\| `([a-z-]+)` \|", (ROOT / "docs/problems.md").read_text(), re.MULTILINE)
    assert set(documented) == given_codes()


def test_every_operation_and_quantity_is_documented() -> None:
    page = (ROOT / "docs/api.md").read_text()
    operations = re.findall(r"^\| `(\w+)` \| (\w+) `([^`]+)` \|", page, re.MULTILINE)
    document = json.loads((ROOT / "openapi.json").read_text())
    assert set(operations) == {
        (operation["operationId"], method.upper(), path)
        for path, methods in document["paths"].items()
        for method, operation in methods.items()
    }
    quantities = dict(re.findall(r"^\| `(\w+)` \| ([^`|]+) \| [^`]*\|$", page, re.MULTILINE))
    assert quantities == {quantity.name: quantity.unit for quantity in catalogue.quantities()}


def test_every_test_that_the_threat_model_names_exists() -> None:
    rows = re.findall(r"^\| .* \| .* \| (`tests/.*`) \|$", (ROOT / "docs/security.md").read_text(), re.MULTILINE)
    named = [tuple(name.split("::")) for row in rows for name in re.findall(r"`([^`]+)`", row)]
    assert len(rows) >= 15
    assert len(rows) == len(re.findall(r"^\| (?!threat)\w", (ROOT / "docs/security.md").read_text(), re.MULTILINE))
    for path, name in named:
        tests = {node.name for node in ast.parse((ROOT / path).read_text()).body if isinstance(node, ast.FunctionDef)}
        assert name in tests, f"{path} has no {name}"
