"""From a study over HTTP to its peaks, whatever is killed in between."""

import os
import signal
import sqlite3
import subprocess
from contextlib import closing
from pathlib import Path

import httpx
import psutil
import pytest

from tests.e2e.conftest import PROGRAM, SECONDS_LONG, Served, gone, served, study, tracksweep, until


def test_a_study_over_http_ends_with_its_peaks(service: Served) -> None:
    study_id = service.submit(study(200, 300))
    ended = service.ended(study_id)
    assert (ended["state"], ended["cases"]["succeeded"], ended["progress"]) == ("succeeded", 2, 1)

    peaks = service.get("/v1/peaks", study_id=study_id, quantity="wheel_rail_force", position="wheelset_1")["items"]
    assert sorted(peak["speed_kmh"] for peak in peaks) == [200, 300]
    assert all(peak["unit"] == "N" and 60e3 < peak["peak"] < 200e3 for peak in peaks)

    again = service.http.post("/v1/studies", json=study(200, 300)).json()
    assert (again["state"], again["cases_reused"]) == ("succeeded", 2)


def test_a_case_whose_worker_is_killed_is_solved_again_once(service: Served) -> None:
    study_id = service.submit(study(300, window_s=SECONDS_LONG))
    until(lambda: service.cases(study_id)[0]["progress"] > 0)
    (worker,) = service.parts("worker")
    worker.kill()

    assert service.ended(study_id)["state"] == "succeeded"
    (case,) = service.cases(study_id)
    assert case["attempt"] == 2
    peaks = service.get("/v1/peaks", study_id=study_id, page_size=500)["items"]
    assert len({(peak["quantity"], peak["position"]) for peak in peaks}) == len(peaks) > 0


@pytest.mark.parametrize("part", ["api", "valkey-server"])
def test_a_part_that_crashes_is_restarted(service: Served, part: str) -> None:
    (crashed,) = service.parts(part)
    crashed.kill()
    psutil.wait_procs([crashed], timeout=10)
    # Nobody is refused while the API restarts: the listening socket outlives it, and the request waits.
    assert httpx.get(service.http.base_url.join("/healthz"), timeout=60).is_success
    until(lambda: [running for running in service.parts(part) if running.pid != crashed.pid])
    speed = 210 if part == "api" else 220  # new cases, which workers must hear of
    assert service.ended(service.submit(study(speed)))["state"] == "succeeded"


def test_processes_that_answer_stand_in_for_one_another(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--workers", "0", TRACKSWEEP_API_PROCESSES="2") as service:
        one, other = service.parts("api")
        body, key = study(300), {"Idempotency-Key": "one"}
        created = service.http.post("/v1/studies", json=body, headers=key).json()["id"]
        for process in (one, other):
            process.suspend()
            again = httpx.post(service.http.base_url.join("/v1/studies"), json=body, headers=key, timeout=60)
            assert again.json()["id"] == created
            process.resume()


def test_a_second_service_on_the_same_folder_is_refused(service: Served) -> None:
    second = tracksweep("serve", "--data", service.data, "--port", 0)
    assert second.returncode == 2
    assert f"Another service runs on {service.data} (process {service.process.pid})." in second.stderr


def test_a_port_that_is_taken_is_named(service: Served, tmp_path: Path) -> None:
    port = httpx.URL(service.http.base_url).port
    second = tracksweep("serve", "--port", port, "--data", tmp_path / "data")
    assert second.returncode == 2
    assert f"port {port}" in second.stderr


def test_a_study_posted_while_no_worker_runs_is_solved_when_one_starts(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--workers", "0") as service:
        study_id = service.submit(study(250))
        assert [case["state"] for case in service.cases(study_id)] == ["queued"]
        with subprocess.Popen([*PROGRAM, "worker"], env=service.environment, stderr=subprocess.DEVNULL) as worker:
            assert service.ended(study_id)["state"] == "succeeded"
            worker.kill()


def test_a_study_survives_the_whole_service_killed(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--workers", "1") as before:
        study_id = before.submit(study(300, window_s=SECONDS_LONG))
        until(lambda: before.cases(study_id)[0]["progress"] > 0)
        parts = before.supervisor.children(recursive=True)
        before.process.send_signal(signal.SIGKILL)
        before.process.wait()
        psutil.wait_procs(parts, timeout=10)
        assert len(parts) >= 3
        assert all(map(gone, parts))
    with served(tmp_path / "data", "--workers", "1") as after:
        assert after.ended(study_id)["state"] == "succeeded"
        assert [case["attempt"] for case in after.cases(study_id)] == [2]


def test_workers_stand_back_for_other_processes(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--workers", "1", TRACKSWEEP_WORKER_NICE="7") as service:
        service.ended(service.submit(study(300)))
        (worker,) = service.parts("worker")
        assert worker.nice() == 7
        assert os.getsid(worker.pid) == os.getsid(service.supervisor.pid)  # or it would count between sessions only


def test_ctrl_c_ends_every_process_and_puts_back_the_case_at_hand(tmp_path: Path) -> None:
    with served(tmp_path / "data", "--workers", "1") as service:
        study_id = service.submit(study(300, window_s=SECONDS_LONG))
        until(lambda: service.cases(study_id)[0]["progress"] > 0)
        parts = service.supervisor.children(recursive=True)
        assert len(parts) >= 3
        assert service.stop() == 0
        assert all(map(gone, parts))
        assert not (service.data / "serve.json").exists()
    # The worker had the time to put the case back: were its lease left to run out, it would still be running.
    with closing(sqlite3.connect(tmp_path / "data" / "tracksweep.db")) as database:
        assert database.execute('SELECT state, attempt FROM "case"').fetchall() == [("queued", 0)]
