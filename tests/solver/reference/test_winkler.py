import numpy as np
import pytest

from solver.reference.winkler import WinklerBeam

BEAM = {"bending_stiffness": 6.12e6, "mass": 60.0, "stiffness": 1e7}


@pytest.mark.parametrize(
    ("damping", "speed", "deflection_mm"),
    [
        (0.0, 0.0, 3.997304),
        (0.0, 50.0, 4.016604),
        (0.0, 97.22, 4.071777),
        (4900.0, 97.22, 4.069820),
    ],
)
def test_deflection_under_the_load(damping, speed, deflection_mm):
    beam = WinklerBeam(**BEAM, damping=damping)
    assert beam.deflection(0.0, 1e5, speed) * 1e3 == pytest.approx(deflection_mm, rel=1e-6)


def test_closed_form_of_the_undamped_field():
    speed, stiffness = 97.22, BEAM["stiffness"]
    beam = WinklerBeam(**BEAM)
    assert beam.critical_speed == pytest.approx(510.655, abs=1e-3)
    lam = (stiffness / (4 * BEAM["bending_stiffness"])) ** 0.25
    alpha = speed / beam.critical_speed
    a, b = np.sqrt(1 + alpha**2), np.sqrt(1 - alpha**2)
    r = np.linspace(-8, 8, 161)
    s = lam * np.abs(r)
    expected = 1e5 * lam / (2 * stiffness) * np.exp(-b * s) * (np.cos(a * s) / b + np.sin(a * s) / a)
    np.testing.assert_allclose(beam.deflection(r, 1e5, speed), expected, atol=1e-12)


def test_beyond_the_critical_speed():
    beam = WinklerBeam(**BEAM, damping=4900.0)
    assert beam.deflection(0.0, 1e5, 1.2 * beam.critical_speed) * 1e3 == pytest.approx(0.792413, rel=1e-5)
    with pytest.raises(ValueError, match="below the critical"):
        WinklerBeam(**BEAM).deflection(0.0, 1e5, 600.0)
