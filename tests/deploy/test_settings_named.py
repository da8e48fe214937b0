"""Every setting that a file of the deployment or a document names is one."""

import re
from pathlib import Path

from app.settings import Settings

ROOT = Path(__file__).parents[2]
OF_CLIENTS = {"TRACKSWEEP_API_KEY"}


def test_every_setting_that_is_named_exists() -> None:
    settings = {f"TRACKSWEEP_{name.upper()}" for name in Settings.model_fields} | OF_CLIENTS
    files = [
        ROOT / name for name in ("Dockerfile", "docker-compose.yml", ".env.example", "README.md", "CONTRIBUTING.md")
    ]
    files += [path for folder in ("deploy", "docs") for path in (ROOT / folder).rglob("*") if path.is_file()]
    texts = {path: path.read_text() for path in files if path.suffix not in {".png", ".gif"}}
    named = {(name, path.name) for path, text in texts.items() for name in re.findall(r"\bTRACKSWEEP_[A-Z_]+\b", text)}
    assert {(name, file) for name, file in named if name not in settings} == set()
    assert {"docker-compose.yml", "settings.md"} <= {file for _, file in named}
