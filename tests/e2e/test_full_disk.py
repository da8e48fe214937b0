"""A disk that is full, and then is not: a small file system of its own, in a name space that needs no rights."""

import subprocess
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from solver.warm import warm
from tests.e2e.conftest import PROGRAM, Served, study, until

WITH_SMALL_DISK = ["unshare", "--user", "--map-root-user", "--mount", "--", "sh", "-c"]
WITH_SMALL_DISK += ['mount -t tmpfs -o size=24m tmpfs "$0" && exec "$@"']
LEASE_S = 2.0


class OnSmallDisk(Served):
    """A service whose data folder nobody else sees but through it."""

    def _url(self) -> str:
        self.data = Path(f"/proc/{self.process.pid}/root") / self.data.relative_to("/")
        return super()._url()

    def fill(self) -> None:
        with suppress(OSError), (self.data / "ballast").open("wb", buffering=0) as ballast:
            while ballast.write(bytes(2**12)):
                pass


@pytest.fixture
def service(tmp_path: Path) -> Iterator[OnSmallDisk]:
    disk = tmp_path / "disk"
    disk.mkdir()
    program = [*WITH_SMALL_DISK, str(disk)]
    if subprocess.run([*program, "true"], check=False, capture_output=True).returncode:
        pytest.skip("nobody may mount a file system in a name space of their own here")
    warm()  # before the test looks at clocks
    environment = {"TRACKSWEEP_LEASE_S": str(LEASE_S)}
    service = OnSmallDisk(disk / "data", "--workers", "1", program=[*program, *PROGRAM], **environment)
    try:
        yield service
    finally:
        service.http.close()
        service.process.kill()
        service.process.communicate()


def test_a_full_disk_loses_nothing(service: OnSmallDisk) -> None:
    profile = "".join(f"{n / 100},{n % 7 * 1e-4}\n" for n in range(200_000))

    def store() -> tuple[int, str]:
        answer = service.http.post("/v1/profiles", content=profile, headers={"Content-Type": "text/csv"})
        return answer.status_code, answer.json().get("code", "")

    study_id = service.submit(study(300, window_s=18) | {"keep_history": True})
    until(lambda: service.cases(study_id)[0]["progress"] > 0)
    service.fill()
    full_since = time.monotonic()
    assert store() == (503, "storage-full")
    while time.monotonic() < full_since + 2 * LEASE_S:  # meanwhile the case is computed
        assert service.get("/v1/studies")["items"][0]["state"] == "running"  # reading goes on
    (service.data / "ballast").unlink()

    assert service.ended(study_id)["state"] == "succeeded"
    (case,) = service.cases(study_id)
    assert case["attempt"] == 1
    assert service.get(f"/v1/cases/{case['id']}/history")["samples"] > 0  # its digest is that of what was to be stored
    assert len([file for file in (service.data / "histories").rglob("*") if file.is_file()]) == 1
    assert store() == (201, "")
    assert service.ended(service.submit(study(310)))["state"] == "succeeded"
    assert service.stop() == 0
