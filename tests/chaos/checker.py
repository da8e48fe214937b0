"""What must hold after any number of faults: a pure function over the record of a run.

Every rule yields one sentence for each violation it finds.
"""

import json
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import inf

from tests.chaos.record import Line

ENDED = {"succeeded", "failed", "cancelled"}
STUDY_ENDED = {"succeeded", "partially_failed", "failed", "cancelled"}
MAX_REPEATED = 0.2  # of all computations that were begun
COPIED_S = 0.15  # how late a change may be copied to the record
MARGIN_S = 1.0  # on a machine that has other things to do

# From which state to which a case may go; None is where there is no case.
MOVES = {
    (None, "queued"),
    ("queued", "running"),
    ("queued", "cancelled"),
    ("queued", "failed"),  # by a worker that can compute nothing
    ("running", "queued"),
    *(("running", state) for state in ENDED),
    *((state, "queued") for state in ENDED),
    ("failed", None),
    ("cancelled", None),
}


@dataclass(frozen=True)
class Facts:
    """A record, sorted by what is asked of it."""

    lines: Sequence[Line]

    def of(self, kind: str) -> list[Line]:
        return [line for line in self.lines if line["kind"] == kind]

    @cached_property
    def settings(self) -> Line:
        return self.of("settings")[0]

    @cached_property
    def remains(self) -> Line:
        return self.of("remains")[-1]

    @cached_property
    def answers(self) -> list[Line]:
        return self.of("answer")

    @cached_property
    def changes(self) -> list[Line]:
        """In the order in which they were made: whoever changes a case holds the lock of its row."""
        return sorted(self.of("change"), key=lambda line: line["n"])

    @cached_property
    def of_cases(self) -> dict[int, list[Line]]:
        found = defaultdict(list)
        for line in self.changes:
            if line["what"] == "case":
                found[line["case_id"]].append(line)
        return found

    @cached_property
    def sweeps(self) -> list[float]:
        """When leases were looked at. A worker's first sweep, and the first after the database was away, does not."""
        times, last = [], {}
        for line in self.changes:
            if line["what"] == "sweep":
                if line["t"] - last.get(line["worker"], -inf) < 3 * self.settings["sweep_s"]:
                    times.append(line["t"])
                last[line["worker"]] = line["t"]
        return sorted(times)

    @cached_property
    def deleted(self) -> set[str]:
        return {line["study_id"] for line in self.changes if line["what"] == "study" and line["now"] == "deleted"}


def every_accepted_study_ends(facts: Facts) -> Iterator[str]:
    states = {study["id"]: study["state"] for study in facts.remains["studies"]}
    for study_id in {answer["id"] for answer in facts.answers if answer["key"] and answer["status"] == 201}:
        if study_id not in states and study_id not in facts.deleted:
            yield f"study {study_id} was accepted and is lost"
        elif states.get(study_id, "cancelled") not in STUDY_ENDED:
            yield f"study {study_id} was accepted and is {states[study_id]} for ever"


def every_request_has_one_study(facts: Facts) -> Iterator[str]:
    answers = defaultdict(set)
    for answer in facts.answers:
        if answer["key"] and answer["status"] == 201:
            answers[answer["key"]].add(answer["id"])
    yield from (f"request {key} was answered with studies {ids}" for key, ids in answers.items() if len(ids) > 1)
    names = Counter(study["name"] for study in facts.remains["studies"])
    yield from (f"request {name} made {n} studies" for name, n in names.items() if n > 1)


def every_answer_is_expected(facts: Facts) -> Iterator[str]:
    for answer in facts.answers:
        status, what = answer["status"], f"{answer['method']} {answer['path']}"
        if status >= 400 and not answer["again"] and not (status == 404 and answer["study"] in facts.deleted):
            yield f"{what} was answered {status} {answer.get('code', '')}, and not to come back"
        elif not answer.get("whole", True):
            yield f"{what} was answered with other bytes than its ETag says"
    yield from (f"{line['method']} {line['path']} was never answered" for line in facts.of("gave up"))


def peaks_and_success_go_together(facts: Facts) -> Iterator[str]:
    for case in facts.remains["cases"]:
        if case["state"] == "succeeded" and case["set"] != facts.settings["complete_set"]:
            yield f"case {case['id']} succeeded with {case['peaks']} peaks, which are not one complete set"
        elif case["state"] != "succeeded" and case["peaks"]:
            yield f"case {case['id']} is {case['state']} and has {case['peaks']} peaks"


def histories_are_there_and_whole(facts: Facts) -> Iterator[str]:
    states = {case["id"]: case["state"] for case in facts.remains["cases"]}
    found = {history["case_id"]: history["found"] for history in facts.remains["histories"]}
    for case_id, what in found.items():
        if what != "history":
            yield f"the history of case {case_id} is told of, and there is {what}"
        if states[case_id] != "succeeded":
            yield f"case {case_id} is {states[case_id]} and has a history"
    for study in facts.remains["studies"]:
        if study["keep_history"] and study["state"] != "cancelled":
            for case_id in study["cases"]:
                if states[case_id] == "succeeded" and case_id not in found:
                    yield f"case {case_id} succeeded without the history that study {study['id']} keeps"


def no_case_is_done_twice(facts: Facts) -> Iterator[str]:
    """Whoever ends a case has claimed it last, and nobody ended it since."""
    for case_id, moves in facts.of_cases.items():
        holder = None
        for move in moves:
            was, now = move.get("was"), move.get("now")
            if (was, now) not in MOVES:
                yield f"case {case_id} went from {was} to {now} by {move.get('worker')}"
            if was == "running" and move.get("was_token") != holder:
                yield f"case {case_id} was ended by {move.get('worker')}, who did not hold it"
            holder = move.get("token")


def attempts_stay_within_the_limit(facts: Facts) -> Iterator[str]:
    limit = facts.settings["max_attempts"]
    for case in facts.remains["cases"]:
        if case["attempt"] > limit:
            yield f"case {case['id']} was tried {case['attempt']} times"
        if case["state"] == "failed" and not (
            case["error"] == "diverged" or (case["error"] == "poison" and case["attempt"] == limit)
        ):
            yield f"case {case['id']} failed after {case['attempt']} attempts: {case['error']}"


def studies_hear_of_every_end_once(facts: Facts) -> Iterator[str]:
    """One event for every case that ends in a study that is live; and ``done`` after the last one."""
    containing: dict[int, set[str]] = defaultdict(set)
    live: set[str] = set()
    due: Counter[tuple[str, int]] = Counter()
    last: dict[str, str] = {}
    for line in facts.changes:
        if line["what"] == "link":
            containing[line["case_id"]].add(line["study_id"])
        elif line["what"] == "study":
            (live.add if line["now"] == "live" else live.discard)(line["study_id"])
        elif line["what"] == "event":
            last[line["study_id"]] = line["now"]
            if line["now"] == "case":
                due[line["study_id"], json.loads(line["detail"])["case_id"]] -= 1
        elif line["what"] == "case" and line.get("now") in ("succeeded", "failed"):
            due.update((study_id, line["case_id"]) for study_id in containing[line["case_id"]] & live)
    for (study_id, case_id), n in due.items():
        if n:
            yield f"study {study_id} heard {-n:+d} times too often of case {case_id}"
    for study in facts.remains["studies"]:
        if study["state"] in STUDY_ENDED and last.get(study["id"]) != "done":
            yield f"study {study['id']} ended, and the last it heard is {last.get(study['id'])}"


def followers_miss_nothing(facts: Facts) -> Iterator[str]:
    events = defaultdict(list)
    for line in facts.changes:
        if line["what"] == "event":
            events[line["study_id"]].append(line["attempt"])
    for line in facts.of("heard"):
        heard, all_of_it = line["events"], sorted(events[line["study"]])
        if heard != all_of_it[: len(heard)]:
            yield f"a follower of study {line['study']} heard {heard} of {all_of_it}"
        elif not line["ended"]:
            yield f"a follower of study {line['study']} never heard its end"


def silent_workers_are_noticed(facts: Facts) -> Iterator[str]:
    for case_id, _, took_s, allowed_s in recoveries(facts):
        if took_s > allowed_s:
            yield f"case {case_id} waited {took_s:.1f} s for a silent worker; {allowed_s:.1f} s were allowed"


def little_is_computed_twice(facts: Facts) -> Iterator[str]:
    begun, repeated = computations(facts)
    if repeated > MAX_REPEATED * begun:
        yield f"{repeated} of {begun} computations were repetitions"


def stored_peaks_are_right(facts: Facts) -> Iterator[str]:
    for verification in facts.remains["verifications"]:
        if verification["outcome"] != "same":
            found = verification["outcome"] or verification["state"]
            yield f"case {verification['case_id']}, computed once more: {found}"


RULES: tuple[Callable[[Facts], Iterator[str]], ...] = (
    every_accepted_study_ends,
    every_request_has_one_study,
    every_answer_is_expected,
    peaks_and_success_go_together,
    histories_are_there_and_whole,
    no_case_is_done_twice,
    attempts_stay_within_the_limit,
    studies_hear_of_every_end_once,
    followers_miss_nothing,
    silent_workers_are_noticed,
    little_is_computed_twice,
    stored_peaks_are_right,
)


def check(lines: Sequence[Line]) -> dict[str, list[str]]:
    """Violations by rule; of a rule that holds, none."""
    facts = Facts(lines)
    return {rule.__name__: list(rule(facts)) for rule in RULES}


def computations(facts: Facts) -> tuple[int, int]:
    """How many computations were begun, and how many of them only because an earlier one came to nothing."""
    moves = [(line.get("was"), line.get("now")) for line in facts.changes if line["what"] == "case"]
    begun = sum(now == "running" for _, now in moves)
    ended = sum(was == "running" and now in ENDED for was, now in moves)
    return begun, begun - ended


def recoveries(facts: Facts) -> Iterator[tuple[int, float, float, float]]:
    """Of every case whose worker fell silent: the case, when that was, how long until it was queued again, and how long
    that may take: the lease and a sweep, and for as long more as no sweep could be made or somebody else fell silent,
    maybe amid a sweep: then PostgreSQL takes the locks away after a lease (`test_lease.py`).
    """
    lease_s, sweep_s = facts.settings["lease_s"], facts.settings["sweep_s"]
    for fault in facts.of("fault"):
        silent = fault.get("silences")
        for case_id, moves in facts.of_cases.items() if silent else ():
            before = [move for move in moves if move["t"] <= fault["began"] + COPIED_S]
            after = moves[len(before) :]
            if not before or before[-1].get("now") != "running" or before[-1].get("worker") != silent or not after:
                continue
            if after[0].get("now") == "queued":
                began, took_s = fault["began"], after[0]["t"] - fault["began"]
                held_up_s = _without_sweeps(facts, began, began + took_s) + _behind_others(facts, fault, began + took_s)
                yield case_id, began, took_s, lease_s + sweep_s + MARGIN_S + held_up_s


def _behind_others(facts: Facts, fault: Line, end: float) -> float:
    """For how long after a fault other workers may have held locks that they were silenced with."""
    later = (each for each in facts.of("fault") if each.get("silences") and fault["began"] < each["began"] < end)
    return sum(min(end, each["t"], each["began"] + facts.settings["lease_s"]) - each["began"] for each in later)


def _without_sweeps(facts: Facts, begin: float, end: float) -> float:
    """How much of an interval was more than the usual pause after the last sweep."""
    times = [t for t in facts.sweeps if begin < t < end]
    last = max((t for t in facts.sweeps if t <= begin), default=begin)
    gaps = zip([last, *times], [*times, end], strict=True)
    return sum(max(0.0, min(b - a, b - begin) - facts.settings["sweep_s"]) for a, b in gaps)
