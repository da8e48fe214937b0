"""``python -m tests.chaos``: break the service on purpose, check what is left, write the report.

``run`` makes one run and writes its record; ``report`` checks records and writes what was found. Exit code 1 if a rule
is violated, or if none is in a run whose leases were crippled.
"""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

from tests.chaos.checker import check
from tests.chaos.record import read

# What a control takes away, and how.
CONTROLS = {
    "no-tokens": {"CHAOS_WITHOUT_TOKENS": "1"},  # who lost a lease may still write
    "no-expiry": {"TRACKSWEEP_LEASE_S": "3600"},  # who is silent is waited for
}
CONTROL_CALM_S = 20.0  # what is lost does not come by waiting


def main() -> None:
    """Entry point."""
    parser = argparse.ArgumentParser(prog="python -m tests.chaos")
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("run", help="one run")
    run.add_argument("record", type=Path)
    kinds = ["sqlite", "postgresql", "hosts"]
    run.add_argument("--database", choices=kinds, required=True, help="hosts: PostgreSQL and a network; takes root")
    run.add_argument("--faults", type=int, default=75)
    run.add_argument("--seed", type=int, default=1)
    run.add_argument("--control", choices=CONTROLS)
    report = commands.add_parser("report", help="check records")
    report.add_argument("records", type=Path, nargs="+")
    report.add_argument("--out", type=Path, help="where to write the report")
    options = parser.parse_args()
    if options.command == "run":
        with_own_mounts()
        run_once(options)
    else:
        from tests.chaos.report import write  # noqa: PLC0415

        sys.exit(write(options.records, options.out))


def with_own_mounts() -> None:
    """Begin anew where mounts are this process's own and end with it, if that is permitted: a disk can be filled."""
    if "CHAOS_MOUNTS" in os.environ or not (unshare := shutil.which("unshare")):
        return
    command = [unshare, *([] if os.geteuid() == 0 else ["--user", "--map-root-user"]), "--mount", "--"]
    if subprocess.run([*command, "true"], check=False, capture_output=True).returncode == 0:
        arguments = [*command, sys.executable, "-m", "tests.chaos", *sys.argv[1:]]
        os.execve(unshare, arguments, os.environ | {"CHAOS_MOUNTS": "own"})


def run_once(options: argparse.Namespace) -> None:
    """One run, and what is wrong after it."""
    from tests.chaos.campaign import run  # noqa: PLC0415

    options.record.parent.mkdir(parents=True, exist_ok=True)
    names = ("database", "faults", "seed")
    run_of = {"file": options.record, **{name: getattr(options, name) for name in names}}
    if options.control:
        run_of |= {"control": options.control, "environment": CONTROLS[options.control], "calm_s": CONTROL_CALM_S}
    run(**run_of)
    violated = {rule: found for rule, found in check(read(options.record)).items() if found}
    for rule, found in violated.items():
        print(f"{rule.replace('_', ' ')}: {len(found)} violations", *found[:5], sep="\n  ")
    sys.exit(bool(violated) != bool(options.control))


if __name__ == "__main__":
    main()
