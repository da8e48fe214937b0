"""Checks of the solver against answers found in other ways, and the report on them."""
