"""What docs/deploy.md tells to type."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "docs/deploy.md").read_text()
BLOCKS = re.findall(r"^```sh ?(\w*)\n(.*?)^```", TEXT, re.DOTALL | re.MULTILINE)


def test_its_commands_are_shell() -> None:
    assert {"both", "first", "second"} <= {where for where, _ in BLOCKS}
    for _, commands in BLOCKS:
        subprocess.run(["bash", "-n", "-c", commands], check=True)


def test_the_files_it_names_are_there() -> None:
    named = {path.rstrip(".") for path in re.findall(r"\b(?:deploy|examples)/[\w./*-]+", TEXT)}
    assert len(named) >= 4
    for path in named:
        assert list(ROOT.glob(path)), path
    units = {path.stem.rstrip("@") for path in (ROOT / "deploy/systemd").glob("*.service")}
    assert set(re.findall(r"\btracksweep-(?:migrate|api|worker)\b", TEXT)) == units


def test_settings_are_filled_in_whole() -> None:
    example = (ROOT / "deploy/systemd/env.example").read_text()
    replaced = re.findall(r"\bs/(\w+)/", TEXT)
    assert len(replaced) == 2 * 3
    assert replaced[:3] == replaced[3:]
    for word in replaced:
        example = example.replace(word, "x")
    assert not re.search(r"=.*[A-Z]{4}", example)


def test_it_installs_with_the_same_uv_as_everywhere() -> None:
    versions = re.findall(r"uv==(\S+)", TEXT + (ROOT / "Dockerfile").read_text())
    assert len(versions) == 2
    assert len(set(versions)) == 1
