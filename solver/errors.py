"""What a solve can end in instead of numbers."""


class SolverError(Exception):
    """A case that cannot be solved. ``code`` is stable and names the reason."""

    code = "solver-error"


class DivergedError(SolverError):
    """The response of a case grew beyond all bounds or stopped being a number."""

    code = "diverged"


class UnresolvedError(SolverError):
    """Mesh and step cannot resolve a case."""

    code = "unresolved"
