"""Run the benchmarks."""

from benchmarks.operators import main

main()
