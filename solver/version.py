"""The version of the numbers: it changes when, and only when, a stored peak would change."""

SOLVER_VERSION = "3"
