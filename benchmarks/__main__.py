"""Run the benchmarks that take minutes, one after the other, and write the page."""

import subprocess
import sys

QUICK = ("contenders", "growth", "floor", "choices", "memory", "service", "load", "page", "large", "peaks")

for name in QUICK:  # each in a process of its own: what one leaves in memory slows no other
    print(f"\n{name}", flush=True)
    subprocess.run([sys.executable, "-m", f"benchmarks.{name}"], check=True)  # noqa: S603
subprocess.run([sys.executable, "-m", "benchmarks.report"], check=True)
