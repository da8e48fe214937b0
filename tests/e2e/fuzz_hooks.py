"""What Schemathesis is to know of the service beyond its schema."""

import re
from pathlib import Path

import schemathesis
from schemathesis.specs.openapi.checks import positive_data_acceptance

PROBLEMS = (Path(__file__).parents[2] / "docs/problems.md").read_text()
# Rules that no schema can say: each is documented by name.
DOCUMENTED = set(re.findall(r"^\| `([a-z-]+)` \| (?!\d)", PROBLEMS, re.MULTILINE)) | {"too-many-peaks"}
KEY = re.compile(r"[\x20-\x7e]{1,255}")
SENT = set()


@schemathesis.hook
def before_call(ctx, case, kwargs):  # type: ignore[no-untyped-def]
    """Send no key twice: the first answer would come again, or what is asked for would not be looked at."""
    key = (case.headers or {}).get("Idempotency-Key", "")
    if key in SENT:
        del case.headers["Idempotency-Key"]
    elif KEY.fullmatch(key):
        SENT.add(key)


@schemathesis.check
def schema_valid_is_accepted(ctx, response, case):  # type: ignore[no-untyped-def]
    """Like ``positive_data_acceptance``, but a request may break a documented rule that the schema cannot say."""
    if response.status_code == 422:
        problem = response.json()
        codes = {error["code"] for error in problem["errors"]} or {problem["code"]}
        if codes <= DOCUMENTED:
            return None
    return positive_data_acceptance(ctx, response, case)
