"""The image and the topology with containers: what can be told of them without a container engine."""

import re
import shutil
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).parents[2]
TOOLS = Path(sys.executable).parent
DOCKERFILE = (ROOT / "Dockerfile").read_text()
TEXT = (ROOT / "docker-compose.yml").read_text()
COMPOSE: dict[str, Any] = yaml.safe_load(TEXT)
SERVICES: dict[str, dict[str, Any]] = COMPOSE["services"]
OURS = {"migrate", "api", "worker"}
VERSION = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]


def accepted(*command: str) -> None:
    """Run a tool that says what is wrong."""
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr


def copied() -> list[str]:
    """What the image is built from."""
    lines = re.findall(r"^COPY (?!--from)(.+)$", DOCKERFILE, re.MULTILINE)
    return [source for line in lines for source in line.split()[:-1]]


def test_the_compose_file_follows_the_specification() -> None:
    accepted(str(TOOLS / "check-jsonschema"), "--builtin-schema", "vendor.compose-spec", "docker-compose.yml")


def test_the_dockerfile_has_no_known_mistake() -> None:
    if sys.platform != "linux":
        pytest.skip("the linter is installed on Linux")
    accepted(str(TOOLS / "hadolint"), "Dockerfile")


def test_images_are_pinned() -> None:
    digest = r"[\w./-]+:[\w.-]+@sha256:[0-9a-f]{64}"
    without = {"flower": r"mher/flower:\d+\.\d+\.\d+"} | dict.fromkeys(OURS, f"tracksweep:{re.escape(VERSION)}")
    for name, service in SERVICES.items():
        assert re.fullmatch(without.get(name, digest), service["image"]), name
    assert set(re.findall(r"^FROM (\S+)", DOCKERFILE, re.MULTILINE)) == {"${PYTHON}"}
    assert re.search(rf"^ARG PYTHON={digest}$", DOCKERFILE, re.MULTILINE)


def test_what_is_ours_runs_without_privileges() -> None:
    stages = DOCKERFILE.split("\nFROM ")
    assert len(stages) == 3
    assert re.search(r"^USER [1-9]\d+$", stages[-1], re.MULTILINE)
    for name in OURS:
        service = SERVICES[name]
        assert service["read_only"] is True
        assert service["cap_drop"] == ["ALL"]
        assert "no-new-privileges:true" in service["security_opt"]


def test_no_secret_is_written_down() -> None:
    assert not re.search(r"://\w+:(?!\$\{)[^@/\s]+@", TEXT)
    for name, service in SERVICES.items():
        for variable, value in service.get("environment", {}).items():
            if re.search("PASSWORD|SECRET|KEY|USER", variable) and variable != "POSTGRES_USER":
                assert value is None or re.fullmatch(r"\$\{\w+:[-?].*\}", value), f"{name}: {variable}"
    for name, value in re.findall(r"^#?(\w*(?:PASSWORD|SECRET\w*|_KEY))=(.*)$", example(), re.MULTILINE):
        assert not value, name


def test_every_variable_has_an_example() -> None:
    bare = {
        name for service in SERVICES.values() for name, value in service.get("environment", {}).items() if not value
    }
    secrets = {secret["environment"] for secret in COMPOSE["secrets"].values()}
    used = set(re.findall(r"(?<!\$)\$\{(\w+)", TEXT)) | bare | secrets
    assert used == set(re.findall(r"^#?(\w+)=", example(), re.MULTILINE))


def test_only_the_api_asks_whether_it_is_well() -> None:
    assert re.search(r"^HEALTHCHECK ", DOCKERFILE, re.MULTILINE)
    unhealthy = {name for name in OURS if SERVICES[name].get("healthcheck") == {"disable": True}}
    assert unhealthy == OURS - {"api"}
    for service in SERVICES.values():
        needs = service.get("depends_on", {})
        for name in needs:
            if needs != list(needs) and needs[name]["condition"] == "service_healthy":
                assert "test" in SERVICES[name]["healthcheck"], name


def test_ports_are_published_on_the_loopback() -> None:
    ports = [port for service in SERVICES.values() for port in service.get("ports", ())]
    assert len(ports) >= 4
    assert all(port.startswith("127.0.0.1:") for port in ports)


def test_what_is_mounted_is_there() -> None:
    mounts = [mount.split(":")[0] for service in SERVICES.values() for mount in service.get("volumes", ())]
    for mount in mounts:
        assert (ROOT / mount).exists() if mount.startswith("./") else mount in COMPOSE["volumes"], mount
    assert {mount for mount in mounts if not mount.startswith("./")} == set(COMPOSE["volumes"])


def test_the_image_has_all_of_the_program(tmp_path: Path) -> None:
    for source in copied():
        copy = shutil.copytree if (ROOT / source).is_dir() else shutil.copy
        copy(ROOT / source, tmp_path / source)
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", "dist"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
        timeout=60,
    )
    (wheel,) = (tmp_path / "dist").iterdir()
    inside = set(zipfile.ZipFile(wheel).namelist())
    for folder in ("app", "worker", "solver", "migrations"):
        files = [path for path in (ROOT / folder).rglob("*") if path.is_file() and "__pycache__" not in path.parts]
        assert {str(path.relative_to(ROOT)) for path in files} <= inside


def test_what_the_image_is_built_from_is_sent_to_the_builder() -> None:
    ignore = (ROOT / ".dockerignore").read_text().split()
    assert ignore[0] == "*"
    assert {line.removeprefix("!") for line in ignore if line.startswith("!")} == set(copied())


def test_the_image_is_built_with_the_same_uv() -> None:
    makefile = re.search(r"^UV_VERSION := (\S+)$", (ROOT / "Makefile").read_text(), re.MULTILINE)
    assert makefile is not None
    assert f"uv=={makefile[1]}\n" in DOCKERFILE


def test_prometheus_asks_the_api() -> None:
    prometheus = yaml.safe_load((ROOT / "deploy/prometheus/prometheus.yml").read_text())
    (job,) = prometheus["scrape_configs"]
    ((target,),) = [each["targets"] for each in job["static_configs"]]
    host, port = target.split(":")
    assert host in SERVICES
    assert f"EXPOSE {port}\n" in DOCKERFILE
    secret = job["authorization"]["credentials_file"].removeprefix("/run/secrets/")
    assert secret in SERVICES["prometheus"]["secrets"]


def example() -> str:
    return (ROOT / ".env.example").read_text()
