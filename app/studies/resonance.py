"""The frequency at which an unsprung wheel bounces on the track (P2)."""

import math
from functools import lru_cache

from solver.case import Track, Vehicle
from solver.wheel import hertz_constant, hertz_stiffness, static_wheel_load

LOWEST, HIGHEST, FREQUENCIES = 20.0, 160.0, 70  # Hz, in equal ratios
WAVENUMBERS = 240
LARGEST_WAVENUMBER = 12.0  # rad/m; beyond, nothing of a rail bends at these frequencies


@lru_cache(maxsize=256)
def p2_hz(track: Track, vehicle: Vehicle) -> float:
    """Where the contact force over a small wave is largest, in linear theory, on a continuous track at rest.

    The force is the wave over the sum of three receptances: of the track at its load, of half a wheelset under a bogie
    at rest, and of the contact as a spring under the static load.
    """
    contact = hertz_stiffness(hertz_constant(vehicle), static_wheel_load(vehicle))
    ratio = (HIGHEST / LOWEST) ** (1 / (FREQUENCIES - 1))

    def softness(hz: float) -> float:
        omega = 2 * math.pi * hz
        suspension = complex(vehicle.primary_stiffness, vehicle.primary_damping * omega)
        return abs(_receptance(track, omega) + 2 / (suspension - vehicle.wheelset_mass * omega**2) + 1 / contact)

    return min((LOWEST * ratio**n for n in range(FREQUENCIES)), key=softness)


def _receptance(t: Track, omega: float) -> complex:
    """Deflection of the rail under a harmonic unit force: three beams one on the other, the pads smeared.

    The integral over wavenumbers, by the trapezoidal rule; near zero the integrand is smooth and even.
    """
    pad = complex(t.pad_stiffness, omega * t.pad_damping) / t.pad_spacing
    mortar = complex(t.mortar_stiffness, omega * t.mortar_damping)
    roadbed = complex(t.roadbed_stiffness, omega * t.roadbed_damping)
    step = LARGEST_WAVENUMBER / WAVENUMBERS
    total: complex = 0j
    for n in range(WAVENUMBERS):
        k4 = (n * step) ** 4
        base = t.base_elastic_modulus * t.base_second_moment * k4 - t.base_mass * omega**2 + mortar + roadbed
        slab = t.slab_elastic_modulus * t.slab_second_moment * k4 - t.slab_mass * omega**2 + pad + mortar
        rail = t.rail_elastic_modulus * t.rail_second_moment * k4 - t.rail_mass * omega**2 + pad
        total += (1.0 if n else 0.5) / (rail - pad**2 / (slab - mortar**2 / base))
    return total * step / math.pi
