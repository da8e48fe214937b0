import math
from dataclasses import replace

import pytest

from solver.case import Dip, Harmonic, Measured, Smooth, Spectral, Sum
from solver.quantity import InvalidParameterError
from solver.spectrum import Table

POSITIONS = tuple(0.5 * n for n in range(101))
PROFILE = Measured(positions=POSITIONS, heights=(1e-3,) * 101, wavelength_min=2.0, wavelength_max=30.0)
SPECTRAL = Spectral(wavelength_min=2.0, wavelength_max=30.0)
TABLE = Table(per="1/m", sides=1, frequencies=(1 / 30, 1 / 2), densities=(1e-6, 1e-8))
DIP = Dip(position=0.0, length=1.0, depth=1e-3)


def without(n, values, value):
    return (*values[:n], value, *values[n + 1 :])


@pytest.mark.parametrize(
    ("irregularity", "parts", "parameter"),
    [
        (SPECTRAL, {"wavelength_min": 30.0, "wavelength_max": 2.0}, "wavelength_band_m"),
        (SPECTRAL, {"spectrum": TABLE, "wavelength_max": 31.0}, "wavelength_band_m"),
        (SPECTRAL, {"spectrum": replace(TABLE, per="rad/m")}, "wavelength_band_m"),
        (PROFILE, {"wavelength_min": 30.0, "wavelength_max": 2.0}, "wavelength_band_m"),
        (PROFILE, {"wavelength_max": 50.1}, "wavelength_band_m"),
        (PROFILE, {"wavelength_min": 0.9}, "positions_m.1"),
        (PROFILE, {"positions": POSITIONS[:15], "heights": (0.0,) * 15}, "positions_m"),
        (PROFILE, {"positions": without(3, POSITIONS, 1.0)}, "positions_m.3"),
        (PROFILE, {"positions": without(3, POSITIONS, math.nan)}, "positions_m.3"),
        (PROFILE, {"positions": POSITIONS * 2000}, "positions_m"),
        (PROFILE, {"heights": (0.0,) * 100}, "heights_m"),
        (PROFILE, {"heights": without(7, PROFILE.heights, math.inf)}, "heights_m.7"),
        (PROFILE, {"heights": without(7, PROFILE.heights, 0.3)}, "heights_m.7"),
        (PROFILE, {"heights": without(7, PROFILE.heights, "0")}, "heights_m.7"),
        (Sum(terms=(DIP,)), {"terms": ()}, "terms"),
        (Sum(terms=(DIP,)), {"terms": (DIP,) * 11}, "terms"),
        (Sum(terms=(DIP,)), {"terms": (Sum(terms=(DIP,)),)}, "terms"),
        (Sum(terms=(DIP,)), {"terms": (SPECTRAL, DIP, replace(SPECTRAL, wavelength_max=20.0))}, "terms.2.seed"),
    ],
)
def test_what_is_wrong_is_refused_by_name(irregularity, parts, parameter):
    with pytest.raises(InvalidParameterError) as caught:
        replace(irregularity, **parts)
    assert caught.value.parameter == f"irregularity.{parameter}"


def test_spectra_may_share_a_seed_where_their_bands_do_not_overlap():
    long = replace(SPECTRAL, wavelength_min=30.0, wavelength_max=200.0)
    assert len(Sum(terms=(SPECTRAL, long, replace(SPECTRAL, seed=2), replace(SPECTRAL, realisation=1))).terms) == 4


def test_the_shortest_wavelength_is_that_of_the_shortest_term():
    terms = (Smooth(), SPECTRAL, PROFILE, DIP, Harmonic(wavelength=1.5, amplitude=1e-4))
    assert [term.shortest_wavelength for term in terms] == [math.inf, 2.0, 2.0, 1.0, 1.5]
    assert Sum(terms=terms).shortest_wavelength == 1.0
