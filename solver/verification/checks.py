"""All checks, in the order of the report. Those marked quick run with the tests."""

from functools import partial

from solver.verification import closed_form, convergence, energy, frequency_domain, invariance, track_fixed
from solver.verification.finding import Check
from solver.verification.problems import RANDOM, SINE

_TRACK_FIXED = (
    "Finite elements that stay with the track, nodes at every pad, two slab nodes at every joint, wheels that roll "
    "from element to element; its own matrices, integrator and contact. "
)
_SINE = "Sine of 1 m, conical tread, 200 m of track, over the 13 m in which pads, joints and sine repeat. "
_RANDOM = "TB/T 3352, 2 to 30 m, conical tread, over 13 m; 24 elements between pads and steps of 50 µs in both models. "


def _power(value: float) -> str:
    return f"{value:.0e}".replace("e+0", "e")


def _fixed_sine(speed: float, stiffness: float, amplitude: float = 3e-4, pad: float = 6e7) -> Check:
    return Check(
        title=f"Track-fixed model, sine: {speed:g} km/h, joints {_power(stiffness)} N/m, pads {_power(pad)} N/m",
        how=f"{_TRACK_FIXED}{_SINE}Amplitude {amplitude * 1e3:g} mm.",
        run=partial(track_fixed.harmonic, speed, stiffness, amplitude, pad),
    )


def _fixed_random(speed: float, stiffness: float, percentile: float = 63.2, pad: float = 6e7) -> Check:
    return Check(
        title=f"Track-fixed model, random: {speed:g} km/h, joints {_power(stiffness)} N/m, pads {_power(pad)} N/m",
        how=f"{_TRACK_FIXED}{_RANDOM}Percentile {percentile:g} %.",
        run=partial(track_fixed.random, speed, stiffness, percentile, pad),
    )


CHECKS: tuple[Check, ...] = (
    Check(
        title="Moving force on a beam on an elastic foundation",
        how="Closed form. Pads 25 mm apart on a slab that cannot move; below the critical speed, and 1.2 times it.",
        run=closed_form.winkler,
        quick=True,
    ),
    Check(
        title="At rest",
        how="The static deflection of three infinite layers, by a sum over wavenumbers, with pads evenly spread.",
        run=closed_form.at_rest,
        quick=True,
    ),
    Check(
        title="A creeping train",
        how="At 10 km/h on a smooth rail forces equal the weight and the rail sinks as it does at rest.",
        run=closed_form.creeping,
        quick=True,
    ),
    Check(
        title="Pinned-pinned frequency",
        how="The rail's receptance half-way between two pads peaks at (π/2) √(EI/m) / L².",
        run=closed_form.pinned_pinned,
    ),
    Check(
        title="Sine, frequency domain (one speed)",
        how="Three infinite layers, all ten degrees of freedom, linearised contact.",
        run=partial(frequency_domain.harmonic, (350.0,)),
        quick=True,
    ),
    Check(
        title="Sine, frequency domain",
        how="Three infinite layers, all ten degrees of freedom, linearised contact. The P2 resonance is crossed "
        "between 200 and 250 km/h, and the wheel lifts off.",
        run=partial(frequency_domain.harmonic, (160.0, 200.0, 250.0, 300.0, 350.0)),
    ),
    Check(
        title="Random, frequency domain",
        how="200 realisations of TB/T 3352, 63.2 %, 2 to 30 m, 350 km/h, at a ten-thousandth of their height. The "
        "tolerance is three standard errors of the mean variance.",
        run=partial(frequency_domain.random, 200, 2.0),
    ),
    Check(
        title="Percentiles",
        how="Twice the height at a millionth of the spectrum gives twice the dynamic response.",
        run=frequency_domain.percentiles,
        quick=True,
    ),
    Check(
        title="Track-fixed model, half the elements",
        how=f"{_TRACK_FIXED}Sine of 1 m, 350 km/h, joints of 1e8 N/m.",
        run=track_fixed.quick,
        quick=True,
    ),
    Check(
        title="Track-fixed model, continuous slab",
        how=f"{_TRACK_FIXED}Sine of 1 m, 350 km/h.",
        run=partial(track_fixed.continuous, 350.0),
    ),
    _fixed_sine(160, 1e8),
    _fixed_sine(200, 1e6, 2e-4),
    _fixed_sine(200, 1e8, 2e-4, pad=1e8),
    _fixed_sine(250, 1e7, 2e-4),
    _fixed_sine(300, 1e9),
    _fixed_sine(350, 1e8),
    _fixed_sine(350, 1e6, pad=3e7),
    _fixed_random(250, 1e9),
    _fixed_random(300, 1e8, pad=3e7),
    _fixed_random(350, 1e8),
    _fixed_random(350, 1e7, 90.0),
    Check(
        title="Free and hinged joints",
        how="Without shear transfer joints are free ends, with rigid transfer hinges, which are no continuous slab.",
        run=track_fixed.free_and_hinged,
    ),
    Check(
        title="Where the mesh lies",
        how="The mesh shifted by parts of an element: nothing but its error may change.",
        run=invariance.mesh,
    ),
    Check(
        title="Where the mesh lies, 24 elements and steps of 50 µs",
        how="The same with half the length of element and half the step.",
        run=partial(invariance.mesh, elements_per_pad=24, time_step=5e-5),
    ),
    Check(
        title="Where the run starts",
        how="Pads, joints and irregularity shifted alike by part of a pad spacing, observed at the same place.",
        run=invariance.track,
    ),
    Check(
        title="Which way round the vehicle is",
        how="A symmetric vehicle running backwards.",
        run=invariance.backwards,
        quick=True,
    ),
    Check(
        title="Energy",
        how="Work of the engine that keeps the speed against heat in all dampers, what the ends absorb and what is "
        "stored, by Gauss points over the fields.",
        run=energy.balance,
    ),
    Check(
        title="Energy, half the elements",
        how="The same over a shorter time.",
        run=partial(energy.balance, elements_per_pad=6, track_length=100.0, settle=0.3, window=0.03),
        quick=True,
    ),
    Check(
        title="Energy without damping",
        how="Spectral radius 1, no damper anywhere: the engine's work is stored or leaves through the ends.",
        run=energy.without_damping,
    ),
    Check(
        title="Order in the length of an element",
        how="A load inside an element: the error of its own deflection is of third order.",
        run=convergence.element_length,
        quick=True,
    ),
    Check(
        title="Order in the time step",
        how="The integrator is of second order.",
        run=partial(convergence.time_step, 5),
    ),
    Check(
        title="Order in the time step, three halvings",
        how="The integrator is of second order.",
        run=partial(convergence.time_step, 3),
        quick=True,
    ),
    Check(
        title="Mesh, step and integrator, sine",
        how="Peaks of a jointed case at 350 km/h with other numerics beside those with the default ones.",
        run=partial(convergence.numerics, SINE, 0.01),
    ),
    Check(
        title="Mesh, step and integrator, random",
        how="Peaks of a jointed case at 350 km/h with other numerics beside those with the default ones.",
        run=partial(convergence.numerics, RANDOM, 0.015),
    ),
    Check(
        title="Joint blending",
        how="The distance over which the shape functions of a joint fade, random irregularity at 350 km/h.",
        run=convergence.blending,
    ),
    Check(
        title="Length of the track",
        how="A thousandth where the slab is continuous. Joints scatter waves over long distances; 140 m cut their row.",
        run=convergence.track_length,
    ),
)
