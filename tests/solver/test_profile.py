import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver.case import Measured
from solver.profile import MAX_POINTS, read_profile
from solver.quantity import InvalidParameterError


@pytest.mark.parametrize("separator", [",", ";", "\t", " ", " , ", "   "])
def test_two_columns_in_metres(separator):
    lines = [f"{x}{separator}{height}" for x, height in ((0, "1e-3"), (0.25, -0.002), ("0.5", 0))]
    assert read_profile("\n".join(lines)) == ((0.0, 0.25, 0.5), (1e-3, -0.002, 0.0))


@pytest.mark.parametrize(
    ("header", "scale"),
    [
        ("x,eta", (1, 1)),
        ("x_m,eta_mm", (1, 1e-3)),
        ("x [m];η [mm]", (1, 1e-3)),
        ("Position (m)\tHeight (MM)", (1, 1e-3)),
        ("mm,m", (1e-3, 1)),
        ("distance in m, irregularity in mm", (1, 1e-3)),
        ("chainage,comment", (1, 1)),
        ("# a comment that says mm", (1, 1)),
        ("\n\n", (1, 1)),
    ],
)
def test_a_header_may_name_the_units(header, scale):
    positions, heights = read_profile(f"\ufeff{header}\r\n1,0.02\r\n\r\n# a remark\r\n3,-0.04\r\n")
    assert positions == pytest.approx((1 * scale[0], 3 * scale[0]))
    assert heights == pytest.approx((0.02 * scale[1], -0.04 * scale[1]))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0,0\n1,zero", "line 2 must be two numbers, is '1,zero'"),
        ("0,0\n1", "line 2 must be two numbers"),
        ("0,0,0", "line 1 must be two numbers"),
        ("0,0\n\n1,5;0,3", "line 3 must be two numbers"),
        ("x,eta\n0,0\n1,nan", "line 3 must be two finite numbers"),
        ("0,0\n1,inf", "line 2 must be two finite numbers"),
        ("0,0\n1e999,0", "line 2 must be two finite numbers"),
        ("0,0\n2,0\n1,0", "line 3 must lie beyond 2 m, is 1 m"),
        ("0,0\n2,0\n2,0", "line 3 must lie beyond 2 m, is 2 m"),
        ("x_cm,eta\n0,0", "line 1 must name m or mm, not cm"),
        ("x,y,z\n0,0", "line 1 must name two columns"),
        ("x,eta\nx,eta\n0,0", "line 2 must be two numbers"),
        ("\n".join(f"{n},0" for n in range(MAX_POINTS + 1)), f"line {MAX_POINTS + 1} is one too many"),
    ],
)
def test_what_is_wrong_is_refused_with_its_line(text, message):
    with pytest.raises(InvalidParameterError, match=message):
        read_profile(text)


@given(st.text(max_size=200))
def test_any_text_is_read_or_refused(text):
    points, refused = ((), ()), "line "
    try:
        points = read_profile(text)
    except InvalidParameterError as error:
        refused = error.parameter
    assert len(points[0]) == len(points[1])
    assert refused.startswith("line ")


def test_what_was_read_makes_a_profile():
    positions, heights = read_profile("x_m,eta_mm\n" + "\n".join(f"{n / 4},{n % 3}" for n in range(200)))
    measured = Measured(positions=positions, heights=heights, wavelength_min=2.0, wavelength_max=30.0)
    assert max(measured.heights) == pytest.approx(2e-3)
