import numpy as np
import pytest

from solver.integrator import Integrator, integrator

OMEGA, ZETA = 7.0, 0.03


def march(k: Integrator, steps: int) -> np.ndarray:
    """A damped oscillator released at one: displacement, velocity and reported acceleration at the end."""
    mass, damping, stiffness = 1.0, 2 * ZETA * OMEGA, OMEGA**2
    u, v, a = 1.0, 0.0, -stiffness
    reported = a
    for _ in range(steps):
        pu, pv = u + k.step * v + k.drift * a, v + k.kick * a
        p, q = k.inertia * pu - k.alpha * a, k.damping * pu - pv
        u = (mass * p + damping * q) / (k.inertia * mass + k.damping * damping + stiffness)
        new = k.acceleration * (u - pu)
        v = pv + k.velocity * new
        reported, a = (1 - k.alpha) * new + k.alpha * a, new
    return np.array([u, v, reported])


def exact(time: float) -> np.ndarray:
    decay = -ZETA * OMEGA + 1j * OMEGA * np.sqrt(1 - ZETA**2)
    weight = 1 + 1j * decay.real / decay.imag
    return np.array([(weight * decay**n * np.exp(decay * time)).real for n in (0, 1, 2)])


@pytest.mark.parametrize("radius", [0.0, 0.5, 0.8, 1.0])
def test_second_order_in_displacement_velocity_and_acceleration(radius):
    counts = np.array([200, 400, 800])
    errors = np.array([np.abs(march(integrator(2.0 / n, radius), n) - exact(2.0)) for n in counts])
    slopes = -np.log2(errors[1:] / errors[:-1])
    assert (slopes > 1.9).all(), slopes


@pytest.mark.parametrize("radius", [0.0, 0.5, 0.8, 1.0])
def test_spectral_radius_at_high_frequency(radius):
    k = integrator(1.0, radius)
    stiffness = 1e10

    def step(u, v, a):
        pu, pv = u + k.step * v + k.drift * a, v + k.kick * a
        u = (k.inertia * pu - k.alpha * a) / (k.inertia + stiffness)
        new = k.acceleration * (u - pu)
        return u, pv + k.velocity * new, new

    amplification = np.array([step(*column) for column in np.eye(3)]).T
    # Displacements scale with 1/stiffness: balance before taking eigenvalues.
    assert np.abs(np.linalg.eigvals(amplification)).max() == pytest.approx(radius, abs=2e-3)
