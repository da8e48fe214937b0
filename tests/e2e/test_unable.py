"""A solver that cannot be loaded."""

import shutil
from pathlib import Path

from tests.e2e.conftest import served, study, until


def test_cases_fail_for_want_of_a_solver_and_can_be_retried_once_there_is_one(tmp_path: Path) -> None:
    broken = tmp_path / "broken" / "numba"
    broken.mkdir(parents=True)
    (broken / "__init__.py").write_text("raise ImportError('built for another machine')")
    with served(tmp_path / "data", "--workers", "1", PYTHONPATH=str(broken.parent)) as service:
        study_id = service.submit(study(300, 310))
        assert service.ended(study_id)["state"] == "failed"
        for case in service.cases(study_id):
            assert case["error"]["code"] == "solver-unavailable"
            assert "built for another machine" in case["error"]["detail"]
        shutil.rmtree(broken)
        (worker,) = service.parts("worker")
        worker.kill()
        until(lambda: [part for part in service.parts("worker") if part.pid != worker.pid])
        service.http.post(f"/v1/studies/{study_id}/retry").raise_for_status()
        assert service.ended(study_id)["state"] == "succeeded"
