"""Three infinite layers and the ten-degree-of-freedom vehicle in the frequency domain, linear, pads spread evenly.

A field ``exp(i (omega t + kappa r))`` in the moving frame vibrates at ``omega - V kappa`` for the material. The rail's
receptance follows by a sum over wavenumbers, the contact springs are linearised at the static load, and

    (1/k_H + R_vehicle + R_rail) F = -eta

gives the four contact forces for an irregularity of unit amplitude.
"""

from dataclasses import dataclass

import numpy as np

from solver.arrays import Array
from solver.case import Track, Vehicle

LENGTH = 2048.0  # m after which the sum over wavenumbers repeats
COUNT = 2**17  # wavenumbers: up to pi COUNT / LENGTH = 201 rad/m
GRAVITY = 9.81


@dataclass(frozen=True)
class LayeredTrack:
    """Rail, slab and base with evenly spread pads, seen from a frame at ``speed`` (m/s)."""

    track: Track
    speed: float

    def _layers(self, omega: float) -> tuple[Array, list[Array], list[Array]]:
        """Wavenumbers, diagonal and coupling terms of the (3, 3) dynamic stiffness."""
        t = self.track
        kappa = 2 * np.pi * np.fft.fftfreq(COUNT, LENGTH / COUNT)
        rate = omega - self.speed * kappa
        pad, mortar, roadbed = (
            k + 1j * rate * c
            for k, c in (
                (t.pad_stiffness / t.pad_spacing, t.pad_damping / t.pad_spacing),
                (t.mortar_stiffness, t.mortar_damping),
                (t.roadbed_stiffness, t.roadbed_damping),
            )
        )
        rail = t.rail_elastic_modulus * t.rail_second_moment * kappa**4 - t.rail_mass * rate**2 + pad
        slab = t.slab_elastic_modulus * t.slab_second_moment * kappa**4 - t.slab_mass * rate**2 + pad + mortar
        base = t.base_elastic_modulus * t.base_second_moment * kappa**4 - t.base_mass * rate**2 + mortar + roadbed
        return kappa, [rail, slab, base], [-pad, -mortar]

    def receptances(self, omega: float, distance: Array) -> Array:
        """Displacement of rail, slab and base, shape (3, n), at distances ahead of a unit force on the rail, m/N."""
        kappa, (rail, slab, base), (pad, mortar) = self._layers(omega)
        under_rail = slab - mortar**2 / base
        rail_response = 1 / (rail - pad**2 / under_rail)
        slab_response = -pad * rail_response / under_rail
        responses = np.array([rail_response, slab_response, -mortar * slab_response / base])
        return responses @ np.exp(1j * np.outer(kappa, distance)) / LENGTH

    def static_deflection(self, forces: Array, positions: Array, at: float) -> Array:
        """Rail, slab and base displacement (3,) at one position under steady forces (N) elsewhere, m."""
        return self.receptances(0.0, at - positions).real @ forces


def wheel_receptance(vehicle: Vehicle, omega: float) -> Array:
    """Displacement of the four wheelsets, (4, 4), for unit forces on them, m/N; half a car, front wheelset first."""
    v = vehicle
    a, b = v.half_bogie_distance, v.half_wheelbase
    masses = [v.car_body_mass, v.car_body_pitch_inertia] + 2 * [v.bogie_mass, v.bogie_pitch_inertia]
    dynamic: Array = np.diag(np.array(masses + 4 * [v.wheelset_mass], complex)) * -(omega**2)
    primary, secondary = (
        v.primary_stiffness + 1j * omega * v.primary_damping,
        v.secondary_stiffness + 1j * omega * v.secondary_damping,
    )
    #        z_c t_c z_1 t_1 z_2 t_2 wheelsets
    links = [
        (secondary, [1, a, -1, 0, 0, 0, 0, 0, 0, 0]),
        (secondary, [1, -a, 0, 0, -1, 0, 0, 0, 0, 0]),
        (primary, [0, 0, 1, b, 0, 0, -1, 0, 0, 0]),
        (primary, [0, 0, 1, -b, 0, 0, 0, -1, 0, 0]),
        (primary, [0, 0, 0, 0, 1, b, 0, 0, -1, 0]),
        (primary, [0, 0, 0, 0, 1, -b, 0, 0, 0, -1]),
    ]
    for constant, stretch in links:
        dynamic += constant * np.outer(stretch, stretch)
    return np.linalg.inv(dynamic / 2)[6:, 6:]


def contact_spring(vehicle: Vehicle) -> float:
    """Hertz stiffness at the static wheel load, N/m."""
    weight = (v := vehicle).car_body_mass + 2 * v.bogie_mass + 4 * v.wheelset_mass
    static = weight * GRAVITY / 8
    worn = 3.86e-8 * v.wheel_radius**-0.115
    conical = 4.57e-8 * v.wheel_radius**-0.149
    return float(1.5 * static ** (1 / 3) / (worn if v.wheel_tread == "worn" else conical))


def contact_force(track: Track, vehicle: Vehicle, speed: float, wavelength: float) -> Array:
    """Amplitudes of the four contact forces (N/m) per amplitude of a harmonic irregularity, front wheel first."""
    a, b = vehicle.half_bogie_distance, vehicle.half_wheelbase
    position = np.array([a + b, a - b, b - a, -a - b])
    omega = 2 * np.pi * speed / wavelength
    distance = position[:, None] - position
    rail = LayeredTrack(track, speed).receptances(omega, distance.ravel())[0].reshape(4, 4)
    flexibility = np.eye(4) / contact_spring(vehicle) + wheel_receptance(vehicle, omega) + rail
    eta = np.exp(2j * np.pi * (position - position[0]) / wavelength)
    return -np.linalg.solve(flexibility, eta)
