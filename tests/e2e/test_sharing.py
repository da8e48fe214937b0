"""Two users whose studies overlap."""

import json
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest

from tests.e2e.conftest import Served, study, tracksweep
from tracksweep_client import ProblemError, Service
from tracksweep_client.generated.api.catalogue import get_limits
from tracksweep_client.generated.api.studies import delete_study
from tracksweep_client.generated.models import Limits, PeakRow


def user(service: Served, name: str) -> Service:
    command = ("keys", "create", name, "--scope", "write", "--json")
    made = tracksweep(*command, TRACKSWEEP_DATA_DIR=service.data)
    return Service(str(service.http.base_url), json.loads(made.stdout)["key"])


@pytest.fixture
def users(service: Served) -> Iterator[list[Service]]:
    users = [user(service, "anna"), user(service, "ben")]
    yield users
    for each in users:
        each.close()


def charged_s(user: Service) -> float:
    limits = get_limits.sync(client=user.client)
    assert isinstance(limits, Limits)
    return limits.caller.cpu_s_last_day


def peaks(user: Service) -> dict[float, list[PeakRow]]:
    """Everything that a user sees, by speed."""
    found: dict[float, list[PeakRow]] = {}
    for peak in user.peaks(page_size=500):
        found.setdefault(peak.speed_kmh, []).append(peak)
    return found


def test_what_two_ask_for_at_once_is_computed_once_and_whole_for_either(users: list[Service]) -> None:
    with ThreadPoolExecutor(2) as pool:
        ids = list(pool.map(lambda user, own: user.submit(study(own, 223, 227)).id, users, (211, 239)))
    for user, submitted in zip(users, ids, strict=True):
        assert user.wait(submitted, progress=False).state == "succeeded"
    cases = {case.id: case for user, submitted in zip(users, ids, strict=True) for case in user.cases(submitted)}
    assert sorted(case.speed_kmh for case in cases.values()) == [211, 223, 227, 239]
    assert {case.attempt for case in cases.values()} == {1}
    assert sum(map(charged_s, users)) == pytest.approx(sum(case.cpu_s or 0 for case in cases.values()))

    anna, ben = users
    annas, bens = map(peaks, users)
    assert annas.keys() == {211, 223, 227}
    assert bens.keys() == {239, 223, 227}
    assert annas[223] == bens[223]
    assert len({len(of_case) for of_case in (*annas.values(), *bens.values())}) == 1

    delete_study.sync_detailed(ids[0], client=anna.client)
    with pytest.raises(ProblemError, match="no such study"):
        anna.study(ids[0])
    assert peaks(anna) == {}
    assert (ben.study(ids[1]).state, peaks(ben)) == ("succeeded", bens)
