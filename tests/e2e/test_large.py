"""The largest study that is accepted, in memory that does not grow with it where it need not."""

import pytest

from benchmarks.large import SIZES, TOO_MANY, handled


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_the_largest_study_is_handled_in_bounded_memory() -> None:
    """`python -m benchmarks.large` prints the same figures, and seconds."""
    small, large = ({name: mb for name, (_, mb) in handled(cases).items()} for cases in SIZES)
    assert max(large.values()) < 250
    for name in ("list", "export as csv", "export as parquet"):
        assert large[name] < small[name] + 20
    assert large[f"refuse {TOO_MANY} cases"] < 50
