"""An infinite beam on a Winkler foundation under a constant moving force, in closed form.

    EI w'''' + m V^2 w'' - c V w' + k w = P delta(r),   r = x - V t

The roots of the characteristic polynomial with negative real part make the field ahead of the load, the others the
field behind it. This covers damped beams and loads faster than the critical speed.

References
----------
Frýba (1999), Vibration of Solids and Structures under Moving Loads, chapter 13.
"""

from dataclasses import dataclass

import numpy as np

from solver.arrays import Array


@dataclass(frozen=True, kw_only=True)
class WinklerBeam:
    """Bending stiffness N m^2, mass kg/m, foundation stiffness N/m^2 and damping N s/m^2."""

    bending_stiffness: float
    mass: float
    stiffness: float
    damping: float = 0.0

    @property
    def critical_speed(self) -> float:
        """Lowest phase velocity of the undamped beam, m/s."""
        return float((4 * self.stiffness * self.bending_stiffness / self.mass**2) ** 0.25)

    def deflection(self, position: float | Array, force: float, speed: float) -> Array:
        """Displacement, m, at positions ahead of the load (m; behind it negative), force in N and speed in m/s.

        Raises
        ------
        ValueError
            At or above the critical speed without damping, where no steady state exists.
        """
        if self.damping == 0 and speed >= self.critical_speed:
            raise ValueError(f"speed must be below the critical {self.critical_speed:g} m/s without damping")
        polynomial = [self.bending_stiffness, 0, self.mass * speed**2, -self.damping * speed, self.stiffness]
        roots = np.roots(polynomial)
        r = np.asarray(position, float)
        field = np.zeros(r.shape, complex)
        for i, root in enumerate(roots):
            residue = 1 / np.prod(root - np.delete(roots, i))
            there = (r >= 0) if root.real < 0 else (r < 0)
            field += np.sign(-root.real) * residue * np.exp(root * np.where(there, r, 0)) * there
        return force / self.bending_stiffness * field.real
