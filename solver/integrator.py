"""The time integrator: generalized-alpha with all forces at the end of the step (Wood, Bossak, Zienkiewicz).

    M ((1 - am) a1 + am a0) + C v1 + K u1 = f1

With the predictors ``pu = u0 + dt v0 + (1/2 - beta) dt^2 a0`` and ``pv = v0 + (1 - gamma) dt a0`` the new state is
``a1 = (u1 - pu) / (beta dt^2)`` and ``v1 = pv + gamma dt a1``, so that u1 solves ``A u1 = M p + C q + f1`` with

    A = inertia M + damping C + K,   p = inertia pu - am a0,   q = damping pu - pv.

Second order, unconditionally stable, and the highest frequencies of the mesh lose ``spectral_radius`` per step.
``(1 - am) a1 + am a0`` is the acceleration in equilibrium with v1 and u1, and is the one reported.

References
----------
Chung, Hulbert (1993), J. Appl. Mech. 60(2), 371-375: the case alpha_f = 0.
"""

from typing import NamedTuple


class Integrator(NamedTuple):
    """Coefficients of one step."""

    step: float
    alpha: float
    inertia: float
    damping: float
    acceleration: float
    velocity: float
    drift: float
    kick: float
    retained: float  # p / inertia is pu plus this times (u1 - pu) of the step before
    per_damping: float  # q / damping is pu plus this times pv


def integrator(step: float, spectral_radius: float) -> Integrator:
    """Coefficients for a step (s) and a spectral radius at infinite frequency (0 to 1)."""
    alpha = (spectral_radius - 1) / (spectral_radius + 1)
    gamma = 0.5 - alpha
    beta = (1 - alpha) ** 2 / 4
    acceleration = 1 / (beta * step**2)
    inertia, damping = (1 - alpha) * acceleration, gamma / (beta * step)
    return Integrator(
        step=step,
        alpha=alpha,
        inertia=inertia,
        damping=damping,
        acceleration=acceleration,
        velocity=gamma * step,
        drift=(0.5 - beta) * step**2,
        kick=(1 - gamma) * step,
        retained=-alpha * acceleration / inertia,
        per_damping=-1 / damping,
    )
