"""Wheel-rail contact after Hertz, solved inside the step for the four wheels of a lane together."""

import numpy as np

from solver.arrays import Array
from solver.compiled import compiled

WHEELS = 4
_ITERATIONS = 60
_TOLERANCE = 1e-15  # m; penetrations are near 1e-4


@compiled
def close_contacts(approach: Array, compliance: Array, constant: float, penetration: Array, force: Array) -> bool:
    """Penetrations and forces that agree with the compliances of vehicle and track.

    Newton's method on ``penetration + compliance F(penetration) = approach``; a wheel whose penetration is not
    positive carries nothing.

    Parameters
    ----------
    approach : ndarray, shape (4,)
        Penetrations there would be without contact forces in this step, m.
    compliance : ndarray, shape (4, 4)
        Separation by unit forces, m/N.
    constant : float
        Hertz constant, m/N^(2/3).
    penetration : ndarray, shape (4,)
        First guess in, solution out, m.
    force : ndarray, shape (4,)
        Forces out, N.

    Returns
    -------
    bool
        Whether it converged.
    """
    jacobian = np.empty((WHEELS, WHEELS))
    step = np.empty(WHEELS)
    slope = np.empty(WHEELS)
    for _ in range(_ITERATIONS):
        for j in range(WHEELS):
            root = np.sqrt(max(penetration[j], 0.0) / constant)
            force[j] = root**3
            slope[j] = 1.5 * root / constant
        for i in range(WHEELS):
            step[i] = approach[i] - penetration[i]
            for j in range(WHEELS):
                step[i] -= compliance[i, j] * force[j]
                jacobian[i, j] = compliance[i, j] * slope[j]
            jacobian[i, i] += 1.0
        for i in range(WHEELS):  # elimination; the diagonal dominates, no pivoting
            for row in range(i + 1, WHEELS):
                factor = jacobian[row, i] / jacobian[i, i]
                step[row] -= factor * step[i]
                for j in range(i, WHEELS):
                    jacobian[row, j] -= factor * jacobian[i, j]
        converged = True
        for i in range(WHEELS - 1, -1, -1):
            for j in range(i + 1, WHEELS):
                step[i] -= jacobian[i, j] * step[j]
            step[i] /= jacobian[i, i]
            penetration[i] += step[i]
            converged &= abs(step[i]) <= _TOLERANCE  # false for what is not a number
        if converged:
            for j in range(WHEELS):
                force[j] = np.sqrt(max(penetration[j], 0.0) / constant) ** 3
            return True
    return False
