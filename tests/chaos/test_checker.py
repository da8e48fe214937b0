"""The checker on records made by hand: a sound one, and one violation after another."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.chaos.checker import check
from tests.chaos.report import write

Lines = list[dict[str, Any]]
LEASE_S, SWEEP_S = 2.0, 0.5


class Story:
    """A run in which one study of two cases is accepted, computed and read."""

    def __init__(self) -> None:
        self.lines: Lines = [
            {
                "t": 0.0,
                "kind": "settings",
                "database": "sqlite",
                "seed": 1,
                "control": "",
                "lease_s": LEASE_S,
                "sweep_s": SWEEP_S,
                "max_attempts": 3,
                "complete_set": "all",
            }
        ]
        self.n = 0
        self.answer("POST", "/v1/studies", key="key", status=201, id="s")
        self.change("study", study_id="s", now="live")
        for case in (1, 2):
            self.move(case, None, "queued")
            self.change("link", study_id="s", case_id=case)
        self.event("state")
        for case in (1, 2):
            self.move(case, "queued", "running", token=f"token {case}", worker="host:1")
            self.sweep()
        for case in (1, 2):
            self.end(case)
        self.event("state")
        self.event("done")
        self.heard = self.add("heard", study="s", events=[1, 2, 3, 4, 5], ended=True)
        self.studies = [{"id": "s", "name": "key", "state": "succeeded", "keep_history": True, "cases": [1, 2]}]
        self.cases = [
            {"id": n, "state": "succeeded", "attempt": 1, "error": None, "peaks": 9, "set": "all"} for n in (1, 2)
        ]
        self.histories = [{"case_id": n, "key": f"key {n}", "found": "history"} for n in (1, 2)]
        self.verifications: Lines = [{"case_id": 1, "state": "succeeded", "outcome": "same"}]

    @property
    def record(self) -> Lines:
        remains = {name: getattr(self, name) for name in ("studies", "cases", "histories", "verifications")}
        return [*self.lines, {"t": self.t, "kind": "remains"} | remains]

    @property
    def t(self) -> float:
        return float(self.lines[-1]["t"]) + 0.2

    def add(self, kind: str, **fields: Any) -> dict[str, Any]:
        self.lines.append({"t": self.t, "kind": kind} | fields)
        return self.lines[-1]

    def answer(self, method: str, path: str, *, status: int = 200, key: str = "", study: str = "", **more: Any) -> None:
        about = {"method": method, "path": path, "status": status, "key": key, "study": study}
        self.add("answer", **about, again=False, **more)

    def change(self, what: str, **fields: Any) -> dict[str, Any]:
        self.n += 1
        return self.add("change", n=self.n, what=what, **fields)

    def move(self, case: int, was: str | None, now: str, **fields: Any) -> dict[str, Any]:
        return self.change("case", case_id=case, was=was, now=now, **fields)

    def event(self, kind: str, detail: str = "{}") -> None:
        number = sum(line.get("what") == "event" for line in self.lines) + 1
        self.change("event", study_id="s", now=kind, attempt=number, detail=detail)

    def end(self, case: int, token: str = "token {}", worker: str = "host:1") -> None:
        self.move(case, "running", "succeeded", was_token=token.format(case), worker=worker)
        self.event("case", f'{{"case_id": {case}}}')

    def sweep(self) -> None:
        self.change("sweep", worker="host:1")


def broken(record: Lines) -> dict[str, list[str]]:
    return {rule: found for rule, found in check(record).items() if found}


def test_a_sound_record_has_no_violation() -> None:
    assert broken(Story().record) == {}


def lose_a_study(story: Story) -> None:
    story.studies.clear()


def leave_a_study(story: Story) -> None:
    story.studies[0]["state"] = "running"


def double_a_study(story: Story) -> None:
    story.studies.append(story.studies[0] | {"id": "another"})


def answer_twice(story: Story) -> None:
    story.answer("POST", "/v1/studies", key="key", status=201, id="another")


def fail_to_answer(story: Story) -> None:
    story.answer("GET", "/v1/studies/s", status=500)


def turn_away_for_ever(story: Story) -> None:
    story.answer("GET", "/v1/studies/s", status=503)


def send_other_bytes(story: Story) -> None:
    story.answer("GET", "/v1/cases/1/history.npz", whole=False)


def give_up(story: Story) -> None:
    story.add("gave up", method="GET", path="/v1/studies/s")


def lose_a_peak(story: Story) -> None:
    story.cases[0] |= {"peaks": 8, "set": "all but one"}


def leave_peaks(story: Story) -> None:
    story.cases[0] |= {"state": "failed", "error": "diverged"}
    story.histories.pop(0)


def damage_a_history(story: Story) -> None:
    story.histories[0]["found"] = "other bytes"


def lose_a_history(story: Story) -> None:
    story.histories.pop()


def commit_twice(story: Story) -> None:
    story.move(1, "succeeded", "succeeded", worker="host:2")


def commit_as_somebody_else(story: Story) -> None:
    story.move(1, "succeeded", "queued")
    story.move(1, "queued", "running", token="new", worker="host:2")
    story.end(1, token="old", worker="host:1")


def try_too_often(story: Story) -> None:
    story.cases[0]["attempt"] = 4


def give_up_too_early(story: Story) -> None:
    story.cases[0] |= {"state": "failed", "error": "poison", "attempt": 2, "peaks": 0}
    story.histories.pop(0)


def tell_twice(story: Story) -> None:
    story.event("case", '{"case_id": 1}')
    story.event("done")


def tell_nothing(story: Story) -> None:
    story.lines = [line for line in story.lines if line.get("what") != "event" or line["now"] != "case"]
    story.heard["events"] = [1, 4, 5]


def end_in_silence(story: Story) -> None:
    story.event("state")


def miss_an_event(story: Story) -> None:
    story.heard["events"] = [1, 2, 4, 5]


def never_hear_the_end(story: Story) -> None:
    story.heard["ended"] = False


def fall_silent(story: Story, *, noticed_s: float, swept: bool, stopped_s: float = 0.0) -> None:
    story.move(1, "succeeded", "queued")
    story.move(1, "queued", "running", token="new", worker="host:2")
    began = story.t
    story.add("fault", fault="kill_worker", began=began, silences="host:2")
    while swept and story.t < began + noticed_s:
        story.sweep()
    stopped = {"kind": "fault", "fault": "stop_worker", "began": began + 1.0, "silences": "host:3"}
    story.lines += [stopped | {"t": began + 1.0 + stopped_s}, {"t": began + noticed_s, "kind": "idle"}]
    story.move(1, "running", "queued", was_token="new")
    story.move(1, "queued", "running", token="newer", worker="host:1")
    story.end(1, token="newer")
    story.event("done")


def notice_late(story: Story) -> None:
    fall_silent(story, noticed_s=5.0, swept=True)


def notice_later_than_locks_last(story: Story) -> None:
    fall_silent(story, noticed_s=6.0, swept=True, stopped_s=4.0)


def compute_twice(story: Story) -> None:
    for n in range(3):
        story.move(1, "succeeded" if n == 0 else "running", "queued", was_token=f"again {n - 1}" if n else None)
        story.move(1, "queued", "running", token=f"again {n}")
    story.end(1, token="again 2")
    story.event("done")


def store_wrong_peaks(story: Story) -> None:
    story.verifications[0]["outcome"] = "differs"


@pytest.mark.parametrize(
    ("spoil", "rule"),
    [
        (lose_a_study, "every_accepted_study_ends"),
        (leave_a_study, "every_accepted_study_ends"),
        (double_a_study, "every_request_has_one_study"),
        (answer_twice, "every_request_has_one_study"),
        (fail_to_answer, "every_answer_is_expected"),
        (turn_away_for_ever, "every_answer_is_expected"),
        (send_other_bytes, "every_answer_is_expected"),
        (give_up, "every_answer_is_expected"),
        (lose_a_peak, "peaks_and_success_go_together"),
        (leave_peaks, "peaks_and_success_go_together"),
        (damage_a_history, "histories_are_there_and_whole"),
        (lose_a_history, "histories_are_there_and_whole"),
        (commit_twice, "no_case_is_done_twice"),
        (commit_as_somebody_else, "no_case_is_done_twice"),
        (try_too_often, "attempts_stay_within_the_limit"),
        (give_up_too_early, "attempts_stay_within_the_limit"),
        (tell_twice, "studies_hear_of_every_end_once"),
        (tell_nothing, "studies_hear_of_every_end_once"),
        (end_in_silence, "studies_hear_of_every_end_once"),
        (miss_an_event, "followers_miss_nothing"),
        (never_hear_the_end, "followers_miss_nothing"),
        (notice_late, "silent_workers_are_noticed"),
        (notice_later_than_locks_last, "silent_workers_are_noticed"),
        (compute_twice, "little_is_computed_twice"),
        (store_wrong_peaks, "stored_peaks_are_right"),
    ],
)
def test_a_violation_is_found(spoil: Callable[[Story], None], rule: str) -> None:
    story = Story()
    spoil(story)
    assert rule in broken(story.record)


@pytest.mark.parametrize(("noticed_s", "swept", "stopped_s"), [(2.4, True, 0), (5.0, False, 0), (5.0, True, 2.0)])
def test_a_silent_worker_is_waited_for_as_long_as_its_lease_and_until_somebody_sweeps_or_gives_up_locks(
    noticed_s: float, stopped_s: float, *, swept: bool
) -> None:
    story = Story()
    fall_silent(story, noticed_s=noticed_s, swept=swept, stopped_s=stopped_s)
    assert not check(story.record)["silent_workers_are_noticed"]


def test_the_report_says_what_was_found_and_whether_that_is_as_it_should_be(tmp_path: Path) -> None:
    """No violation in a run, and some in a control."""

    def reported(control: str, spoil: Callable[[Story], None] | None) -> tuple[int, str]:
        story = Story()
        story.lines[0]["control"] = control
        story.add("fault", fault="kill_worker", began=story.t)
        if spoil is not None:
            spoil(story)
        (tmp_path / "record.jsonl").write_text("".join(json.dumps(line) + "\n" for line in story.record))
        return write([tmp_path / "record.jsonl"], tmp_path / "report.md"), (tmp_path / "report.md").read_text()

    code, page = reported("", None)
    assert code == 0
    assert "| kill worker | 1 |" in page
    assert "| no case is done twice | 0 |" in page
    code, page = reported("", commit_twice)
    assert code == 1
    assert "| no case is done twice | 1 |" in page
    assert reported("no-tokens", None)[0] == 1
    assert reported("no-tokens", commit_twice)[0] == 0
