"""What is generated is what is committed, and serves the releases it is said to serve."""

import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
GENERATED = ROOT / "client/tracksweep_client/generated"


def test_the_committed_document_is_the_services() -> None:
    command = [sys.executable, "-m", "worker.cli", "openapi"]
    printed = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    assert json.loads(printed) == json.loads((ROOT / "openapi.json").read_text()), "run `make client`"


def sources(folder: Path) -> dict[Path, str]:
    return {path.relative_to(folder): path.read_text() for path in folder.rglob("*.py")}


def test_the_committed_client_is_generated_from_the_committed_document(tmp_path: Path) -> None:
    environment = os.environ | {"PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    fresh = tmp_path / "generated"
    command = ["make", "--no-print-directory", "--silent", "-C", ROOT, "generated", f"GENERATED={fresh}"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    assert sources(fresh) == sources(GENERATED), "run `make client`"


def test_client_and_service_are_released_together() -> None:
    service, client = (tomllib.loads((ROOT / name).read_text()) for name in ("pyproject.toml", "client/pyproject.toml"))
    assert service["project"]["version"] == client["project"]["version"]
    assert set(client["project"]["dependencies"]) <= set(service["project"]["dependencies"])


def test_the_client_understands_services_of_the_minor_version_before() -> None:
    """Nothing it had is gone, and nothing it did not send is required."""
    before = json.loads((ROOT / "tests/client/openapi-0.1.json").read_text())
    now = json.loads((ROOT / "openapi.json").read_text())
    for path, methods in before["paths"].items():
        assert methods.keys() <= now["paths"][path].keys()
    for name, schema in answered(before).items():
        fields = now["components"]["schemas"][name]
        assert schema["properties"].keys() <= fields["properties"].keys()
        assert set(fields["required"]) <= schema["properties"].keys()


def answered(document: dict[str, Any]) -> dict[str, Any]:
    """The schemas of all answers, and those within."""
    schemas = document["components"]["schemas"]
    operations = [operation for methods in document["paths"].values() for operation in methods.values()]
    text, found = json.dumps([operation["responses"] for operation in operations]), dict[str, Any]()
    while more := set(re.findall('"#/components/schemas/([^"]+)"', text)) - found.keys():
        found |= {name: schemas[name] for name in more}
        text = json.dumps(found)
    return found
