"""The rotation vector of one state in plain numbers: exp([phi]x) and the rate of phi, for integrations.

The same formulas as ``rotation_from_vector`` and ``vector_rate``, without NumPy's cost of a call: an
integration evaluates them one state at a time, a dozen times a step.
"""

import math

import numpy as np

from ..io.array_types import Array


def turned(phi: Array, center: Array) -> Array:
    """Return exp([phi]x) R of one rotation vector, rad, (3,), and one rotation, (3, 3)."""
    x, y, z = phi.tolist()
    angle = math.hypot(x, y, z)
    half = 0.5 * angle
    first = math.sin(angle) / angle if angle > 0.0 else 1.0
    second = 0.5 * (math.sin(half) / half) ** 2 if half > 0.0 else 0.5
    a, b, c = second * x * y, second * x * z, second * y * z
    turn = np.array(
        (
            (1.0 - second * (y * y + z * z), a - first * z, b + first * y),
            (a + first * z, 1.0 - second * (x * x + z * z), c - first * x),
            (b - first * y, c + first * x, 1.0 - second * (x * x + y * y)),
        )
    )
    return np.asarray(turn @ center)


def rate(phi: Array, omega: Array) -> tuple[float, float, float]:
    """Return the rate of phi, rad/s, of one state; phi, rad, and omega, rad/s, base axes, (3,)."""
    x, y, z = phi.tolist()
    u, v, w = omega.tolist()
    square = x * x + y * y + z * z
    half = 0.5 * math.sqrt(square)
    if half < 0.025:
        c = (1.0 + square / 60.0 * (1.0 + square / 42.0 * (1.0 + square / 40.0))) / 12.0
    else:
        c = (1.0 - half / math.tan(half)) / square
    i, j, k = y * w - z * v, z * u - x * w, x * v - y * u
    return (
        u - 0.5 * i + c * (y * k - z * j),
        v - 0.5 * j + c * (z * i - x * k),
        w - 0.5 * k + c * (x * j - y * i),
    )
