"""The topology without containers: systemd units, the Slurm job, and the Kubernetes manifest."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import Any

import psutil
import psycopg
import pytest
import yaml

ROOT = Path(__file__).parents[2]
UNITS = sorted((ROOT / "deploy/systemd").glob("*.service"))
JOB = ROOT / "deploy/slurm/workers.sbatch"
MANIFEST = ROOT / "deploy/kubernetes/tracksweep.yaml"
OBJECTS: dict[tuple[str, str], dict[str, Any]] = {
    (each["kind"], each["metadata"]["name"]): each for each in yaml.safe_load(MANIFEST.read_text())["items"]
}


def test_systemd_takes_the_units(tmp_path: Path) -> None:
    if (analyze := shutil.which("systemd-analyze")) is None:
        pytest.skip("there is no systemd-analyze")
    program = tmp_path / "tracksweep"
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    for unit in UNITS:  # the program need not be installed for them to be right
        text = unit.read_text().replace("/opt/tracksweep/bin/tracksweep", str(program))
        (tmp_path / unit.name.replace("@", "@1")).write_text(text)
    names = [str(tmp_path / unit.name.replace("@", "@1")) for unit in UNITS]
    done = subprocess.run([analyze, "verify", *names], capture_output=True, text=True, check=False, timeout=60)
    ours = [line for line in done.stderr.splitlines() if "tracksweep" in line]
    assert (done.returncode, ours) == (0, [])


def test_units_run_commands_of_the_program_without_privileges() -> None:
    commands = [re.findall(r"^Exec\w+=/opt/tracksweep/bin/tracksweep (\w+)$", u.read_text(), re.M) for u in UNITS]
    assert commands == [["migrate", "api"], ["worker"]]
    for unit in UNITS:
        text = unit.read_text()
        assert "\nUser=tracksweep\n" in text
        assert "\nNoNewPrivileges=yes\n" in text
        assert not re.search("^MemoryDenyWriteExecute=yes", text, re.MULTILINE)  # Numba could not compile
        restarted = re.findall("^Restart=(.*)$", text, re.MULTILINE)
        assert restarted == {"api": ["always"], "worker@": ["on-failure"]}[unit.stem.partition("-")[2]]


@pytest.fixture
def allocation(tmp_path: Path) -> dict[str, str]:
    """What stands in for Slurm, for settings and for a worker: one that crashes at first, then runs until told."""
    (tmp_path / "srun").write_text('#!/bin/sh\nwhile [ "${1#--}" != "$1" ]; do shift; done\nexec "$@"\n')
    (tmp_path / "worker").write_text(
        f"""#!/bin/sh
trap 'echo stopped >> {tmp_path}/runs; exit 0' TERM
echo "$1 $TRACKSWEEP_BROKER_URL $TRACKSWEEP_DATA_DIR" >> {tmp_path}/runs
[ $(wc -l < {tmp_path}/runs) = 1 ] && exit 1
while :; do sleep 0.05; done
"""
    )
    for name in ("srun", "worker"):
        (tmp_path / name).chmod(0o755)
    (tmp_path / "settings").write_text("TRACKSWEEP_BROKER_URL=redis://somewhere/0\n")
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    return os.environ | {"PATH": path, "SLURM_JOB_ID": "7", "TMPDIR": str(tmp_path)}


def test_the_slurm_job_keeps_workers_until_its_end(tmp_path: Path, allocation: dict[str, str]) -> None:
    subprocess.run(["bash", "-n", str(JOB)], check=True)
    command = ["bash", str(JOB), str(tmp_path / "settings"), str(tmp_path / "worker")]
    runs = tmp_path / "runs"
    with subprocess.Popen(command, env=allocation) as job:
        deadline = time.monotonic() + 30
        while not runs.exists() or len(runs.read_text().splitlines()) < 2:
            assert time.monotonic() < deadline, "the worker was not started again"
            time.sleep(0.05)
        for process in psutil.Process(job.pid).children(recursive=True):  # as Slurm does: to all of the step
            with suppress(psutil.NoSuchProcess):  # a pause that is over
                process.send_signal(signal.SIGTERM)
        assert job.wait(timeout=30) == 0
    line = f"worker redis://somewhere/0 {tmp_path}/tracksweep-7"
    assert runs.read_text().splitlines() == [line, line, "stopped"]


def test_kubernetes_takes_its_objects(tmp_path: Path) -> None:
    known = [each for each in OBJECTS.values() if "keda.sh" not in each["apiVersion"]]
    assert len(known) == len(OBJECTS) - 2
    (tmp_path / "known.yaml").write_text(yaml.safe_dump_all(known))
    command = [str(Path(sys.executable).parent / "kubernetes-validate"), "--strict", str(tmp_path / "known.yaml")]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr


def test_objects_of_the_manifest_find_each_other() -> None:
    pods = {name: each["spec"]["template"] for (kind, name), each in OBJECTS.items() if kind == "Deployment"}
    for name, pod in pods.items():
        labels = pod["metadata"]["labels"].items()
        assert OBJECTS["Deployment", name]["spec"]["selector"]["matchLabels"].items() <= labels
        spec = pod["spec"]
        assert ("ServiceAccount", spec["serviceAccountName"]) in OBJECTS
        assert spec["securityContext"]["runAsNonRoot"] is True
        for container in spec["containers"] + spec["initContainers"]:
            assert container["securityContext"]["readOnlyRootFilesystem"] is True
            mounted = {mount["name"] for mount in container["volumeMounts"]}
            assert mounted <= {volume["name"] for volume in spec["volumes"]}
    api = pods["tracksweep-api"]
    service = OBJECTS["Service", "tracksweep"]["spec"]
    for selector in (
        service["selector"],
        OBJECTS["PodDisruptionBudget", "tracksweep-api"]["spec"]["selector"]["matchLabels"],
    ):
        assert selector.items() <= api["metadata"]["labels"].items()
    assert service["ports"][0]["targetPort"] in {port["name"] for port in api["spec"]["containers"][0]["ports"]}
    image = yaml.safe_load((ROOT / "docker-compose.yml").read_text())["services"]["api"]["image"]
    assert {c["image"] for pod in pods.values() for c in pod["spec"]["containers"]} == {image}
    scaled = OBJECTS["ScaledObject", "tracksweep-worker"]["spec"]
    assert scaled["scaleTargetRef"]["name"] in pods
    assert "replicas" not in OBJECTS["Deployment", scaled["scaleTargetRef"]["name"]]["spec"]
    (trigger,) = scaled["triggers"]
    assert ("TriggerAuthentication", trigger["authenticationRef"]["name"]) in OBJECTS


def test_the_autoscaler_counts_cases(postgresql_with_tables: str) -> None:
    (trigger,) = OBJECTS["ScaledObject", "tracksweep-worker"]["spec"]["triggers"]
    with psycopg.connect(postgresql_with_tables.replace("+psycopg", "")) as connection:
        count = connection.execute(trigger["metadata"]["query"]).fetchone()
    assert count is not None
    assert isinstance(count[0], int)
