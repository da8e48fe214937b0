import json
import math
from dataclasses import fields, replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from solver.case import Case, Dip, Harmonic, Joint, Measured, Numerics, Smooth, Spectral, Sum, Track, Vehicle
from solver.catalogue import TRACKS, VEHICLES
from solver.quantity import InvalidParameterError, quantities
from solver.spectrum import PowerLaw, Rational, Table

BAND = {"wavelength_min": 2.0, "wavelength_max": 30.0}
OWN_SPECTRA = [
    PowerLaw(per="1/m", sides=1, coefficients=(1e-8, 2e-8), exponents=(2, 3), breaks=(0.1,)),
    PowerLaw(per="rad/m", sides=2, coefficients=(1e-8,), exponents=(2,), wavelength_range=(1, 100)),
    Rational(per="rad/m", sides=2, roughness=4e-7, cutoff=0.8, lower_cutoff=0.02),
    Table(per="1/m", sides=1, frequencies=(0.01, 0.1, 1), densities=(1e-4, 1e-6, 1e-9)),
]
IRREGULARITIES = [
    Smooth(),
    Harmonic(wavelength=1.0, amplitude=3e-4),
    Spectral(**BAND),
    *(Spectral(**BAND, spectrum=spectrum) for spectrum in OWN_SPECTRA),
    Measured(**BAND, positions=tuple(range(41)), heights=(0, 1e-3, 0, -1e-3) * 10 + (0,)),
    Dip(position=10, length=1, depth=5e-4),
    Sum(terms=(Dip(position=10.0, length=1.0, depth=5e-4), Spectral(**BAND, spectrum=OWN_SPECTRA[0]))),
]
# Digests are the identity of cases that are stored: they must not change while the meaning stays.
DIGESTS = {
    Smooth(): "6054e13b321ad0c0ada38d577a0b4fe176f3959cc3f609b2a6a0f6b95b33a024",
    Harmonic(wavelength=1.0, amplitude=3e-4): "5e2c4889ceb3cd6b4cb6e1d052c04a00d1c823f72a72f8bb30979b03584fe150",
    Spectral(**BAND): "6a841d934a14c50640721cb70a7d114bd7c89f6ec46530f711c7a42dfc67125a",
}


@pytest.mark.parametrize("irregularity", IRREGULARITIES)
def test_a_case_survives_json(make_case, irregularity):
    case = make_case(irregularity=irregularity)
    again = Case.from_dict(json.loads(json.dumps(case.to_dict())))
    assert again == case
    assert again.digest() == case.digest()


def test_equal_physics_has_one_digest_and_different_physics_another(make_case):
    case = make_case(speed=50.0)
    assert case.digest() == make_case(speed=50).digest()
    digests = {make_case(irregularity=i).digest() for i in IRREGULARITIES}
    digests |= {make_case(track=replace(case.track, pad_stiffness=4e7)).digest(), case.digest()}
    assert len(digests) == len(IRREGULARITIES) + 2


@pytest.mark.parametrize("irregularity", DIGESTS, ids=lambda irregularity: type(irregularity).__name__)
def test_cases_keep_their_digests(irregularity):
    track, vehicle = TRACKS["crts2"].values, VEHICLES["crh3"].values
    case = Case(speed=300 / 3.6, irregularity=irregularity, track=track, vehicle=vehicle)
    assert case.digest() == DIGESTS[irregularity]


def test_the_convention_of_a_spectrum_is_part_of_the_digest(make_case):
    one = OWN_SPECTRA[0]
    spectra = [one, replace(one, sides=2), replace(one, per="rad/m"), replace(one, exponents=(2, 3.1))]
    assert len({make_case(irregularity=Spectral(**BAND, spectrum=s)).digest() for s in spectra}) == len(spectra)


def test_joints_count_only_where_there_are_any(make_case):
    case = make_case()
    without_shear = replace(case.track, joint=Joint(shear_stiffness=0.0))
    assert make_case(track=without_shear).digest() == case.digest()
    longer = {"slab": "discontinuous", "numerics": Numerics()}
    discontinuous = make_case(**longer)
    assert make_case(track=without_shear, **longer).digest() != discontinuous.digest() != case.digest()


def test_operator_key_is_shared_by_what_can_march_together(make_case):
    case = make_case()
    stiffer = replace(case.vehicle, primary_stiffness=3e6)
    assert {make_case(irregularity=i).operator_key() for i in IRREGULARITIES} == {case.operator_key()}
    assert make_case(vehicle=stiffer).operator_key() == case.operator_key()
    for other in ({"speed": 80.0}, {"numerics": Numerics()}, {"track": replace(case.track, pad_damping=1e4)}):
        assert make_case(**other).operator_key() != case.operator_key()


PHYSICAL = [
    (values, name, path, q)
    for values in (
        VEHICLES["crh3"].values,
        TRACKS["crts2"].values,
        Numerics(),
        *(each for each in IRREGULARITIES if isinstance(each, Harmonic | Spectral | Measured | Dip)),
    )
    for name, path, q in quantities(type(values))
]


@pytest.mark.parametrize(("values", "name", "path", "q"), PHYSICAL, ids=lambda v: v if isinstance(v, str) else "")
def test_every_bound_is_kept_and_named(values, name, path, q):
    beyond = [math.nan, math.inf, -math.inf, True, "300"]
    beyond += [bound - 1 for key, bound in q.bounds().items() if key in ("ge", "gt")]
    beyond += [bound * 2 + 1 for key, bound in q.bounds().items() if key in ("le", "lt")]
    for value in beyond:
        with pytest.raises(InvalidParameterError, match=r"must be") as caught:
            replace(values, **{name: value})
        assert caught.value.parameter.endswith(path)


def test_every_number_of_the_model_has_bounds_on_both_sides():
    for cls in (Vehicle, Track, Numerics, Harmonic, Spectral, Measured, Dip, Case):
        for name, _, q in quantities(cls):
            assert {"ge", "gt"} & q.bounds().keys(), name
            assert {"le", "lt"} & q.bounds().keys(), name
        numeric = {f.name for f in fields(cls) if f.type in (int, float)}
        assert numeric == {name for name, _, _ in quantities(cls)}


@pytest.mark.parametrize(
    ("parts", "parameter"),
    [
        ({"speed": -1.0}, "speed_m_per_s"),
        ({"speed": 601 / 3.6}, "speed_m_per_s"),
        ({"slab": "floating"}, "slab"),
        ({"numerics": Numerics(track_length=90.0, absorbing_length=40.0)}, "numerics.track_length_m"),
        (
            {"slab": "discontinuous", "track": replace(TRACKS["crts2"].values, pad_spacing=1.2)},
            "numerics.track_length_m",
        ),
        ({"numerics": Numerics(time_step=1e-6)}, "numerics.time_step_s"),
        ({"numerics": Numerics(elements_per_pad=2), "slab": "discontinuous"}, "numerics.elements_per_pad"),
        (
            {"numerics": Numerics(joint_blending=0.5, elements_per_pad=11), "slab": "discontinuous"},
            "numerics.elements_per_pad",
        ),
        (
            {"irregularity": Harmonic(wavelength=0.15, amplitude=1e-4), "numerics": Numerics(elements_per_pad=2)},
            "numerics.elements_per_pad",
        ),
        ({"numerics": Numerics(time_step=1e-3), "speed": 100.0}, "numerics.time_step_s"),
        (
            {"irregularity": Harmonic(wavelength=0.1, amplitude=1e-4), "numerics": Numerics(time_step=2e-4)},
            "numerics.time_step_s",
        ),
    ],
)
def test_what_does_not_fit_together_is_refused_by_name(make_case, parts, parameter):
    with pytest.raises(InvalidParameterError) as caught:
        make_case(**parts)
    assert caught.value.parameter == parameter


@given(st.floats(10 / 3.6, 600 / 3.6), st.floats(1e-5, 2e-4))
def test_a_whole_number_of_steps_leads_from_pad_to_pad(speed, time_step):
    assume(0.65 / (speed * time_step) < 1999)  # more steps from pad to pad are refused
    case = Case(
        speed=speed,
        irregularity=Smooth(),
        track=TRACKS["crts2"].values,
        vehicle=VEHICLES["crh3"].values,
        numerics=Numerics(time_step=time_step),
    )
    assert case.time_step <= time_step * (1 + 1e-9)
    assert case.time_step * case.phases * case.speed == pytest.approx(0.65, rel=1e-12)


def test_a_measured_profile_may_be_named_by_its_digest(make_case):
    measured = Measured(**BAND, positions=tuple(range(41)), heights=(0, 1e-3, 0, -1e-3) * 10 + (0,))
    shelf = {measured.profile: (measured.positions, measured.heights)}
    for irregularity in (measured, Sum(terms=(Dip(position=10.0, length=1.0, depth=5e-4), measured))):
        case = make_case(irregularity=irregularity)
        written = json.dumps(case.to_dict(samples=False))
        assert "positions" not in written
        again = Case.from_dict(json.loads(written), shelf.__getitem__)
        assert (again, again.digest()) == (case, case.digest())
    assert replace(measured, heights=(1e-3, *measured.heights[1:])).profile != measured.profile
