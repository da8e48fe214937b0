"""``docs/reliability.md``: what was broken, what was found."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from statistics import median, quantiles

from tests.chaos.checker import RULES, Facts, check, computations, recoveries
from tests.chaos.record import Line, read

Run = tuple[Facts, dict[str, list[str]]]
TITLES = {"sqlite": "SQLite", "postgresql": "PostgreSQL", "hosts": "five hosts"}


def write(records: Sequence[Path], out: Path | None) -> int:
    """Check records and write the report, or print it. Returns the exit code: 0 if every rule held, and every control
    broke one.
    """
    found = {path: Facts(read(path)) for path in records}
    if broken_off := [path for path, facts in found.items() if not facts.of("remains")]:
        print("Broken off:", *broken_off)
        return 1
    runs = [(facts, check(facts.lines)) for facts in found.values()]
    text = "\n".join(_page([run for run in runs if not _control(run)], [run for run in runs if _control(run)]))
    if out is None:
        print(text)
    else:
        out.write_text(text)
    return int(any(_violations(run) > 0 if not _control(run) else _violations(run) == 0 for run in runs))


def _control(run: Run) -> str:
    return str(run[0].settings["control"])


def _violations(run: Run) -> int:
    return sum(map(len, run[1].values()))


def _page(runs: Sequence[Run], controls: Sequence[Run]) -> Iterator[str]:
    yield (Path(__file__).parent / "report.md").read_text().rstrip()
    yield "\n## What was broken\n"
    databases = {name: [run for run in runs if run[0].settings["database"] == name] for name in TITLES}
    columns = [name for name, of in databases.items() if of]
    facts = [[run[0] for run in databases[name]] for name in columns]
    seeds = [", ".join(str(each.settings["seed"]) for each in of) for of in facts]
    yield from _table(["", *(TITLES[name] for name in columns)], [["seeds", *seeds]])
    kinds = [Counter(line["fault"] for each in of for line in each.of("fault")) for of in facts]
    rows = [[kind.replace("_", " "), *(count[kind] for count in kinds)] for kind in sorted(set().union(*kinds))]
    yield "\n"
    yield from _table(
        ["fault", *(TITLES[name] for name in columns)], [*rows, ["**all**", *(f"**{n.total()}**" for n in kinds)]]
    )
    yield "\n## What came of it\n"
    yield from _table(
        ["", *(TITLES[name] for name in columns)], [[title, *map(figure, facts)] for title, figure in FIGURES.items()]
    )
    yield "\n## Violations\n"
    found = [[run[1] for run in databases[name]] for name in columns]
    yield from _table(
        ["rule", *(TITLES[name] for name in columns), *(_name_of(control) for control in controls)],
        [
            [
                rule.__name__.replace("_", " "),
                *(sum(len(each[rule.__name__]) for each in of) for of in found),
                *(len(control[1][rule.__name__]) for control in controls),
            ]
            for rule in RULES
        ],
    )
    yield ""


def _name_of(control: Run) -> str:
    settings = control[0].settings
    return f"{settings['control']}, {TITLES[settings['database']]}, {len(control[0].of('fault'))} faults"


def _table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield f"|---|{'---:|' * (len(head) - 1)}"
    yield from (f"| {' | '.join(map(str, row))} |" for row in rows)


def _count(kind: str, wanted: Callable[[Line], bool] = lambda line: True) -> Callable[[Sequence[Facts]], str]:
    return lambda of: f"{sum(wanted(line) for each in of for line in each.of(kind)):,}"


def _ended(facts: Sequence[Facts]) -> str:
    return f"{sum(begun - repeated for begun, repeated in map(computations, facts)):,}"


def _repeated(facts: Sequence[Facts]) -> str:
    begun, repeated = (sum(each) for each in zip(*map(computations, facts), strict=True))
    return f"{repeated:,} of {begun:,} ({repeated / begun:.1%})"


def _recovery(facts: Sequence[Facts]) -> str:
    took = sorted(took_s for each in facts for _, _, took_s, _ in recoveries(each))
    if len(took) < 2:
        return "none"
    return f"{median(took):.1f} s, {quantiles(took, n=20)[-1]:.1f} s, {took[-1]:.1f} s ({len(took)} cases)"


def _remaining(what: str) -> Callable[[Sequence[Facts]], str]:
    return lambda of: f"{sum(len(each.remains[what]) for each in of):,}"


FIGURES: dict[str, Callable[[Sequence[Facts]], str]] = {
    "minutes": lambda of: f"{sum(each.lines[-1]['t'] for each in of) / 60:.0f}",
    "studies accepted": lambda of: (
        f"{sum(len({a['id'] for a in e.answers if a['key'] and a['status'] == 201}) for e in of):,}"
    ),
    "cases computed to an end": _ended,
    "computations repeated": _repeated,
    "silent worker noticed after: median, 95 %, longest": _recovery,
    "answers": _count("answer"),
    "answers 503": _count("answer", lambda line: line["status"] == 503),
    "requests without an answer, sent again": _count("no answer"),
    "histories read back": _remaining("histories"),
    "cases computed once more at the end": _remaining("verifications"),
}
