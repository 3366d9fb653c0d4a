"""Fixed-step integration of many states at once under constant forces, by a Runge-Kutta method on rotations.

Requires NumPy only.
"""

import numpy as np

from ..dynamics.equations import ForwardDynamics
from ..io.arguments import shown
from ..io.array_types import Array, Codes
from ..motion.motion import Motion
from ..motion.rotation import orthonormal, vector_rate
from .state_history import motion_of


def advance(
    plant: ForwardDynamics, state: Motion, F: Array, duration: float, steps: int = 1
) -> tuple[Motion, Codes]:
    """Integrate states (...) with their loads over a duration (s) under constant forces F (N); return status.

    The method is the classical Runge-Kutta method of order 4. Each step represents its rotations as rotation
    vectors relative to the R at its start (Runge-Kutta-Munthe-Kaas), so R remains orthonormal to rounding.
    """
    if steps < 1:
        raise ValueError(f"steps: expected at least 1, got {shown(steps)}")
    h = duration / steps
    first = np.zeros(state.shape, dtype=np.int32)
    # The status reports a state that diverges.
    with np.errstate(over="ignore", invalid="ignore"):
        for _ in range(steps):
            state, status = _step(plant, state, F, h)
            first = np.where(first == 0, status, first)
    return state, first


def _step(plant: ForwardDynamics, start: Motion, F: Array, h: float) -> tuple[Motion, Codes]:
    """Compute a step of h s; states are [t; phi; v; omega], shape (..., 12), with R = exp([phi]x) R_start."""
    first = np.zeros(start.shape, dtype=np.int32)

    def rates(y: Array) -> Array:
        nonlocal first
        state = motion_of(y, start.R, start.F_ext, start.M_ext)
        a, alpha, status = plant.solve(state, F)
        first = np.where(first == 0, status, first)
        return np.concatenate([state.v, vector_rate(y[..., 3:6], state.omega), a, alpha], axis=-1)

    y = np.concatenate([start.t, np.zeros_like(start.t), start.v, start.omega], axis=-1)
    k_1 = rates(y)
    k_2 = rates(y + 0.5 * h * k_1)
    k_3 = rates(y + 0.5 * h * k_2)
    k_4 = rates(y + h * k_3)
    end = motion_of(y + h / 6.0 * (k_1 + 2.0 * (k_2 + k_3) + k_4), start.R)
    R = orthonormal(end.R)
    return Motion._unchecked(R, end.t, end.omega, end.v, F_ext=start.F_ext, M_ext=start.M_ext), first
