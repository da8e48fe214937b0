from typing import Literal

CallerLimitsScope = Literal["admin", "read", "write"]

CALLER_LIMITS_SCOPE_VALUES: set[CallerLimitsScope] = {
    "admin",
    "read",
    "write",
}


def check_caller_limits_scope(value: str) -> CallerLimitsScope:
    if value in CALLER_LIMITS_SCOPE_VALUES:
        return value
    raise TypeError(f"Unexpected value {value!r}. Expected one of {CALLER_LIMITS_SCOPE_VALUES!r}")
